// The 2RPR-PR mechanism of Xrobin: its eight configurations from the two lengths that a piston can have.
//
// Body A carries the slot (along its y axis, piston pins at x = -+b); body B slides in it and turns (pins at x = +-p of its own
// frame). The pistons are crossed, so that B in A's frame is Trans(0, y) Rot(phi) with
//   l^2 = (b + p cos phi)^2 + (y + p sin phi)^2,   r^2 = (b + p cos phi)^2 + (y - p sin phi)^2.
// Source: the paper's section 2; equations derived from its figure 1.
#pragma once

#include <array>

#include "foothold/model.hpp"
#include "planar.hpp"

namespace foothold::xrobin {

// The four lengths that fix the mechanism, in m.
struct Lengths {
  double b = 0.0;          // half width of the slot: pins of body A at x = -+b
  double p = 0.0;          // half width of the rail: pins of body B at x = +-p
  double retracted = 0.0;  // both pistons
  double extended = 0.0;
};

// b and p for which every turn is an exact multiple of 45 deg: b^2 + p^2 = retracted^2, phi(01) = -45 deg. Throws
// std::domain_error if no such b and p exist.
Lengths with_exact_turns(double retracted, double extended);

// One of the eight. `number` is that of the paper's figure 2.
struct Configuration {
  int number = 0;
  bool l_extended = false;
  bool r_extended = false;
  char solution = 'U';  // U or V: which of the two symmetric solutions of the forward kinematics
  double phi = 0.0;     // rad
  double y = 0.0;       // m
  // phi = quarter_turns * phi(7) + eighth_turns * phi(6), exactly: both are in {-1, 0, 1}.
  int quarter_turns = 0;
  int eighth_turns = 0;
};

inline constexpr int kConfigurations = 8;

// Piston lengths of a posture, in m.
struct Pistons {
  double l = 0.0;
  double r = 0.0;
};

// Immutable; any thread.
class Mechanism {
 public:
  // Throws InvalidModel with the path of the number at fault ("piston.extended") if the eight configurations do not exist.
  explicit Mechanism(const Lengths& lengths);
  static Mechanism from_model(const RobotModel& model);

  const Lengths& lengths() const { return lengths_; }
  const Configuration& configuration(int number) const { return configurations_[static_cast<std::size_t>(number - 1)]; }
  const std::array<Configuration, kConfigurations>& configurations() const { return configurations_; }
  // Body B in the frame of body A.
  PlanarPose b_in_a(int number) const { return {0.0, configuration(number).y, configuration(number).phi}; }
  Pistons pistons(double phi, double y) const;
  Pistons pistons(int number) const;
  double quarter_turn() const { return configurations_[6].phi; }  // phi of configuration 7, about 90 deg
  double eighth_turn() const { return configurations_[5].phi; }   // phi of configuration 6, about 45 deg
  // The most that one cycle can displace a body, in m.
  double longest_cycle() const { return longest_cycle_; }
  // The most that the fixed body's centre can be away from the moving one's, in m: the travel in the slot.
  double travel() const { return configurations_[0].y; }

 private:
  Lengths lengths_;
  std::array<Configuration, kConfigurations> configurations_;
  double longest_cycle_ = 0.0;
};

}  // namespace foothold::xrobin
