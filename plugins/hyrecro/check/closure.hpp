// Do the ten joints make the posture that is sent?
#pragma once

#include <array>

#include "hyrecro/check/stances.hpp"

namespace foothold::hyrecro {

// As kJointNames, one by one.
inline constexpr std::array<const char*, kJoints> kJointList{"A_l1", "A_r1", "A_l2", "A_r2",  "B_l1",
                                                             "B_r1", "B_l2", "B_r2", "hip_A", "hip_B"};

// Ten finite joints, every actuator within its limits by 1e-9 m. Returns the least distance from a limit, m. `where` names the
// posture in refusals. Throws Refusal. Any thread.
double judge_limits(const Model& model, std::span<const double> joints, const std::string& where);

// A posture in the world: of the joints alone, with foot `holds` at `held`.
struct Posed {
  Coordinates coordinates;  // looking from the foot that holds
  Isometry3d free_sole, base;
};
// Precondition: judge_limits() passed.
Posed posed(const Model& model, std::span<const double> joints, Foot holds, const Isometry3d& held);

// The base is where the joints put it. Throws Refusal.
void judge_base(const Posed& is, const Isometry3d& sent, const std::string& where);

// The free sole is where `contact` says. Returns the larger one of the errors in m and rad. Throws Refusal.
double judge_contact(const Posed& is, const Contact& contact, const std::string& where);

}  // namespace foothold::hyrecro
