// A quick necessary condition for a pose of the free sole to be reachable, collisions aside: for lists of candidates.
//
// Both legs end at the hip plate. Seen along its normal, leg j puts its hip axis to the height c and the shift s,
//   s = a sin psi + lambda sin phi2,  c = a cos psi + lambda cos phi2 + a2,  phi1 + phi2 = psi ,
// a region for each lean psi, kept as the interval of s for each cell of psi and c, rounded outwards. Both axes must be at one
// height, and the distance t apart in the plate's plane. Regular poses fix both leans up to a sign; singular ones leave one of them
// free, which is scanned. Frames of the paper inside. Immutable; any thread.
#pragma once

#include <vector>

#include "hyrecro/model/chain.hpp"

namespace foothold::hyrecro {

class ReachFilter {
 public:
  explicit ReachFilter(const Model& model);

  // False: certainly out of reach. True: perhaps within.
  bool may_reach(const Isometry3d& free_in_holding) const;

 private:
  struct Shifts {
    double low = 1.0, high = -1.0;  // m; empty: low > high
  };
  const Shifts* of_lean(double psi) const;  // by height; null: no leg leans so much
  bool level(const Shifts* first, const Shifts* second, double rise, const Eigen::Vector2d& place, const Eigen::Vector2d& e0,
             const Eigen::Vector2d& e1, double slack) const;

  double hip_distance_, reach_ = 0.0;
  double ball_height_ = 0.0, ball_radius_ = 0.0;  // m: each hip axis lies in a ball over its sole, so high above it
  int heights_ = 0;
  std::vector<Shifts> table_;  // lean x height
};

}  // namespace foothold::hyrecro
