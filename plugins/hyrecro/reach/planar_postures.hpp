// Postures with both soles in one plane and the hip plate parallel to it (psi = 0), in closed form but for one number.
//
// With the hips' shifts s0, s1 along the soles' X axes and the hip plate's direction tau: p = s0 e(0) + t e(tau) - s1 e(heading).
// Given s1, tau and s0 follow, with two signs of cos tau; both hips stand at one height, which each shift leaves an interval. The
// bodies' bounding box grows with the height and so does the distance between the legs: the highest posture decides. Immutable; any
// thread.
#pragma once

#include <optional>
#include <vector>

#include "hyrecro/model/bodies.hpp"

namespace foothold::hyrecro {

// Pose in a face's plane: metres and radians, heading from the frame's X axis, counter-clockwise seen from outside.
struct PlanarPose {
  double x = 0.0, y = 0.0, heading = 0.0;
};
Isometry3d to_isometry(const PlanarPose& pose);
// `b` seen from `a`.
PlanarPose seen_from(const PlanarPose& a, const PlanarPose& b);

class PlanarPostures {
 public:
  PlanarPostures(const Model& model, double clearance);

  // One number and one sign tell a posture of a pose.
  struct Choice {
    double shift1 = 0.0;  // m, s1
    int side = 1;         // sign of cos tau
  };
  // The posture whose bodies, free of each other, have the largest bounding box in the frame of the sole that holds; among the
  // samples of s1. Empty if there is none.
  std::optional<Choice> widest(const PlanarPose& pose) const;
  // The highest posture of a choice. Precondition: `choice` is of this pose, rounded to float at most.
  Coordinates coordinates(const PlanarPose& pose, const Choice& choice) const;

  double greatest_shift() const { return greatest_shift_; }  // S, m: of a hip along its sole's X axis
  // No plane posture, level or not, reaches further, m.
  double greatest_reach() const { return greatest_reach_; }

 private:
  struct Heights {
    double low, high;  // m, of the upper pin above the ankle pin
  };
  // A pose with what does not depend on the choice.
  struct Placed {
    double x, y, c, s;
  };
  struct Sample {
    double shift0 = 0.0, shift1 = 0.0, cos_tau = 1.0, sin_tau = 0.0;
    double room = 0.0;    // m, between the lowest and the highest height; negative: out of limits
    double height = 0.0;  // m, the highest
  };
  Heights heights(double shift) const;
  Sample sample(const Placed& pose, const Choice& choice) const;
  double volume(const Placed& pose, const Sample& sample) const;
  double legs_gap(const Placed& pose, const Sample& sample) const;
  std::optional<Choice> refined(const Placed& pose, const Choice& low, const Choice& high) const;
  bool plates_apart(const PlanarPose& pose) const;

  const Model model_;
  const double clearance_;
  double greatest_shift_ = 0.0, greatest_reach_ = 0.0;
  std::vector<Heights> table_;  // by |shift|
};

}  // namespace foothold::hyrecro
