#include "hexpiderix/walk/footholds.hpp"

#include <algorithm>
#include <cmath>

namespace foothold::hexpiderix {
namespace {

constexpr double kLook = 0.3;  // m, up and down from the station's plane

// Offsets from a standing place, the nearest first, m.
const std::vector<Eigen::Vector2d>& offsets() {
  static const std::vector<Eigen::Vector2d> all = [] {
    constexpr double kStep = 0.01;
    constexpr int kSteps = 3;
    std::vector<Eigen::Vector2d> out;
    for (int i = -kSteps; i <= kSteps; ++i)
      for (int j = -kSteps; j <= kSteps; ++j) out.emplace_back(kStep * i, kStep * j);
    std::stable_sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.squaredNorm() < b.squaredNorm(); });
    return out;
  }();
  return all;
}

// Frame on a plane: origin under the station, X its heading.
Isometry3d frame_at(const Plane& plane, double heading) {
  Isometry3d frame = Isometry3d::Identity();
  frame.linear() = axes_along(plane.normal, {std::cos(heading), std::sin(heading), 0.0});
  frame.translation() = plane.point;
  return frame;
}

}  // namespace

std::optional<Plane> plane_at(const Model& model, const Ground& ground, const Station& station) {
  const auto middle = footing(ground.surface(), station.place, -Vector3d::UnitZ(), kLook);
  Plane plane{middle ? middle->point : station.place, Vector3d::UnitZ()};
  // On a steep slope feet that were looked for straight below are not those of the robot that stands there: a second look goes
  // along the first plane's normal.
  for (int look = 0; look < 2; ++look) {
    const Isometry3d frame = frame_at(plane, station.heading);
    Footholds feet;
    for (std::size_t leg = 0; leg < kLegs; ++leg) {
      Vector3d place = standing_foot(model, leg);
      place.z() = 0.0;
      const auto found = footing(ground.surface(), frame * place, -Vector3d::UnitZ(), kLook);
      if (!found) return std::nullopt;
      feet.supports[leg] = true;
      feet.points[leg] = found->point;
    }
    const Plane fitted = plane_through(feet);
    const double above = fitted.above(station.place) / fitted.normal.z();
    plane = {station.place - above * Vector3d::UnitZ(), fitted.normal};
  }
  return plane;
}

std::optional<Footholds> footholds_at(const Model& model, const Ground& ground, const Station& station, const Plane& plane,
                                      double friction, std::size_t& leg) {
  const Isometry3d frame = frame_at(plane, station.heading);
  const double steepest = std::cos(std::atan(friction));
  Footholds out;
  for (leg = 0; leg < kLegs; ++leg) {
    Vector3d place = standing_foot(model, leg);
    place.z() = 0.0;
    for (const Eigen::Vector2d& offset : offsets()) {
      const auto found = footing(ground.surface(), frame * (place + Vector3d(offset.x(), offset.y(), 0.0)), -plane.normal, kLook);
      if (!found || found->normal.dot(plane.normal) < steepest) continue;
      out.supports[leg] = true;
      out.points[leg] = found->point;
      out.normals[leg] = found->normal;
      break;
    }
    if (!out.supports[leg]) return std::nullopt;
  }
  return out;
}

}  // namespace foothold::hexpiderix
