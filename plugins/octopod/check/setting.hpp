// What the parts of the judge share: the robot, the ground round it, what is demanded, and a stance as they see it.
#pragma once

#include <array>
#include <span>
#include <string>

#include "contact/contact.hpp"
#include "judge/refusal.hpp"
#include "octopod/check/bodies.hpp"
#include "octopod/check/check.hpp"

namespace foothold::octopod {

using judge::refuse;

struct Setting {
  const Model& model;
  std::span<const Triangle> triangles;  // all that the robot can come near to
  const CheckOptions& options;

  contact::FrictionCone cone() const { return {options.cone_edges}; }
};

// The eight contacts of a stance in the order of the legs.
using Feet = std::array<contact::Contact, kLegs>;

// Of `stance`: all eight limbs, each once, each contact on the ground within 1e-6 m with the ground's own normal (1e-6 rad).
// Refuses with `where`.
Feet judge_feet(const Setting& setting, std::span<const Contact> stance, const std::string& where);

// Each foot, by the joints alone, is where its contact says (1e-6 m). Returns the greatest error, m.
double judge_closure(const Skeleton& at, const Feet& feet, const std::string& where);

// How a foot stands in its ground: outwards of all triangles that meet under it where the ground is hollow there or flat, of one of
// them where it is a ridge or a peak. m, height of the ankle; above 0: the foot comes from outside.
double rise(const Setting& setting, const Vector3d& sole, const Vector3d& ankle);

// The triangles that a foot standing at `sole` does not touch. m, of the foot without its last millimetre.
inline constexpr double kTouch = 1e-6;       // m
inline constexpr double kSoleLength = 1e-3;  // m
double foot_distance(const Setting& setting, const Vector3d& sole, const Vector3d& ankle, double reach);

}  // namespace foothold::octopod
