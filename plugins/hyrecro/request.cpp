// Start, goal and parameters of a request, with a named field for everything that cannot be planned for.
#include "hyrecro/request.hpp"

#include <cmath>
#include <numbers>

#include "foothold/refuse.hpp"
#include "hyrecro/motion/rise.hpp"
#include "hyrecro/place.hpp"
#include "hyrecro/reach/network.hpp"

namespace foothold::hyrecro {
namespace {

constexpr double kJointTolerance = 1e-6;    // m, beyond an actuator's limits
constexpr double kPostureTolerance = 1e-5;  // m and rad, between contacts and joints that a request gives

void demand_default(const Parameters& parameters, const char* name, const char* value) {
  if (parameters.text(name) != value)
    refuse_request(std::string("parameters.") + name, "is of method paper; method optimal takes ", value, " alone");
}

Foot foot_of(const Contact& contact, const std::string& field) {
  if (contact.limb.empty() || contact.limb == "A") return Foot::kA;
  if (contact.limb != "B") refuse_request(field + ".limb", "must be A or B, is '", contact.limb, "'");
  return Foot::kB;
}

Coordinates read_joints(const Model& model, const std::vector<double>& joints, Foot first) {
  if (joints.size() != kJoints)
    refuse_request("start.joints", "must be ", kJoints, " values, are ", joints.size(), ": ", kJointNames);
  for (std::size_t k = 0; k < 8; ++k) {
    const double least = model.mechanism.shortest(), most = model.mechanism.longest();
    if (!(joints[k] >= least - kJointTolerance && joints[k] <= most + kJointTolerance))
      refuse_request("start.joints[" + std::to_string(k) + "]", "must be between ", least, " and ", most, " m, is ", joints[k]);
  }
  return from_joints(model, joints, first);
}

double turn_between(const Isometry3d& a, const Isometry3d& b) {
  return Eigen::AngleAxisd(a.linear().transpose() * b.linear()).angle();
}

}  // namespace

Options read_options(const Parameters& parameters) {
  Options out;
  out.method = parameters.text("method") == "paper" ? Method::kPaper : Method::kOptimal;
  const std::string& reachability = parameters.text("reachability");
  if (reachability == "network") out.reachability = ReachabilityKind::kNetwork;
  if (reachability == "iterative") out.reachability = ReachabilityKind::kIterative;
  if (out.method == Method::kOptimal) {
    demand_default(parameters, "reachability", "exact");
    demand_default(parameters, "face_rule", "paper");
    demand_default(parameters, "face_way", "visibility");
  }
  out.optimal.objective = parameters.text("objective") == "distance" ? Objective::kDistance : Objective::kSteps;
  if (out.method == Method::kPaper && out.optimal.objective == Objective::kDistance)
    refuse_request("parameters.objective", "method paper knows no objective; take method optimal");
  out.optimal.max_nodes = static_cast<std::size_t>(parameters.integer("max_nodes"));
  out.motion = parameters.flag("motion");
  out.clearance = parameters.real("clearance");
  if (const double known = shipped_perceptron(PoseKind::kTransition).clearance;
      out.reachability == ReachabilityKind::kNetwork && out.clearance != known)
    refuse_request("parameters.clearance", "the networks know ", known, " m alone, not ", out.clearance,
                   "; take reachability exact");
  out.position_step = parameters.real("position_step");
  out.heading_step = parameters.real("heading_step");
  const double turns = 2.0 * std::numbers::pi / out.heading_step;
  if (std::abs(turns - std::round(turns)) > 1e-6)
    refuse_request("parameters.heading_step", "must divide a whole turn, of which it makes one in ", turns, " steps");
  // Some digits are lost on the wire; the workspace closes exactly.
  out.heading_step = 2.0 * std::numbers::pi / std::round(turns);
  out.tries = static_cast<int>(parameters.integer("tries"));
  out.sampling = {parameters.real("d_cnvx"), parameters.real("d_cncv"), parameters.real("transition_step")};
  out.paper.rule = parameters.text("face_rule") == "zhu" ? FaceRule::kZhu : FaceRule::kPaper;
  out.paper.way = parameters.text("face_way") == "grid" ? FaceWay::kGrid : FaceWay::kVisibility;
  out.paper.safe_inset = parameters.real("d_cnvx");
  out.paper.least_dot = parameters.real("least_dot");
  out.motions.clearance = out.clearance;
  out.motions.lift = parameters.real("lift");
  if (out.motion) out.optimal.lift = out.paper.lift = kLiftFactor * out.motions.lift;
  return out;
}

Start read_start(const Model& model, const PreparedTruss& scene, const Placement& start) {
  if (start.any_orientation) refuse_request("start.any_orientation", "the start must be known");
  if (start.base) refuse_request("start.base", "is not read: contacts and joints say where the robot stands");
  if (start.contacts.empty()) refuse_request("start.contacts", "is missing: where one foot holds, or both");
  if (start.contacts.size() > 2)
    refuse_request("start.contacts", "the robot has two feet, ", start.contacts.size(), " contacts are given");
  Start out;
  for (std::size_t k = 0; k < start.contacts.size(); ++k) {
    const std::string field = "start.contacts[" + std::to_string(k) + "]";
    const Contact& contact = start.contacts[k];
    if (contact.limb.empty() && start.contacts.size() == 2) refuse_request(field + ".limb", "must be A or B where both feet hold");
    const Foot foot = foot_of(contact, field);
    out.grips.push_back({foot, place_of(model, scene.truss, contact, field, kContactTolerance)});
  }
  if (out.grips.size() == 2) {
    if (out.grips[0].foot == out.grips[1].foot)
      refuse_request("start.contacts[1].limb", "is that of contacts[0]: A holds and B holds");
    if (out.grips[0].foot == Foot::kB) std::swap(out.grips[0], out.grips[1]);
  }
  if (start.joints.empty()) return out;
  out.coordinates = read_joints(model, start.joints, out.grips[0].foot);
  if (out.grips.size() == 2) {
    const Isometry3d wanted = pose_of(scene.truss, out.grips[0].at).inverse() * pose_of(scene.truss, out.grips[1].at);
    const Isometry3d is = forward(model, *out.coordinates);
    const double off = (wanted.translation() - is.translation()).norm(), turned = turn_between(wanted, is);
    if (off > kPostureTolerance || turned > kPostureTolerance)
      refuse_request("start.joints", "lead from foot A to a place ", off, " m and ", turned, " rad off the contact of foot B");
  }
  return out;
}

Foothold read_goal(const Model& model, const PreparedTruss& scene, const Placement& goal) {
  if (goal.base) refuse_request("goal.base", "is not planned for; give goal.contacts, one foothold");
  if (!goal.joints.empty()) refuse_request("goal.joints", "are not planned for; give goal.contacts, one foothold");
  if (goal.any_orientation) refuse_request("goal.any_orientation", "a foothold has a heading; give the contact's orientation");
  if (goal.contacts.size() != 1)
    refuse_request("goal.contacts", "must be one foothold, ",
                   goal.contacts.empty() ? std::string("none is") : std::to_string(goal.contacts.size()) + " are", " given");
  if (!goal.contacts[0].limb.empty())
    refuse_request("goal.contacts[0].limb", "either foot may end at the goal; leave the limb out");
  return place_of(model, scene.truss, goal.contacts[0], "goal.contacts[0]", kContactTolerance);
}

}  // namespace foothold::hyrecro
