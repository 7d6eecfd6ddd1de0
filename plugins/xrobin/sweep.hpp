// The edges of the ring cut into intervals: the bodies in the middle of each, and how far anything can be from there on the
// interval.
#pragma once

#include <array>
#include <vector>

#include "body.hpp"
#include "box.hpp"
#include "geometry/polygon.hpp"
#include "ring.hpp"

namespace foothold::xrobin {

// What moves while one body holds, at one posture, in the frame of the body that holds: the other body and both pistons.
struct SweepInterval {
  std::array<Box, 3> boxes;
  double drift = 0.0;  // m: at most so far is any point of them away from where it is in the middle
};

// Immutable; any thread.
class Sweep {
 public:
  Sweep(const Ring& ring, const Bodies& bodies, bool a_holds, const RingEdge& edge);
  // Halves of halves of the edge: 1 is the whole, 2 k and 2 k + 1 are the halves of k. Those of low number are kept.
  SweepInterval interval(std::size_t k) const;
  // Everything that moves stays inside.
  const geometry::Circle& circle() const { return circle_; }

 private:
  SweepInterval make(std::size_t k) const;

  const Ring* ring_;
  Bodies bodies_;
  bool a_holds_;
  RingEdge edge_;
  geometry::Circle circle_;
  std::vector<SweepInterval> kept_;
};

}  // namespace foothold::xrobin
