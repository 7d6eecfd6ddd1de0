// Thorax over footholds: joints, collisions, margins.
#include "hexpiderix/stance/stance.hpp"

#include <cmath>

#include "contact/nesm.hpp"
#include "hexpiderix/stance/bodies.hpp"

namespace foothold::hexpiderix {
namespace {

// Joints of all legs, or the first that does not reach.
bool place_legs(const Model& model, const Footholds& footholds, const Isometry3d& thorax, Evaluation& out) {
  const Isometry3d to_thorax = thorax.inverse();
  for (std::size_t leg = 0; leg < kLegs; ++leg) {
    if (!footholds.supports[leg]) continue;
    const auto joints = reach(model, leg, to_thorax * footholds.points[leg]);
    if (!joints) {
      out.fault = Evaluation::Fault::kReach;
      out.leg = leg;
      return false;
    }
    out.at.legs[leg] = *joints;
  }
  return true;
}

// The joints of a swing leg whose foot hangs `lift` above its place, or that much higher as the ground demands. The ground is a
// plane, so a foot's height above it grows linearly with the lift.
std::optional<Vector3d> swing_leg(const Model& model, const Plane& ground, const Isometry3d& thorax, std::size_t leg,
                                  const Swing& swing, double clearance) {
  double lift = swing.lift;
  if (swing.raise) {
    const Vector3d low = thorax * (standing_foot(model, leg) + lift * Vector3d::UnitZ());
    const double missing = clearance - ground.above(low);
    const double gain = ground.normal.dot(thorax.linear().col(2));  // of height above the ground for each metre of lift
    if (missing > 0.0) {
      if (gain <= 0.0) return std::nullopt;
      lift += missing / gain;
    }
  }
  return reach(model, leg, standing_foot(model, leg) + lift * Vector3d::UnitZ());
}

}  // namespace

Plane tilted_plane(double slope, double direction) {
  return {Vector3d::Zero(), {std::sin(slope) * std::cos(direction), std::sin(slope) * std::sin(direction), std::cos(slope)}};
}

Eigen::Matrix3d axes_along(const Vector3d& up, const Vector3d& ahead) {
  const Vector3d y = up.cross(ahead).normalized();
  Eigen::Matrix3d axes;
  axes << y.cross(up), y, up;
  return axes;
}

contact::SupportPolygon polygon_of(const Footholds& footholds, Legs legs) {
  std::array<Vector3d, kLegs> feet;
  std::size_t count = 0;
  for (std::size_t leg = 0; leg < kLegs; ++leg)
    if (legs[leg]) feet[count++] = footholds.points[leg];
  return contact::support_polygon({feet.data(), count});
}

Isometry3d standing_thorax(const Model& model, const Plane& plane, const Vector3d& centre, double heading) {
  Isometry3d pose = Isometry3d::Identity();
  const Vector3d ahead(std::cos(heading), std::sin(heading), 0.0);
  pose.linear() = axes_along(plane.normal, ahead);
  pose.translation() = centre - plane.above(centre) * plane.normal + model.height() * plane.normal;
  return pose;
}

Footholds standing_footholds(const Model& model, const Plane& plane, const Vector3d& centre, double heading, Legs supports) {
  const Isometry3d thorax = standing_thorax(model, plane, centre, heading);
  Footholds out{supports, {}, {}};
  for (std::size_t leg = 0; leg < kLegs; ++leg) {
    out.points[leg] = thorax * standing_foot(model, leg);
    out.normals[leg] = plane.normal;
  }
  return out;
}

Evaluation evaluate(const Model& model, const Plane& ground, const Footholds& footholds, const Isometry3d& thorax,
                    const Swing& swing, double clearance) {
  Evaluation out;
  out.at.thorax = thorax;
  if (!place_legs(model, footholds, thorax, out)) return out;
  for (std::size_t leg = 0; leg < kLegs; ++leg) {
    if (footholds.supports[leg]) continue;
    const auto joints = swing_leg(model, ground, thorax, leg, swing, clearance);
    if (!joints) {
      out.fault = Evaluation::Fault::kReach;
      out.leg = leg;
      return out;
    }
    out.at.legs[leg] = *joints;
  }
  const Contacting near = nearest_trouble(model, out.at, ground, footholds.supports, clearance);
  out.fault = near.fault;
  out.leg = near.leg;
  out.other = near.other;
  out.figure = near.distance;
  if (!out.valid()) return out;
  const Evaluation stability = stability_of(model, footholds, out.at);
  out.centre_of_mass = stability.centre_of_mass;
  out.nesm = stability.nesm;
  out.margin = stability.margin;
  return out;
}

Evaluation stability_of(const Model& model, const Footholds& footholds, const Coordinates& at) {
  Evaluation out;
  out.fault = Evaluation::Fault::kNone;
  out.at = at;
  out.centre_of_mass = at.thorax * centre_of_mass(model, at.legs);
  const contact::SupportPolygon polygon = polygon_of(footholds, footholds.supports);
  out.nesm = contact::nesm(polygon, out.centre_of_mass).value;
  out.margin = contact::projected_margin(polygon, out.centre_of_mass);
  return out;
}

}  // namespace foothold::hexpiderix
