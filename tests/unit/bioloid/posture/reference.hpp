// A posture's figures by the plain chain of screws, exact distances of boxes and the toolkit's support polygon: what Judge is held
// against. And postures and motions to hold it against.
#pragma once

#include <optional>
#include <random>

#include "bioloid/posture/judge.hpp"
#include "collision/distance.hpp"
#include "robot.hpp"

namespace foothold::bioloid::testing {

// What each Fault looks at; m and rad.
struct Figures {
  bool within_limits = true;
  double self = 0.0;       // least distance of two bodies that are not neighbours
  double obstacles = 0.0;  // least distance of a body to a prism; infinity without
  double sole = 0.0;       // height of the swing sole's lowest corner
  double bodies = 0.0;     // height of the lowest point of everything but feet and ankle blocks
  double balance = 0.0;    // the centre of mass inside the support polygon
  double slip = 0.0;       // the greater of the second sole's errors in place and turn; 0 in single support
};
// Prisms here are rectangles.
Figures figures(const Model& model, const Joints& joints, const Support& support, const std::vector<Prism>& prisms = {});

// How far the figures are above the demands, at the worst; negative: not met. Each in its own unit.
double room(const Figures& f, const Demands& demands, bool both);

// Standing on `support` with the pelvis at `pelvis` and the other sole at `second`, both in the support sole's frame; arms as
// carried.
std::optional<Joints> standing(const Model& model, Side support, const Isometry3d& pelvis, const Isometry3d& second);

struct Draw {
  std::mt19937_64 random;
  double operator()(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
};
// A posture in single support such as a walk has: pelvis over the sole, the swing foot near the ground. Within limits; may collide
// or tip. `wild` (0 to 1): how far from a walk's.
Joints walking(const Model& model, Side support, Draw& draw, double wild);

Isometry3d pose(double x, double y, double z, double yaw = 0.0, double pitch = 0.0, double roll = 0.0);

}  // namespace foothold::bioloid::testing
