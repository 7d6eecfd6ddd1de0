// What Judge keeps between calls, and its checks one by one. Private to posture/.
#pragma once

#include <optional>

#include "bioloid/posture/bends.hpp"
#include "bioloid/posture/ground.hpp"
#include "bioloid/posture/judge.hpp"
#include "bioloid/posture/obstacles.hpp"
#include "bioloid/posture/upper.hpp"

namespace foothold::bioloid {

// A posture with what follows from it.
struct Snapshot {
  Joints joints;
  Stand stand;
  const Upper* upper = nullptr;
  std::unique_ptr<Upper> own;  // if the arms are not held as in the judge's last postures
  // The support sole's frame seen from the torso, and what is seen from there.
  Eigen::Matrix3d sole_turn;  // columns: its axes
  Vector3d sole;
  Vector3d com;  // in the support sole's frame
};

// The checks, as bits: what is still to be shown of a motion.
enum Check : unsigned { kBalanceCheck = 1, kGroundCheck = 2, kSlipCheck = 4, kSelfCheck = 8, kObstacleCheck = 16, kAllChecks = 31 };
// Where the swing sole has to touch the ground; anywhere on such a motion it may be lower by Demands::ground.
enum Touching : unsigned { kTouchesAtA = 1, kTouchesAtB = 2, kTouchesSomewhere = 4 };

struct Judge::Inside {
  Inside(const Model& model, Demands demands, const std::vector<Prism>& prisms);

  void stand_on(const Support& support);
  void stand_near(const Support& support);
  void place(const Joints& joints, Snapshot& out);
  bool within_limits(const Joints& joints) const;
  Bends bends_of(const Snapshot& a, const Rates& rates) const;
  Isometry3d swing_sole(const Snapshot& at) const;  // in the support sole's frame

  // The first check of `which` that the posture fails. Exact.
  Fault posture_fault(const Snapshot& at, unsigned which) const;
  // Of `which`, those that could not be shown for the motion between the two.
  unsigned unproved(const Snapshot& a, const Snapshot& b, unsigned which, unsigned touching) const;
  Fault certify(const Snapshot& a, const Snapshot& b, unsigned which, unsigned touching, int depth);

  Isometry3d body_frame(const Snapshot& at, std::size_t body) const;  // in the torso's frame

  // Each of these judges the posture `a` if `rates` (and `bends`) are null and a and b are the same, else the motion between.
  bool balanced(const Snapshot& a, const Snapshot& b, const Bends* bends) const;
  bool keeps_place(const Snapshot& a, const Snapshot& b, const Bends* bends) const;
  bool above_ground(const Snapshot& a, const Snapshot& b, const Bends* bends, unsigned touching) const;
  bool clear_of_obstacles(const Snapshot& a, const Snapshot& b, const Bends* bends) const;
  bool self_apart(const Snapshot& a, const Snapshot& b, const Rates* rates) const;

  // Of self_apart(): self.cpp.
  bool folds_apart(const Snapshot& a, const Snapshot& b, const Rates* rates) const;
  bool legs_apart(const Snapshot& a, const Snapshot& b, const Rates* rates, bool& clear_of_far_arms) const;
  bool upper_apart(const Snapshot& a, const Snapshot& b, const Rates* rates, bool clear_of_far_arms) const;
  bool arms_apart(const Snapshot& a, const Snapshot& b, double bend) const;
  bool brackets_apart(const Snapshot& a, const Snapshot& b, const Rates* rates) const;
  bool against_legs(const Snapshot& a, const Snapshot& b, std::size_t first, std::size_t last,
                    const std::array<Lanes, kLinks>& bend, double own_bend) const;
  bool bodies_apart(const Snapshot& a, const Snapshot& b, std::size_t one, std::size_t two, double bend) const;

  Model model;
  Demands demands;
  std::vector<Obstacle> obstacles;
  Legs legs;
  std::array<Weights, 2> weights;
  Joints low, high;
  double mass = 0.0, arms_mass = 0.0, arm = 0.0, reach = 0.0, bracket_reach = 0.0;
  bool bracket_boxes = false;
  Upper upper;  // of the arms as they were held last
  Ground ground;
  std::vector<const Obstacle*> near;       // within reach of where it stands
  std::optional<Eigen::Vector2d> near_at;  // there
};

}  // namespace foothold::bioloid
