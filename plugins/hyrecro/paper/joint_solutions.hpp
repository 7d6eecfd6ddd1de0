// A free foot's pose and the joint solution that reaches it free of the scene, whichever reachability test is asked.
//
// `exact` and `iterative` bring a solution along. `network` says yes or no only: its yes is followed by the exact search for a
// solution, as the paper follows it by inverse kinematics and a test for collisions. A yes to what nothing reaches (a wrong
// positive) stays a yes, as in the paper; the step then carries the solution of the nearest reachable pose that was found, and
// check() refuses it, since its forward kinematics miss the contact.
#pragma once

#include <array>
#include <set>

#include "hyrecro/reach/by_poses.hpp"
#include "hyrecro/reach/reachability.hpp"
#include "hyrecro/scene/prepared.hpp"

namespace foothold::hyrecro {

struct Answer {
  bool reachable = false;
  std::optional<Coordinates> coordinates;  // empty for a wrong positive of the network
};

// Used by one thread at a time.
class JointSolutions {
 public:
  // All are borrowed. `lift`: see PaperOptions; holds for solve(). `kept`: answers of `exact` on this scene with this lift, from
  // earlier requests and for later ones; may be null.
  JointSolutions(const Model& model, const PreparedTruss& scene, Reachability& asked, double lift = 0.0,
                 ByPoses<Answer>* kept = nullptr);

  // One foot holds at `holding` (world), the other shall be at `free` (world).
  Answer solve(const Isometry3d& holding, const Isometry3d& free);
  // Free of the scene, the foot that holds standing at `holding`.
  bool admits(const Isometry3d& holding, const Coordinates& coordinates) const;
  // For wrong positives: coordinates of a reachable pose near to this one, whatever the scene.
  Coordinates nearest(const Isometry3d& free_in_holding);
  std::size_t asked() const { return count_; }

 private:
  // A pose to a hundred millionth of a metre and of a radian.
  using PoseKey = std::array<int, 12>;
  static PoseKey key_of(const Isometry3d& pose);
  Reachability& exact();
  Answer ask(const Isometry3d& holding, const Isometry3d& free);

  const Model& model_;
  const PreparedTruss& scene_;
  Reachability& asked_;
  double lift_;
  std::unique_ptr<Reachability> exact_;  // made when the network is asked
  // On beams the same few relative poses come again and again: those that no posture reaches, whatever the scene. Kept for `exact`
  // alone, whose answers do not change from call to call.
  bool repeats_;
  ByPoses<Answer>* kept_;
  std::set<PoseKey> out_of_reach_;
  std::size_t count_ = 0;
};

}  // namespace foothold::hyrecro
