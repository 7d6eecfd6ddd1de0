// The search's judge of postures and motions: limits, self-collision, ground, obstacles, balance, with margins; fast.
//
// Everything but the obstacles is seen from the support sole's frame: the sole that stands fast. A motion is a straight line in the
// 18 joints; it is certified between its ends, not sampled: along a line q(t) = a + t (b - a) any point of a body deviates from the
// chord between its end positions by at most |b - a|^2_w / 8 (a bound on the second derivative, from the bodies' greatest distances
// to the joints' axes), so a plane that separates two bodies at both ends by more than that separates them all the way; the same
// holds for the heights of the swing sole's corners and for the centre of mass inside the support polygon. What cannot be shown so
// is halved, down to 1/256.
//
// Used by one thread at a time (it keeps scratch space).
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "bioloid/model/kinematics.hpp"
#include "bioloid/prism.hpp"

namespace foothold::bioloid {

struct Demands {
  double clearance =
      0.002;               // m, between bodies that are not neighbours, to obstacles, and of all but feet and ankles to the ground
  double balance = 0.010;  // m, of the projected centre of mass inside the support polygon
  double ground = 2e-4;    // m, by which a sole that touches down may be lower than the ground
  double slip = 2e-4;      // m and rad, by which the second sole of a double support may be off its place
};

// Who stands: `foot` fast at `at` (world); in double support the other sole at `second` (in the support sole's frame).
struct Support {
  Side foot = Side::kRight;
  Isometry3d at = Isometry3d::Identity();
  bool both = false;
  Isometry3d second = Isometry3d::Identity();
};

enum class Fault { kNone, kLimit, kSelf, kGround, kObstacle, kBalance, kSlip };

// Figures of a posture, for reports and for the paper's 'error'.
struct Balance {
  double margin = 0.0;  // m, from the projected centre of mass to the support polygon's nearest edge; positive inside
  double error = 0.0;   // m, to the centre of the supporting sole (paper, Figure 15); in double support: to the middle of both
};

class Judge {
 public:
  Judge(const Model& model, Demands demands, const std::vector<Prism>& obstacles = {});
  ~Judge();

  // One posture.
  Fault posture(const Joints& joints, const Support& support);
  // The straight line between two postures, certified. `a` and `b` themselves included. `swing_on_ground`: bit 0 (at a), bit 1 (at
  // b): there the swing sole touches the ground, elsewhere it has to be above it.
  Fault motion(const Joints& a, const Joints& b, const Support& support, unsigned swing_on_ground = 0);
  // Of a posture and of a motion only whether the obstacles are kept clear of: for what was judged without them. `clears` of a
  // motion is certified, as motion() is.
  bool clears(const Joints& joints, const Support& support);
  bool clears(const Joints& a, const Joints& b, const Support& support);
  Balance balance(const Joints& joints, const Support& support);
  const Demands& demands() const;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace foothold::bioloid
