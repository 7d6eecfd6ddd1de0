// Closed forms of thorax and legs.
#include "hexpiderix/model/body.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace foothold::hexpiderix {
namespace {

// From a leg's coxa frame to the thorax': X outwards.
struct Mount {
  double cosine, sine;
  Vector3d out(const Vector3d& v) const { return {cosine * v.x() - sine * v.y(), sine * v.x() + cosine * v.y(), v.z()}; }
  Vector3d back(const Vector3d& v) const { return {cosine * v.x() + sine * v.y(), cosine * v.y() - sine * v.x(), v.z()}; }
};

constexpr double kHalf = 0.5, kRoot = std::numbers::sqrt3 / 2.0;
constexpr std::array<Mount, kLegs> kMounts{{{1, 0}, {kHalf, kRoot}, {-kHalf, kRoot}, {-1, 0}, {-kHalf, -kRoot}, {kHalf, -kRoot}}};

Isometry3d between(const Vector3d& a, const Vector3d& b) {
  Isometry3d pose = Isometry3d::Identity();
  pose.translation() = 0.5 * (a + b);
  pose.linear() = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), b - a).toRotationMatrix();
  return pose;
}

}  // namespace

LegPoints leg_points(const Model& model, std::size_t leg, const Vector3d& joints) {
  const Mount& mount = kMounts[leg];
  const Vector3d coxa = mount.out({model.thorax_radius, 0, 0});
  const kinematics::YawLeg::Points points = model.leg.forward(joints);
  return {coxa, coxa + mount.out(points.hip), coxa + mount.out(points.knee), coxa + mount.out(points.foot)};
}

Vector3d ankle_of(const Model& model, const LegPoints& points) {
  return points.foot + model.toe / model.leg.tibia * (points.knee - points.foot);
}

Vector3d standing_joints() { return {0, 0, -std::numbers::pi / 2}; }

Vector3d standing_foot(const Model& model, std::size_t leg) {
  return kMounts[leg].out({model.thorax_radius + model.leg.coxa + model.leg.femur, 0, -model.height()});
}

Vector3d swinging_joints(const Model& model, std::size_t leg, double lift) {
  const auto joints = reach(model, leg, standing_foot(model, leg) + lift * Vector3d::UnitZ());
  if (!joints) throw std::logic_error("no swing leg can be lifted by " + std::to_string(lift) + " m");
  return *joints;
}

bool within_limits(const Model& model, const Vector3d& joints) {
  constexpr double kRounding = 1e-12;
  for (int j = 0; j < 3; ++j)
    if (!model.limits[static_cast<std::size_t>(j)].holds(joints[j], kRounding)) return false;
  return true;
}

std::optional<Vector3d> reach(const Model& model, std::size_t leg, const Vector3d& foot) {
  const Vector3d local = kMounts[leg].back(foot) - Vector3d(model.thorax_radius, 0, 0);
  // Nearly always the first of the inverse's solutions.
  if (const auto usual = model.leg.standing(local); usual && within_limits(model, *usual)) return usual;
  for (const Vector3d& joints : model.leg.inverse(local))
    if (within_limits(model, joints)) return joints;
  return std::nullopt;
}

Vector3d centre_of_mass(const Model& model, const Joints& legs) {
  Vector3d moment = Vector3d::Zero();
  for (std::size_t leg = 0; leg < kLegs; ++leg) {
    const LegPoints at = leg_points(model, leg, legs[leg]);
    moment += model.servo_mass * (at.coxa + at.hip + at.knee) + 0.5 * model.femur_mass * (at.hip + at.knee) +
              0.5 * model.tibia_mass * (at.knee + at.foot);
  }
  return moment / model.mass();
}

Posture to_posture(const Coordinates& at) {
  Posture posture{at.thorax, {}, {}};
  for (const Vector3d& leg : at.legs) posture.joints.insert(posture.joints.end(), leg.begin(), leg.end());
  return posture;
}

Coordinates from_posture(const Posture& posture) {
  Coordinates at{posture.base, {}};
  for (std::size_t leg = 0; leg < kLegs; ++leg) at.legs[leg] = Eigen::Map<const Vector3d>(&posture.joints.at(3 * leg));
  return at;
}

std::vector<Shape> shapes(const Model& model, const Coordinates& at) {
  std::vector<Shape> out;
  Shape thorax{Shape::Kind::kPolygon, "thorax", Isometry3d::Identity(), Vector3d::Zero(), {}};
  for (const Mount& mount : kMounts) thorax.vertices.push_back(at.thorax * mount.out({model.thorax_width / 2, 0, 0}));
  out.push_back(thorax);
  for (std::size_t leg = 0; leg < kLegs; ++leg) {
    const std::string name = "L" + std::to_string(leg + 1);
    const LegPoints points = leg_points(model, leg, at.legs[leg]);
    const Vector3d ankle = ankle_of(model, points);
    const std::array<std::pair<const char*, std::pair<Vector3d, Vector3d>>, 3> links{
        {{".coxa", {points.coxa, points.hip}}, {".femur", {points.hip, points.knee}}, {".tibia", {points.knee, ankle}}}};
    for (const auto& [link, ends] : links) {
      const Vector3d a = at.thorax * ends.first, b = at.thorax * ends.second;
      out.push_back({Shape::Kind::kCapsule, name + link, between(a, b), {model.leg_radius, 0, (b - a).norm()}, {}});
    }
  }
  return out;
}

}  // namespace foothold::hexpiderix
