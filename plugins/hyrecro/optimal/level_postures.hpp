// Postures for a stride within a face, in closed form: both hips at one height, the hip plate parallel to the face.
//
// p = s0 e(0) + t e(tau) - s1 e(alpha) with heading difference alpha: for given shares of the two shifts, s0 = c0 x and s1 = -c1 x,
// |p - (c0 e(0) + c1 e(alpha)) x| = t is a quadratic in x. A few shares, both roots, a few heights: enough for nearly all that is
// reachable at all, in well below a microsecond each; what it misses the exact reachability answers. Immutable; any thread.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "hyrecro/model/chain.hpp"

namespace foothold::hyrecro {

class LevelPostures {
 public:
  // `greatest_shift`: S of StrideBounds, m.
  LevelPostures(const Model& model, double greatest_shift);

  // Calls `take` with postures that put the free sole to `place` (m) and `heading` (rad), both seen from the sole that holds, until
  // it returns true: then true. All are within the limits; collisions are the caller's.
  bool any(const Eigen::Vector2d& place, double heading, const std::function<bool(const Coordinates&)>& take) const;

  // Hips' heights from the lowest on, and shifts of either leg that each allows, least and most among them; for searches by
  // posture.
  struct Level {
    double height = 0.0;
    std::vector<double> shifts;  // m
  };
  std::vector<Level> spread() const;  // takes a millisecond
  // With the shifts of the two legs, the hip plate's direction `tau` and the free sole's `heading` (rad), seen from the sole that
  // holds; empty out of limits.
  std::optional<Coordinates> posture(double shift0, double shift1, double height, double tau, double heading) const;

 private:
  struct Heights {
    double low = 0.0, high = -1.0;  // m, of the upper pin above the ankle pin
  };
  Heights heights(double shift) const;
  std::optional<Leg> leg(double shift, double height) const;

  const Model model_;
  double greatest_shift_ = 0.0;
  std::vector<Heights> table_;  // by |shift|
};

}  // namespace foothold::hyrecro
