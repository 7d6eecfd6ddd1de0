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

 public:
  // What depends on the free sole's orientation alone. Without ways nothing can be reached.
  struct Turn {
    struct Way {  // one pair of leans
      const Shifts *first, *second;
      Vector3d normal, x;  // of the hip plate; along leg 0's shifts
      Eigen::Vector2d e1;  // along leg 1's, in the plate's plane
    };
    bool singular = false;
    std::vector<Way> ways;
    Vector3d ball = Vector3d::Zero();  // m
  };
  Turn turn(const Eigen::Matrix3d& orientation) const;
  // `place` of the free sole seen from the other, m.
  bool may_reach(const Turn& turn, const Vector3d& place) const;
  // m: what must be added to the place for what must be nearer than apart().
  Vector3d ball(const Eigen::Matrix3d& orientation) const { return ball_height_ * (orientation.col(2) - Vector3d::UnitZ()); }
  double apart() const { return 2.0 * ball_radius_ + hip_distance_; }
  // As far along the soles' Y axes may singular poses lie apart, m.
  double aside() const { return hip_distance_; }

 private:
  const Shifts* of_lean(double psi) const;  // by height; null: no leg leans so much
  bool level(const Turn::Way& way, double rise, const Eigen::Vector2d& place, double slack) const;

  double hip_distance_, reach_ = 0.0;
  double ball_height_ = 0.0, ball_radius_ = 0.0;  // m: each hip axis lies in a ball over its sole, so high above it
  int heights_ = 0;
  std::vector<Shifts> table_;  // lean x height
};

}  // namespace foothold::hyrecro
