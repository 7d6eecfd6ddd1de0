// The paper's three strategies for a change of slope (section 3), each as printed, and the choice between them (section 4.2).
//
// All start from a robot that stands on its footholds with its thorax at some pose, as after the slope changed under it. Metres,
// radians, world frame. Values; any thread.
#pragma once

#include <string>
#include <vector>

#include "hexpiderix/stance/stance.hpp"

namespace foothold::hexpiderix {

// Where the robot stands before it adapts.
struct Situation {
  Plane ground;
  Footholds footholds;
  Isometry3d thorax = Isometry3d::Identity();
  double clearance = 0.0;  // m
  // Where legs that join may stand: in each, `supports` are the legs that have ground there and reach it as the robot stands.
  // Empty: the points in `footholds`.
  std::vector<Footholds> places;
};

struct Adapted {
  enum class Strategy { kNone, kConstantOrientation, kGeometric, kEmergency };
  Strategy strategy = Strategy::kNone;
  Footholds footholds;    // the situation's, and the leg that emergency adds
  Evaluation evaluation;  // invalid: the strategy is refused, reason() says why
  std::string about;      // "X axis by 22.5 deg, support line L3-L5", "leg 1 added"
  bool stable() const { return evaluation.valid() && evaluation.nesm > 0.0; }
};
const char* name(Adapted::Strategy strategy);

// The situation as it is: swing legs at their lift.
Evaluation as_it_stands(const Model& model, const Situation& from);

// 3.1: the thorax level about X and Y, heading and place kept; swing legs hang as they always do. Refused where a leg meets the
// ground.
Adapted constant_orientation(const Model& model, const Situation& from);

// 3.2: the support line between the two legs of the triad whose heights over the horizontal (eq. 8 and the thorax' orientation)
// differ least decides the axis: Y for L3-L5 and L6-L2, X for the others. The thorax turns back about it by `share` of its
// inclination about that axis (paper: half), swing legs are raised clear of the ground. Refused unless the supports are a triad.
Adapted geometric(const Model& model, const Situation& from, double share = 0.5);

// A leg's height by eq. 8, in the thorax' frame: how far its foot lies below the coxa axes.
double leg_height(const Model& model, const Vector3d& joints);

// 3.3: one more supporting leg.
enum class EmergencyRule {
  kLongestDistance,  // paper: among u1 to u12 (eq. 9), ties by the sum of the distances to all supports
  kBestMargin,       // ours: the leg with the greatest NESM
};
// The added leg stands on the ground where it stands in the standing robot; the thorax keeps its pose, then is turned level by as
// much as all supporting legs still reach.
Adapted emergency(const Model& model, const Situation& from, EmergencyRule rule);

// 4.2: keep a stable posture; else the better of constant orientation and geometric by the distance from the support lines to the
// projected centre of mass; else emergency by the paper's rule.
Adapted chosen(const Model& model, const Situation& from);

// The twelve distances of eq. 9, m: u1 to u3 between the legs of triad 2, u4 to u6 of triad 1, u7 to u12 round the hexagon.
struct Distance {
  std::size_t a, b;
  double metres;
};
std::vector<Distance> distances(const Footholds& footholds);

}  // namespace foothold::hexpiderix
