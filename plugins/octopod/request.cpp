// Start, goal and parameters of a request, with a named field for everything that cannot be planned for.
#include "octopod/request.hpp"

#include <cmath>
#include <sstream>

#include "foothold/refuse.hpp"
#include "terrain/surface.hpp"

namespace foothold::octopod {
namespace {

std::string in_words(const Vector3d& p) {
  std::ostringstream out;
  out << "(" << p.x() << ", " << p.y() << ", " << p.z() << ") m";
  return out.str();
}

// The node under a placement that must be a base alone.
int node_under(const Ground& ground, const Options& options, const Placement& placement, const std::string& name) {
  if (!placement.contacts.empty())
    refuse_request(name + ".contacts", "are not read: give ", name,
                   ".base, a point of the terrain; the planner finds the feet's places");
  if (!placement.joints.empty())
    refuse_request(name + ".joints", "are not read: give ", name,
                   ".base, a point of the terrain; the planner finds the posture over it");
  if (!placement.base) refuse_request(name + ".base", "is missing: a point of the terrain, under the middle of the robot");
  const Vector3d at = placement.base->translation();
  const double off = ground.surface().nearest(at).distance;
  if (!(off <= options.snap))
    refuse_request(name + ".base.position", "lies ", off, " m from the terrain, at most ", options.snap,
                   " m are allowed (parameter snap): ", in_words(at));
  return ground.nearest_node(at);
}

// Why the robot cannot begin in a state; empty if it can.
std::string refusal(const Ground& ground, const Options& options, State state) {
  std::ostringstream out;
  const Built& built = ground.standing(state);
  if (built.hindrance != Hindrance::kNone) {
    out << "no posture: " << reason(built);
  } else if (options.route.stability && !ground.stable(state)) {
    const double needed = ground.critical_friction(state);
    out << "unstable: ";
    if (std::isfinite(needed))
      out << "needs a friction of " << needed << ", " << options.ground.friction << " is there";
    else
      out << "no friction is enough";
  } else if (options.route.stability && ground.slope(node_of(state)) > options.route.steepest) {
    out << "the ground falls by " << ground.slope(node_of(state)) << " rad, at most " << options.route.steepest
        << " are allowed (parameter node_slope)";
  }
  return out.str();
}

}  // namespace

Options read_options(const Parameters& parameters) {
  Options out;
  const std::string& method = parameters.text("method");
  out.method = method == "paper" ? Method::kPaper : method == "rrt" ? Method::kRrt : Method::kOptimal;
  out.transitions = parameters.flag("transitions");
  out.swing_height = parameters.real("swing_height");
  out.snap = parameters.real("snap");
  out.ground.resolution = parameters.real("resolution");
  const std::string& split = parameters.text("split");
  if (split == "slivers") out.ground.split = terrain::Split::kSlivers;
  if (split == "longest_side") out.ground.split = terrain::Split::kLongestSide;
  out.ground.neighbours = static_cast<int>(parameters.integer("neighbours"));
  out.ground.friction = parameters.real("friction");
  out.ground.cone_edges = static_cast<int>(parameters.integer("cone_edges"));
  out.ground.clearance = parameters.real("clearance");
  out.route.stability = parameters.flag("stability");
  if (out.ground.cone_edges == 1 || out.ground.cone_edges == 2)
    refuse_request("parameters.cone_edges", "must be 0 (the exact cone) or 3 at least, is ", out.ground.cone_edges);
  const double steepest = parameters.real("node_slope");
  out.route.steepest = steepest > 0.0 ? steepest : steepest_held(out.ground.friction, out.ground.cone_edges);
  out.route.weights = {parameters.real("place_weight"), parameters.real("orientation_weight"), parameters.real("joint_weight")};
  out.route.posture_weight = parameters.real("posture_weight");
  out.route.max_states = parameters.integer("max_states");
  out.route.samples = parameters.integer("samples");
  if (out.transitions && out.method == Method::kPaper)
    refuse_request("parameters.transitions", "are not known to method paper; set transitions to false with it");
  if (out.transitions && !out.route.stability)
    refuse_request("parameters.transitions", "lead from one stable stance to the next; set transitions to false when stability is");
  return out;
}

CheckOptions check_options(const Options& options) {
  return {options.route.stability, options.transitions, options.ground.friction, options.ground.cone_edges,
          options.ground.clearance};
}

State read_start(const Ground& ground, const Options& options, const Request& request) {
  const Placement& start = request.start;
  const int node = node_under(ground, options, start, "start");
  const Vector3d at = ground.place(node);
  Vector3d ahead = Vector3d::UnitX();
  if (!start.any_orientation)
    ahead = start.base->linear().col(0);
  else if (request.goal.base)
    ahead = request.goal.base->translation() - at;

  State best = -1;
  double most = 0.0;
  std::string because;
  for (int orientation = 0; orientation < kOrientations; ++orientation) {
    const State state = kOrientations * node + orientation;
    const std::string refused = start.any_orientation ? refusal(ground, options, state) : "";
    if (!refused.empty()) {
      // Opposite headings share their feet and so their reasons.
      if (orientation < kAxes) because += (because.empty() ? "" : "; ") + refused;
      continue;
    }
    const double along = axis_of(ground.normal(node), orientation).dot(ahead);
    if (best < 0 || along > most) best = state, most = along;
  }
  const std::string where = " over the nearest node " + in_words(at);
  if (best < 0) refuse_request("start.base.position", "the robot cannot begin", where, " in any orientation: ", because);
  const std::string refused = refusal(ground, options, best);
  if (!refused.empty())
    refuse_request("start.base", "the robot cannot begin", where, " in this orientation: ", refused,
                   "; any_orientation tries the others");
  return best;
}

int read_goal(const Ground& ground, const Options& options, const Placement& goal) {
  const int node = node_under(ground, options, goal, "goal");
  if (!goal.any_orientation)
    refuse_request("goal.any_orientation", "must be set: the goal is a point of the terrain, in whichever orientation costs least");
  return node;
}

}  // namespace foothold::octopod
