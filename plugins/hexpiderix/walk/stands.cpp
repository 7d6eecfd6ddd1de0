#include "hexpiderix/walk/stands.hpp"

#include <algorithm>
#include <cmath>

#include "hexpiderix/walk/footholds.hpp"

namespace foothold::hexpiderix {
namespace {

constexpr std::array kHeights{0.10, 0.08, 0.06, 0.12, 0.045};  // m, of the coxa axes over the plane
constexpr std::array kShifts{0.0, 0.02, 0.04, 0.06, 0.08};     // m, uphill
constexpr std::array kShares{0.0, 0.5, 1.0};                   // of the plane's inclination that the thorax turns back

Isometry3d thorax_over(const Plane& plane, double heading, double height, double shift, double share) {
  const Vector3d up = plane.normal;
  const double slope = std::acos(std::clamp(up.z(), -1.0, 1.0));
  Vector3d axis = up.cross(Vector3d::UnitZ());  // turning about it by the slope brings the normal upright
  Vector3d uphill = Vector3d::Zero();
  if (axis.norm() > 1e-9) {
    axis.normalize();
    uphill = up.cross(axis);
    if (uphill.z() < 0.0) uphill = -uphill;
  } else {
    axis = Vector3d::UnitX();
  }
  Isometry3d out = Isometry3d::Identity();
  const Eigen::Matrix3d parallel = axes_along(up, {std::cos(heading), std::sin(heading), 0.0});
  out.linear() = Eigen::AngleAxisd(share * slope, axis).toRotationMatrix() * parallel;
  out.translation() = plane.point + height * up + shift * uphill;
  return out;
}

}  // namespace

bool any_stand(const Model& model, const Ground& ground, const Station& station, const Plane& plane, const Footholds& feet,
               const WalkOptions& options, std::string& because, const std::function<bool(const Stand&)>& take) {
  const bool level = plane.normal.z() > 1.0 - 1e-9;
  for (const double shift : kShifts)
    for (const double height : kHeights)
      for (const double share : kShares) {
        if (level && (shift > 0.0 || share > 0.0)) continue;
        Stand stand{{}, feet};
        std::size_t leg = 0;
        const Isometry3d thorax = thorax_over(plane, station.heading, height, shift, share);
        if (!place_feet(model, thorax, feet.points, stand.at, leg)) {
          because = "leg " + std::to_string(leg + 1) + " does not reach its foothold";
          continue;
        }
        Vector3d com;
        const double least = std::min(nesm_on(model, stand.at, feet, kTriad1, com), nesm_on(model, stand.at, feet, kTriad2, com));
        if (least < options.least_nesm) {
          because = "a tripod has a stability (NESM) of only " + std::to_string(1e3 * least) + " mm";
          continue;
        }
        const std::string met = in_the_way(model, ground.surface(), stand.at, options.clearance);
        if (!met.empty()) {
          because = met + " meet";
          continue;
        }
        if (take(stand)) return true;
      }
  return false;
}

std::optional<Stand> stand_at(const Model& model, const Ground& ground, const Station& station, const WalkOptions& options,
                              std::string* because) {
  std::string reason = "there is no ground under a foot";
  std::optional<Stand> out;
  const auto plane = plane_at(model, ground, station);
  std::size_t leg = 0;
  if (plane) {
    const auto feet = footholds_at(model, ground, station, *plane, options.friction, leg);
    if (feet)
      any_stand(model, ground, station, *plane, *feet, options, reason, [&](const Stand& stand) {
        out = stand;
        return true;
      });
    else
      reason = "leg " + std::to_string(leg + 1) + " finds no foothold";
  }
  if (because != nullptr) *because = reason;
  return out;
}

}  // namespace foothold::hexpiderix
