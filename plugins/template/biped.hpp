// The robot: two soles on flat ground z = 0. It walks in straight lines and never turns. Robot-specific knowledge that both the
// search and its checker need goes into a file like this one; what only one of them needs does not.
#pragma once

#include <array>
#include <string>

#include "foothold/planner.hpp"

namespace foothold::biped {

enum Foot : std::size_t { kLeft, kRight };
inline constexpr std::array<const char*, 2> kLimbs = {"left", "right"};

// The numbers of config/robots/template.yaml, in SI. Read once; each miss throws InvalidModel with the path.
struct Biped {
  double foot_length, foot_width;  // of a sole, along x and y
  double stance_width;             // between the soles' middles, standing at rest
  double reach;                    // of a foot from its place at rest beside the other
  Vector3d body_size;
  double body_height;

  explicit Biped(const RobotModel& model)
      : foot_length(length(model, "foot.length")),
        foot_width(length(model, "foot.width")),
        stance_width(length(model, "stance.width")),
        reach(length(model, "reach")),
        body_size(Vector3d::Map(model.numbers("body.size", "m", 3).data())),
        body_height(length(model, "body.height")) {
    if (reach + foot_width > stance_width)
      throw InvalidModel("reach", "must be at most stance.width - foot.width, or the soles could stand on each other");
  }

  static double length(const RobotModel& model, const char* path) {
    const double value = model.number(path, "m");
    if (!(value > 0.0)) throw InvalidModel(path, "must be above 0, is " + std::to_string(value) + " m");
    return value;
  }

  // Where a foot stands at rest, seen from the middle between both.
  Vector3d rest(Foot foot) const { return {0.0, (foot == kLeft ? 0.5 : -0.5) * stance_width, 0.0}; }

  // The robot standing at rest with the middle between its feet at `base`.
  Posture standing(const Isometry3d& base) const {
    Posture posture{.base = base, .joints = {}, .stance = {}};
    for (const Foot foot : {kLeft, kRight}) {
      Contact contact{.limb = kLimbs[foot], .frame = base, .face = "ground"};
      contact.frame.translation() += base.linear() * rest(foot);
      posture.stance.push_back(contact);
    }
    return posture;
  }
};

}  // namespace foothold::biped
