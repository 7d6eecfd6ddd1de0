// Postures of one view or the other.
#include "hyrecro/posture.hpp"

#include <array>
#include <numbers>

namespace foothold::hyrecro {
namespace {

// Hip X points from the first foot's axis to the second's; a base's from A's to B's.
Isometry3d a_to_b(const Isometry3d& hip, Foot first) {
  return first == Foot::kA ? hip : hip * Eigen::AngleAxisd(std::numbers::pi, Vector3d::UnitZ());
}

// A straight or bent leg whose lengths lie at `part` (0 to 1) of what the bend leaves.
Leg leg_at(const Model& model, double bend, double part) {
  const auto y = model.mechanism.offsets(bend);
  const double length = y.low + part * (y.high - y.low);
  return {bend, length, -bend, length};
}

}  // namespace

Isometry3d base_of(const Model& model, const Coordinates& coordinates, Foot first, const Isometry3d& sole) {
  return sole * a_to_b(frames(model, coordinates).hip, first);
}

Posture posture_of(const Model& model, const Coordinates& coordinates, Foot first, const Isometry3d& sole) {
  return {base_of(model, coordinates, first, sole), to_joints(model, coordinates, first), {}};
}

Stand stand_of(const Model& model, const Posture& posture) {
  const Coordinates coordinates = from_joints(model, posture.joints, Foot::kA);
  return {coordinates, posture.base * frames(model, coordinates).hip.inverse()};
}

bool is_free(const Model& model, const PreparedTruss& scene, const Coordinates& coordinates, const Isometry3d& sole) {
  const Bodies bodies = bodies_at(model, coordinates, sole);
  return free_of_itself(bodies, scene.clearance) && scene.obstacles.free(bodies, scene.clearance);
}

std::optional<Coordinates> hanging(const Model& model, const PreparedTruss& scene, const Isometry3d& sole) {
  constexpr int kHeadings = 24;
  constexpr std::array kParts{0.9, 0.5, 0.2};              // of the leg that holds
  constexpr std::array kBends{0.0, 0.3, -0.3, 0.6, -0.6};  // rad, of the leg that holds
  constexpr std::array kDrawnUp{0.05, 0.5};                // of the leg in the air
  for (const double bend : kBends)
    for (const double part : kParts)
      for (const double up : kDrawnUp)
        for (int heading = 0; heading < kHeadings; ++heading) {
          const double hip = std::remainder(heading * 2.0 * std::numbers::pi / kHeadings, 2.0 * std::numbers::pi);
          const Coordinates coordinates{{leg_at(model, bend, part), leg_at(model, 0.0, up)}, {hip, hip}};
          if (within_limits(model, coordinates) && is_free(model, scene, coordinates, sole)) return coordinates;
        }
  return std::nullopt;
}

}  // namespace foothold::hyrecro
