// A quick necessary condition for a pose of the free sole to be reachable, collisions aside: for lists of candidates, and before
// exact reachability, which takes a hundred times longer to say no.
//
// Both legs end at the hip plate. Seen along its normal, each puts its hip axis to a height and a shift (leg_shifts.hpp). Both axes
// must be at one height, and the distance t apart in the plate's plane. Regular poses fix both leans up to a sign, which leaves the
// height free; singular ones leave one lean free as well. What is free is searched from coarse cells to fine ones; a cell whose
// bounds contradict the pose holds nothing. Frames of the paper inside. Immutable; any thread.
#pragma once

#include <memory>
#include <vector>

#include "hyrecro/model/chain.hpp"
#include "hyrecro/reach/leg_shifts.hpp"

namespace foothold::hyrecro {

class ReachFilter {
 public:
  explicit ReachFilter(const Model& model);

  // False: certainly out of reach. True: perhaps within.
  bool may_reach(const Isometry3d& free_in_holding) const;

  // What depends on the free sole's orientation alone.
  struct Turn {
    struct Way {                    // regular: one pair of leans
      int first = -1, second = -1;  // the legs' finest cells of leans
      Vector3d normal, x;           // of the hip plate; along leg 0's shifts
      Eigen::Vector2d e1;           // along leg 1's, in the plate's plane
    };
    bool singular = false;
    std::vector<Way> ways;
    double lean0 = 0.0, turning = 1.0;                        // singular: psi0 = lean0 + turning psi1
    double cosine = 1.0, sine = 0.0;                          // of lean0
    Vector3d ball = Vector3d::Zero();                         // m
    bool never() const { return !singular && ways.empty(); }  // nothing can be reached
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
  bool regular(const Turn::Way& way, double rise, const Eigen::Vector2d& place, int level, int height) const;
  struct Singular {  // a turn with the free sole's place (paper's axes), and how far that and the hip axes are apart, m
    const Turn& turn;
    const Vector3d& p;
    double aside = 0.0, across = 0.0;
  };
  bool singular(const Singular& pose, int level, int lean, int height) const;
  void set_ball(double longest);

  LegShifts shifts_;
  struct Direction {
    double lean, cosine, sine;
  };
  std::vector<std::vector<Direction>> middles_;  // of the cells of leans, by level
  double hip_distance_, reach_ = 0.0;
  double ball_height_ = 0.0, ball_radius_ = 0.0;  // m: each hip axis lies in a ball over its sole, so high above it
};

// The filter of a robot, made once (some milliseconds) and shared by all scenes of the process. Any thread.
std::shared_ptr<const ReachFilter> shared_reach_filter(const Model& model);

}  // namespace foothold::hyrecro
