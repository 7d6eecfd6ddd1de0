// How Xrobin gets from one configuration to another: along the ring 1, 2, ..., 8, 1, one piston at a time.
//
// Between neighbours one piston keeps its length L, so that (phi, y) follows a curve with phi for its parameter:
//   y = p sin phi + w (r is kept) or y = -p sin phi + w (l is kept),  w = +-sqrt(L^2 - (b + p cos phi)^2).
// The ring goes round the only singular posture, phi = y = 0, where y^2 cos phi + b p sin^2 phi vanishes.
#pragma once

#include <array>
#include <vector>

#include "mechanism.hpp"

namespace foothold::xrobin {

// A posture of body B in the frame of body A.
struct SlotPosture {
  double phi = 0.0;  // rad
  double y = 0.0;    // m
};

// The curve from configuration `from` to its successor on the ring.
struct RingEdge {
  int from = 0;
  int to = 0;
  bool l_moves = false;  // else r does
  double kept = 0.0;     // m: the length of the other piston
  double sign = 0.0;     // of w
  double phi_from = 0.0;
  double phi_to = 0.0;
};

class Ring {
 public:
  // Throws InvalidModel if neighbours are not joined by one curve free of singular postures.
  explicit Ring(const Mechanism& mechanism);
  // The edge from configuration `from` to the next (8: to 1).
  const RingEdge& edge(int from) const { return edges_[static_cast<std::size_t>(from - 1)]; }
  SlotPosture at(const RingEdge& edge, double phi) const;
  // At most this much does y change per radian on the edge between the two angles (m / rad).
  double slope_bound(const RingEdge& edge, double phi_a, double phi_b) const;
  const Mechanism& mechanism() const { return mechanism_; }

 private:
  Mechanism mechanism_;
  std::array<RingEdge, kConfigurations> edges_;
};

// Positive: through rising numbers.
enum class RingWay : int { kUp = 1, kDown = -1 };

inline int neighbour(int configuration, RingWay way) {
  return (configuration - 1 + static_cast<int>(way) + kConfigurations) % kConfigurations + 1;
}

// How many strokes of one piston lead from one configuration to another that way round: 0 to 7.
inline int strokes(int from, int to, RingWay way) {
  return ((to - from) * static_cast<int>(way) + kConfigurations) % kConfigurations;
}

// The shorter way; both of four strokes: up.
inline RingWay shorter_way(int from, int to) {
  return strokes(from, to, RingWay::kUp) <= strokes(from, to, RingWay::kDown) ? RingWay::kUp : RingWay::kDown;
}

// The curve from one configuration to another, `per_stroke` postures for each stroke, the first posture left out.
std::vector<SlotPosture> way_along(const Ring& ring, int from, int to, RingWay way, int per_stroke);

}  // namespace foothold::xrobin
