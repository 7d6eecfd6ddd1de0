// What a request asks of HyReCRo: parameters, start and goal, judged and converted.
#pragma once

#include <optional>
#include <vector>

#include "foothold/planner.hpp"
#include "hyrecro/motion/motion.hpp"
#include "hyrecro/optimal/optimal.hpp"
#include "hyrecro/paper/paper.hpp"

namespace foothold::hyrecro {

enum class Method { kOptimal, kPaper };
enum class ReachabilityKind { kExact, kNetwork, kIterative };

struct Options {
  Method method = Method::kOptimal;
  ReachabilityKind reachability = ReachabilityKind::kExact;
  bool motion = true;
  double clearance = 0.0;                          // m
  double position_step = 0.0, heading_step = 0.0;  // m, rad, of the planar workspace
  int tries = 0;
  SamplingOptions sampling;
  PaperOptions paper;
  OptimalOptions optimal;
  MotionOptions motions;
};

// Throws InvalidRequest for combinations that make no sense, with the parameter at fault.
Options read_options(const Parameters& parameters);

// How far off its plane (m) and its normal (rad) a contact of a request may stand to count as on the face.
inline constexpr double kContactTolerance = 1e-4;

// One foot on the truss.
struct Grip {
  Foot foot = Foot::kA;
  Foothold at;
};

// Where the robot stands. One grip: the other foot is in the air.
struct Start {
  std::vector<Grip> grips;                 // one or two; A first if there are two
  std::optional<Coordinates> coordinates;  // seen from grips[0], if the request gives joints
};

// Throws InvalidRequest: no, too many or the same limbs' contacts, contacts off every face or overhanging, joints that are out of
// range or do not lead from one contact to the other.
Start read_start(const Model& model, const PreparedTruss& scene, const Placement& start);

// Throws InvalidRequest. The goal is one foothold, for either foot.
Foothold read_goal(const Model& model, const PreparedTruss& scene, const Placement& goal);

}  // namespace foothold::hyrecro
