// The robot against itself: legs against each other, against modules' bodies and necks, and bodies against each other.
//
// A leg counts from its shoulder to its sole, as thick as a leg down to there. What hangs together is not compared: a femur with
// its own tibia, and with its own module, in whose side the shoulder is (without a coxa, a femur that points along that side lies
// in it by its radius). Values; any thread.
#pragma once

#include <optional>

#include "collision/distance.hpp"
#include "octopod/model/body.hpp"

namespace foothold::octopod {

// Parts that can touch: 0 to 7 are legs.
inline constexpr int kBodyOfA = 8, kBodyOfB = 9;  // with its neck

// Stands keep so much (m) besides the clearance, and motions between them half of it: a motion's straight pieces use up a part.
inline constexpr double kApart = 1e-3;

// Two parts, the lower first.
struct Touch {
  int part = -1, other = -1;
};
// The first two parts nearer to each other than `clearance` (m, >= 0): legs by pairs, then legs with modules, then the modules.
// Empty if none are.
std::optional<Touch> touching_itself(const Model& model, const std::array<Isometry3d, 2>& modules,
                                     const std::array<LegPoints, kLegs>& legs, double clearance);

// True if nearer than `clearance` (m, >= 0) between the surfaces. World frame.
bool legs_nearer(const Model& model, const LegPoints& a, const LegPoints& b, double clearance);
// `own`: the leg hangs on that module.
bool leg_nearer(const Model& model, const LegPoints& leg, int module, const Isometry3d& pose, bool own, double clearance);
bool modules_nearer(const Model& model, const std::array<Isometry3d, 2>& modules, double clearance);

}  // namespace foothold::octopod
