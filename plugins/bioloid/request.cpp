// Start, goal and parameters of a request, with a named field for everything that cannot be planned for.
#include "bioloid/request.hpp"

#include <cmath>

#include "bioloid/sending.hpp"
#include "foothold/refuse.hpp"

namespace foothold::bioloid {
namespace {

constexpr double kOnGround = 1e-4;  // m and rad, of a given sole from level ground

// What to name when a place and when a direction is at fault.
struct Fields {
  std::string place, direction;
};
Fields fields_of(const std::string& frame) { return {frame + ".position", frame + ".orientation"}; }

// A level pose on the ground.
PlanarPose planar(const Isometry3d& pose, const Fields& fields, const char* what) {
  const Vector3d up = pose.linear().col(2), ahead = pose.linear().col(0);
  if (std::abs(pose.translation().z()) > kOnGround)
    refuse_request(fields.place, what, " must lie on the ground, z = 0; z is ", pose.translation().z(), " m");
  if (std::acos(std::min(1.0, up.z())) > kOnGround)
    refuse_request(fields.direction, what, " must be level; it leans by ", std::acos(std::clamp(up.z(), -1.0, 1.0)), " rad");
  return {pose.translation().x(), pose.translation().y(), std::atan2(ahead.y(), ahead.x())};
}

Side side_of(const Contact& contact, const std::string& field) {
  if (contact.limb == name_at(kLimbs, 0)) return Side::kRight;
  if (contact.limb == name_at(kLimbs, 1)) return Side::kLeft;
  refuse_request(field + ".limb", "must be one of ", kLimbs, ", is '", contact.limb, "'");
}

Feet read_feet(const std::vector<Contact>& contacts, const std::string& whose) {
  if (contacts.size() != 2) refuse_request(whose + ".contacts", "must be both feet, ", kLimbs, "; ", contacts.size(), " are given");
  Feet out;
  std::array<bool, 2> given{};
  for (std::size_t k = 0; k < 2; ++k) {
    const std::string field = whose + ".contacts[" + std::to_string(k) + "]";
    const Side side = side_of(contacts[k], field);
    if (given[index_of(side)]) refuse_request(field + ".limb", contacts[k].limb, " is given twice");
    given[index_of(side)] = true;
    out.of(side) = planar(contacts[k].frame, fields_of(field + ".frame"), "a sole");
  }
  return out;
}

double half_spacing(const Model& model) { return 0.5 * std::abs(beside(model, Side::kRight).y); }

Joints read_joints(const Model& model, const std::vector<double>& given) {
  constexpr double kRounding = 1e-9;
  if (given.size() != kJoints)
    refuse_request("start.joints", "must be ", kJoints, " values, are ", given.size(), ": ", kJointNames);
  Joints out;
  for (std::size_t k = 0; k < kJoints; ++k) {
    const kinematics::Interval& limits = model.joints[k].limits;
    if (!limits.holds(given[k], kRounding))
      refuse_request("start.joints[" + std::to_string(k) + "]", name_at(kJointNames, k), " must be between ", limits.low, " and ",
                     limits.high, " rad, is ", given[k]);
    out[static_cast<Eigen::Index>(k)] = given[k];
  }
  return out;
}

Stand as_joints_say(const Model& model, const Placement& start) {
  Stand out;
  out.midway = false;
  out.joints = read_joints(model, start.joints);
  const Isometry3d right = sole_in_torso(model, Side::kRight, out.joints), left = sole_in_torso(model, Side::kLeft, out.joints);
  if (start.base) {
    out.feet.right = planar(*start.base * right, {"start.base.position", "start.joints"}, "the right sole, by base and joints,");
    out.feet.left = planar(*start.base * left, {"start.joints", "start.joints"}, "the left sole, by base and joints,");
  }
  if (!start.contacts.empty()) {
    const Feet named = read_feet(start.contacts, "start");
    if (!start.base) {
      out.feet.right = named.right;
      out.feet.left =
          planar(to_world(named.right) * right.inverse() * left, {"start.joints", "start.joints"}, "the left sole, by the joints,");
    }
    for (const Side side : {Side::kRight, Side::kLeft}) {
      const PlanarPose off = relative(named.of(side), out.feet.of(side));
      if (std::hypot(off.x, off.y) > kOnGround || std::abs(wrapped(off.heading)) > kOnGround)
        refuse_request("start.contacts", "the joints bring ", name_at(kLimbs, index_of(side)), " ", std::hypot(off.x, off.y),
                       " m and ", std::abs(wrapped(off.heading)), " rad away from its contact");
    }
  }
  return out;
}

void demand_sound(Judge& judge, const Stand& stand, const char* field) {
  const Support both{.foot = Side::kRight,
                     .at = to_world(stand.feet.right),
                     .both = true,
                     .second = to_world(relative(stand.feet.right, stand.feet.left))};
  const Fault fault = judge.posture(stand.joints, both);
  if (fault == Fault::kNone) return;
  if (fault == Fault::kBalance)
    refuse_request(field, "the robot would stand with its centre of mass ", judge.balance(stand.joints, both).margin,
                   " m inside its soles; ", judge.demands().balance, " m are asked for (parameter balance)");
  refuse_request(field, "the robot cannot stand there: ", words(fault));
}

// None: the method is optimal.
std::optional<PaperOptions> read_paper(const Parameters& parameters) {
  const std::string &method = parameters.text("method"), &choose = parameters.text("choose");
  if (method == "optimal") return std::nullopt;
  PaperOptions out;
  out.method.method = method == "random" ? paper::Method::kRandom : paper::Method::kStochastic;
  out.method.iterations = static_cast<std::size_t>(parameters.integer("iterations"));
  out.trials = static_cast<std::size_t>(parameters.integer("trials"));
  out.choice = choose == "error"      ? paper::Choice::kLeastError
               : choose == "variance" ? paper::Choice::kLeastVariance
                                      : paper::Choice::kFewestIterations;
  return out;
}

}  // namespace

Options read_options(const Parameters& parameters) {
  Options out;
  out.gait.paper = read_paper(parameters);
  // What the fully random method does not find for one row of footsteps in its iterations, it does not for others.
  if (out.gait.paper && out.gait.paper->method.method == paper::Method::kRandom) out.walk.most_routes = 1;
  StepOptions& steps = out.walk.steps;
  steps.length = parameters.real("step_length");
  steps.back = parameters.real("step_back");
  steps.width = parameters.real("step_width");
  steps.turn = parameters.real("turn");
  steps.cell = parameters.real("cell");
  steps.proof_nodes = static_cast<std::size_t>(parameters.integer("proof_nodes"));
  if (steps.length < steps.cell)
    refuse_request("parameters.step_length", "must be a cell at least, ", steps.cell, " m, is ", steps.length);
  out.walk.step_over = parameters.real("step_over");
  out.gait.lift = parameters.real("lift");
  out.gait.height = parameters.real("height");
  out.gait.demands.balance = parameters.real("balance");
  out.gait.demands.clearance = parameters.real("clearance");
  out.gait.pace = {parameters.real("pace"), parameters.real("period")};
  return out;
}

Stand read_start(const Model& model, const Options& options, const Ground& ground, const Placement& start) {
  if (start.any_orientation) refuse_request("start.any_orientation", "the start must be known");
  Judge judge(model, options.gait.demands, ground.prisms());
  if (!start.joints.empty()) {
    if (!start.base && start.contacts.empty())
      refuse_request("start.base", "is missing: the torso's pose; or give start.contacts, both soles");
    Stand out = as_joints_say(model, start);
    demand_sound(judge, out, "start.joints");
    return out;
  }
  Stand out;
  const char* field = "start.contacts";
  if (!start.contacts.empty()) {
    if (start.base) refuse_request("start.base", "is the torso's pose if joints are given; with contacts alone leave it out");
    out.feet = read_feet(start.contacts, "start");
  } else {
    if (!start.base)
      refuse_request("start.base",
                     "is missing: the point of the ground between the feet, and the heading; or both soles as contacts");
    field = "start.base";
    const PlanarPose base = planar(*start.base, fields_of(field), "the point between the feet");
    for (const Side side : {Side::kRight, Side::kLeft}) out.feet.of(side) = sole_at(side, base, half_spacing(model));
  }
  const auto posture = Gait(model, options.gait).midway(Side::kRight, rounded(relative(out.feet.right, out.feet.left)));
  if (!posture)
    refuse_request(field, "the legs do not reach both soles with the hips ", options.gait.height,
                   " m over the ankles (parameter height)");
  out.joints = posture->joints;
  demand_sound(judge, out, field);
  return out;
}

FootstepGoal read_goal(const Model& model, const Placement& goal) {
  if (!goal.joints.empty()) refuse_request("goal.joints", "are not planned for; give goal.base, the point to walk to");
  if (!goal.contacts.empty()) {
    if (goal.base) refuse_request("goal.base", "is given beside goal.contacts; leave one of them out");
    const Feet feet = read_feet(goal.contacts, "goal");
    const PlanarPose right = base_of(Side::kRight, feet.right, half_spacing(model)),
                     left = base_of(Side::kLeft, feet.left, half_spacing(model));
    if (distance(right, left) > kOnGround || std::abs(wrapped(right.heading - left.heading)) > kOnGround)
      refuse_request("goal.contacts", "must be side by side, ", 2.0 * half_spacing(model), " m apart and parallel: so a walk ends");
    return {right, goal.any_orientation};
  }
  if (!goal.base)
    refuse_request("goal.base", "is missing: the point of the ground to walk to, and the heading (or any_orientation)");
  if (goal.any_orientation) {
    const Vector3d at = goal.base->translation();
    if (std::abs(at.z()) > kOnGround) refuse_request("goal.base.position", "must lie on the ground, z = 0; z is ", at.z(), " m");
    return {{at.x(), at.y(), 0.0}, true};
  }
  return {planar(*goal.base, fields_of("goal.base"), "the goal"), false};
}

}  // namespace foothold::bioloid
