// Postures and motions: what is placed, in which order it is checked, and how a motion is halved.
#include "bioloid/posture/judge.hpp"

#include <cmath>

#include "bioloid/posture/inside.hpp"

namespace foothold::bioloid {
namespace {

constexpr int kDeepest = 8;  // halvings
const Bends kStill{};        // of a motion between equal postures

constexpr std::array<std::pair<Check, Fault>, 5> kFaults{{{kBalanceCheck, Fault::kBalance},
                                                          {kSlipCheck, Fault::kSlip},
                                                          {kGroundCheck, Fault::kGround},
                                                          {kSelfCheck, Fault::kSelf},
                                                          {kObstacleCheck, Fault::kObstacle}}};
Fault first_of(unsigned checks) {
  for (const auto& [check, fault] : kFaults)
    if (checks & check) return fault;
  return Fault::kNone;
}

}  // namespace

Judge::Inside::Inside(const Model& robot, Demands d, const std::vector<Prism>& prisms)
    : model(robot), demands(d), obstacles(prisms.begin(), prisms.end()), legs(model), mass(model.mass()), arm(arm_reach(model)) {
  constexpr double kRounding = 1e-12;
  for (const Side side : {Side::kRight, Side::kLeft}) {
    weights[index_of(side)] = Weights(model, side);
    const Body& bracket = model.bodies[leg_joint(side, 0) + 1];
    for (const BodyBox& box : bracket.boxes) bracket_reach = std::max(bracket_reach, box.centre.norm() + box.half.norm());
    bracket_boxes = bracket_boxes || !bracket.boxes.empty();
  }
  for (std::size_t j = 0; j < kJoints; ++j) {
    low[static_cast<int>(j)] = model.joints[j].limits.low - kRounding;
    high[static_cast<int>(j)] = model.joints[j].limits.high + kRounding;
  }
  for (std::size_t j = 0; j < kArmJoints; ++j) arms_mass += model.bodies[j + 1].mass;
  upper = upper_of(model, model.carrying.head<static_cast<int>(kArmJoints)>(), demands.clearance);
  // From one sole over both legs to the other's toes, or to the hands.
  reach = 2.0 * (legs.thigh_length + legs.shin_length + legs.sole_reach) + legs.hips_apart + upper.reach + arm;
}

void Judge::Inside::stand_on(const Support& support) {
  if (ground.is_for(support)) return;
  ground = Ground(model, support);
  stand_near(support);
}

bool Judge::Inside::within_limits(const Joints& joints) const {
  bool within = true;
  for (int j = 0; j < static_cast<int>(kJoints); ++j) within &= (joints[j] >= low[j]) & (joints[j] <= high[j]);
  return within;
}

void Judge::Inside::place(const Joints& joints, Snapshot& out) {
  out.joints = joints;
  evaluate(legs, joints, out.stand);
  const Arms arms = joints.head<static_cast<int>(kArmJoints)>();
  out.upper = &upper;
  if (arms != upper.arms) {
    out.own = std::make_unique<Upper>(upper_of(model, arms, demands.clearance));
    out.upper = out.own.get();
  }
  const Stand& at = out.stand;
  const Side foot = ground.support.foot;
  out.sole_turn << at.foot_x.at(foot), at.foot_y.at(foot), at.foot_z.at(foot);
  out.sole = at.sole.at(foot);
  const Vector3d moment = out.upper->moment + at.moment.at(Side::kRight) + at.moment.at(Side::kLeft);
  out.com = out.sole_turn.transpose() * (moment / mass - out.sole);
}

Fault Judge::Inside::posture_fault(const Snapshot& at, unsigned which) const {
  if ((which & kBalanceCheck) && !balanced(at, at, nullptr)) return Fault::kBalance;
  if ((which & kSlipCheck) && !keeps_place(at, at, nullptr)) return Fault::kSlip;
  if ((which & kGroundCheck) && !above_ground(at, at, nullptr, 0)) return Fault::kGround;
  if ((which & kSelfCheck) && !self_apart(at, at, nullptr)) return Fault::kSelf;
  if ((which & kObstacleCheck) && !clear_of_obstacles(at, at, nullptr)) return Fault::kObstacle;
  return Fault::kNone;
}

unsigned Judge::Inside::unproved(const Snapshot& a, const Snapshot& b, unsigned which, unsigned touching) const {
  const Rates rates(legs, a.joints, b.joints);
  const Bends bends = bends_of(a, rates);
  unsigned left = 0;
  if ((which & kBalanceCheck) && !balanced(a, b, &bends)) left |= kBalanceCheck;
  if ((which & kSlipCheck) && !keeps_place(a, b, &bends)) left |= kSlipCheck;
  if ((which & kGroundCheck) && !above_ground(a, b, &bends, touching)) left |= kGroundCheck;
  if ((which & kSelfCheck) && !self_apart(a, b, &rates)) left |= kSelfCheck;
  if ((which & kObstacleCheck) && !clear_of_obstacles(a, b, &bends)) left |= kObstacleCheck;
  return left;
}

Fault Judge::Inside::certify(const Snapshot& a, const Snapshot& b, unsigned which, unsigned touching, int depth) {
  const unsigned left = unproved(a, b, which, touching);
  if (left == 0) return Fault::kNone;
  if (depth == 0) {
    for (const Snapshot* end : {&a, &b})
      if (const Fault fault = posture_fault(*end, left); fault != Fault::kNone) return fault;
    if (((touching & kTouchesAtA) && !above_ground(a, a, &kStill, kTouchesAtA)) ||
        ((touching & kTouchesAtB) && !above_ground(b, b, &kStill, kTouchesAtB)))
      return Fault::kGround;
  }
  if (depth == kDeepest) return first_of(left);
  Snapshot middle;
  place(0.5 * (a.joints + b.joints), middle);
  if (const Fault fault = posture_fault(middle, left); fault != Fault::kNone) return fault;
  if (const Fault fault = certify(a, middle, left, touching & ~kTouchesAtB, depth + 1); fault != Fault::kNone) return fault;
  return certify(middle, b, left, touching & ~kTouchesAtA, depth + 1);
}

Judge::Judge(const Model& model, Demands demands, const std::vector<Prism>& obstacles)
    : inside_(std::make_unique<Inside>(model, demands, obstacles)) {}
Judge::~Judge() = default;

Fault Judge::posture(const Joints& joints, const Support& support) {
  if (!inside_->within_limits(joints)) return Fault::kLimit;
  inside_->stand_on(support);
  Snapshot at;
  inside_->place(joints, at);
  return inside_->posture_fault(at, kAllChecks);
}

Fault Judge::motion(const Joints& a, const Joints& b, const Support& support, unsigned swing_on_ground) {
  if (!inside_->within_limits(a) || !inside_->within_limits(b)) return Fault::kLimit;
  inside_->stand_on(support);
  Snapshot from, to;
  inside_->place(a, from);
  inside_->place(b, to);
  const unsigned touching = (swing_on_ground & 3U) | ((swing_on_ground & 3U) ? kTouchesSomewhere : 0U);
  return inside_->certify(from, to, kAllChecks, touching, 0);
}

bool Judge::clears(const Joints& joints, const Support& support) {
  inside_->stand_on(support);
  if (inside_->near.empty()) return true;
  Snapshot at;
  inside_->place(joints, at);
  return inside_->posture_fault(at, kObstacleCheck) == Fault::kNone;
}

bool Judge::clears(const Joints& a, const Joints& b, const Support& support) {
  inside_->stand_on(support);
  if (inside_->near.empty()) return true;
  Snapshot from, to;
  inside_->place(a, from);
  inside_->place(b, to);
  return inside_->certify(from, to, kObstacleCheck, 0, 0) == Fault::kNone;
}

Balance Judge::balance(const Joints& joints, const Support& support) {
  inside_->stand_on(support);
  Snapshot at;
  inside_->place(joints, at);
  return {contact::projected_margin(inside_->ground.polygon, at.com), (at.com.head<2>() - inside_->ground.middle).norm()};
}

const Demands& Judge::demands() const { return inside_->demands; }

}  // namespace foothold::bioloid
