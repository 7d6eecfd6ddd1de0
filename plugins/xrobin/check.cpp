// Residuals of the closed chain, from the pins' positions in the world.
#include "check.hpp"

#include <algorithm>

#include "chain.hpp"
#include "check_clear.hpp"

namespace foothold::xrobin {
namespace {

constexpr double kLengthTolerance = 1e-7;     // m: residuals of the closed chain
constexpr double kAngleTolerance = 1e-7;      // rad
constexpr double kLeastRegularity = 1e-3;     // of det J, scaled by b p: 0 is singular
constexpr double kClearanceTolerance = 1e-7;  // m: rounding of poses
constexpr double kLongestLeap = 0.02;         // m: between two motion points; more could hide a change of branch

double apart(const Isometry3d& a, const Isometry3d& b) { return (a.translation() - b.translation()).norm(); }

bool same(const Isometry3d& a, const Isometry3d& b) {
  return apart(a, b) <= kLengthTolerance && (a.linear() - b.linear()).norm() <= kAngleTolerance;
}

// B in the slot, pistons as long as said. `what` names the posture.
void demand_closed(const Lengths& n, const Relative& b, const std::vector<double>& joints, const std::string& what) {
  if (joints.size() != 2) refuse(what, ": two piston lengths are needed, ", joints.size(), " are given");
  if (std::abs(b.position.x()) > kLengthTolerance) refuse(what, ": body B is ", b.position.x(), " m beside the slot");
  const Pistons is = measured(n, b);
  for (const auto& [name, said, length] : {std::tuple{"l", joints[0], is.l}, std::tuple{"r", joints[1], is.r}})
    if (std::abs(said - length) > kLengthTolerance)
      refuse(what, ": piston ", name, " is ", said, " m long, its pins are ", length, " m apart");
}

// det d(l^2, r^2)/d(phi, y) up to a factor: y^2 cos phi + b p sin^2 phi, scaled by b p.
double regularity(const Lengths& n, const Relative& b) {
  const double s = std::sin(b.turn);
  return (b.position.y() * b.position.y() * std::cos(b.turn) + n.b * n.p * s * s) / (n.b * n.p);
}

bool at_end(double length, const Lengths& n) {
  return std::abs(length - n.retracted) <= kLengthTolerance || std::abs(length - n.extended) <= kLengthTolerance;
}

// Walks along the motion and returns the least regularity on it.
double judge_motion(const Lengths& n, const Step& step, bool a_holds, const Isometry3d& a_before, const Isometry3d& b_before,
                    const Relative& from, const Relative& to, const std::vector<double>& joints_before) {
  double least = std::min(regularity(n, from), regularity(n, to));
  if (step.motion.empty()) {
    if ((from.position - to.position).norm() > kLengthTolerance || std::abs(from.turn - to.turn) > kAngleTolerance)
      refuse("the moving body moves, but no motion is given");
    return least;
  }
  Relative now = from;
  double time = 0.0;
  std::vector<double> joints = joints_before;
  for (std::size_t k = 0; k < step.motion.size(); ++k) {
    const MotionPoint& point = step.motion[k];
    const std::string what = "motion point " + std::to_string(k);
    if (point.joints.size() != 2) refuse(what, ": two piston lengths are needed, ", point.joints.size(), " are given");
    if (!(point.time >= time)) refuse(what, ": time runs backwards");
    if (a_holds && !same(point.base, a_before)) refuse(what, ": body A holds, but moves by ", apart(point.base, a_before), " m");
    const Relative next = a_holds ? follow(n, now, point.joints[0], point.joints[1]) : relative(point.base, b_before);
    demand_closed(n, next, point.joints, what);
    if ((next.position - now.position).norm() + n.p * std::abs(next.turn - now.turn) > kLongestLeap)
      refuse(what, ": leaps by more than ", kLongestLeap, " m");
    if (!at_end(point.joints[0], n) && !at_end(point.joints[1], n)) refuse(what, ": both pistons are between their ends");
    if (std::abs(point.joints[0] - joints[0]) > kLengthTolerance && std::abs(point.joints[1] - joints[1]) > kLengthTolerance)
      refuse(what, ": both pistons move at once");
    least = std::min(least, regularity(n, next));
    now = next, time = point.time, joints = point.joints;
  }
  if ((now.position - to.position).norm() > kLengthTolerance || std::abs(now.turn - to.turn) > kAngleTolerance)
    refuse("the motion ends ", (now.position - to.position).norm(), " m and ", std::abs(now.turn - to.turn),
           " rad away from the step's posture");
  return least;
}

StepVerdict judge(const Lengths& n, const Step& step, const Posture& before) {
  const Isometry3d a0 = body(limb(before, "A").frame), b0 = body(limb(before, "B").frame);
  const Isometry3d a1 = body(limb(step.after, "A").frame), b1 = body(limb(step.after, "B").frame);
  if (step.placed.size() != 1) refuse("one body is placed in a step, not ", step.placed.size());
  const std::string& moving = step.placed.front().limb;
  if (moving != "A" && moving != "B") refuse("there is no body '", moving, "'");
  const bool a_holds = moving == "B";
  const Isometry3d& held_before = a_holds ? a0 : b0;
  const Isometry3d& held_after = a_holds ? a1 : b1;
  if (!same(held_before, held_after))
    refuse("body ", a_holds ? "A" : "B", " holds, but moves by ", apart(held_before, held_after), " m");
  if (!same(step.placed.front().frame, limb(step.after, moving.c_str()).frame))
    refuse("body ", moving, " is placed where it is not");
  if (!same(step.after.base, a1)) refuse("the base is not where body A is");

  const Relative from = relative(a0, b0);
  const Relative to = relative(a1, b1);
  demand_closed(n, from, before.joints, "the posture before");
  demand_closed(n, to, step.after.joints, "the posture after");
  for (const double length : step.after.joints)
    if (!at_end(length, n)) refuse("a piston of ", length, " m is neither retracted nor extended");
  const double least = judge_motion(n, step, a_holds, a0, b0, from, to, before.joints);
  if (!(least >= kLeastRegularity)) refuse("the motion comes too near to the singular posture: regularity ", least);
  return {true, "", {{"regularity", least, kLeastRegularity, "1"}}};
}

}  // namespace

StepVerdict check_step(const Lengths& lengths, const Step& step, const Posture& before) {
  try {
    return judge(lengths, step, before);
  } catch (const Refusal& refusal) {
    return {false, refusal.reason, {}};
  }
}

StepVerdict check_step_among(const Lengths& lengths, const Bodies& bodies, const std::vector<geometry::Obstacle>& obstacles,
                             double clearance, const Step& step, const Posture& before) {
  StepVerdict verdict = check_step(lengths, step, before);
  if (!verdict.accepted || obstacles.empty()) return verdict;
  const Clearance is = least_clearance(lengths, bodies, obstacles, step, before);
  if (is.obstacle.empty()) return verdict;
  const double least = clearance - kClearanceTolerance;
  if (!(is.least >= least && is.least > 0.0)) {
    std::ostringstream reason;
    reason << "comes within " << is.least << " m of obstacle '" << is.obstacle << "', " << clearance << " m must be kept";
    return {false, reason.str(), {}};
  }
  verdict.margins.push_back({"clearance", is.least, least, "m"});
  return verdict;
}

}  // namespace foothold::xrobin
