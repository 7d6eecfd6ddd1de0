// What the parts of the judge share: the robot, the ground round it, what is demanded, and a stance as they see it.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

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

inline constexpr double kTouch = 1e-6;       // m
inline constexpr double kSoleLength = 1e-3;  // m, of a standing foot: so near to its contact other ground is not told from its own

// Where a foot stands, and the ground there. Borrows the setting's triangles.
struct Seat {
  Vector3d sole = Vector3d::Zero();
  std::vector<const Triangle*> under;   // those that it touches
  std::vector<const Triangle*> beside;  // others that the foot can come near to
  bool hollow = false;                  // some of `under` rise above the planes of others; else flat, a ridge or a peak
};
Seat seat_of(const Setting& setting, const Vector3d& sole);

// Height of the ankle above the ground's planes: above all of them where the ground is hollow, above one of them where it is not.
// m; a foot with more than 0 comes from outside.
double rise(const Seat& seat, const Vector3d& ankle);
// m, from the foot but for its last millimetre to the ground beside its seat, looked for up to `reach`.
double standing_distance(const Seat& seat, const Vector3d& sole, const Vector3d& ankle, double reach);
// m, from a foot in the air to all the ground.
double flying_distance(const Setting& setting, const Vector3d& sole, const Vector3d& ankle, double reach);

}  // namespace foothold::octopod
