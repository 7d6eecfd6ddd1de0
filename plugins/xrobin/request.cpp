// Start and goal of a request, with a named field for everything that cannot be planned for.
#include "request.hpp"

#include <algorithm>

#include "foothold/refuse.hpp"

namespace foothold::xrobin {
namespace {

constexpr double kPlaneTolerance = 1e-6;    // m and rad: off the plane
constexpr double kPostureTolerance = 1e-5;  // m and rad: contacts given by hand

void demand_planar(const std::string& field, const Isometry3d& pose, bool orientation_counts) {
  if (!pose.matrix().allFinite()) refuse_request(field, "must be finite");
  if (std::abs(pose.translation().z()) > kPlaneTolerance)
    refuse_request(field + ".position", "must lie in the plane z = 0, is at z = ", pose.translation().z(), " m");
  if (orientation_counts && std::abs(pose(2, 2) - 1.0) > kPlaneTolerance)
    refuse_request(field + ".orientation", "must be a turn about z only");
}

PlanarPose planar(const Isometry3d& pose) {
  return {pose.translation().x(), pose.translation().y(), std::atan2(pose(1, 0), pose(0, 0))};
}

// The configuration in which B is to A, from both contacts.
int configuration_between(const Mechanism& mechanism, const PlanarPose& a, const PlanarPose& b) {
  const PlanarPose is = inverse(a) * b;
  for (const Configuration& c : mechanism.configurations()) {
    const PlanarPose at = mechanism.b_in_a(c.number);
    if (distance(is, at) <= kPostureTolerance && std::abs(wrapped(is.heading - at.heading)) <= kPostureTolerance) return c.number;
  }
  refuse_request("start.contacts", "body B is in none of the eight configurations to body A: at (", is.x, ", ", is.y,
                 ") m, turned by ", wrapped(is.heading), " rad");
}

}  // namespace

Stance read_start(const Mechanism& mechanism, const Placement& start, const Parameters& parameters) {
  Stance stance{{}, static_cast<int>(parameters.integer("start_configuration"))};
  if (start.any_orientation) refuse_request("start.any_orientation", "the start must be known");
  if (start.base) {
    demand_planar("start.base", *start.base, true);
    stance.a = planar(*start.base);
  }
  if (!start.contacts.empty()) {
    if (start.contacts.size() != 2 || start.contacts[0].limb == start.contacts[1].limb)
      refuse_request("start.contacts", "must be those of both bodies, A and B, or left out");
    PlanarPose bodies[2];
    for (std::size_t k = 0; k < 2; ++k) {
      const Contact& c = start.contacts[k];
      const std::string field = "start.contacts[" + std::to_string(k) + "]";
      if (c.limb != "A" && c.limb != "B") refuse_request(field + ".limb", "must be A or B, is '", c.limb, "'");
      demand_planar(field + ".frame", c.frame, true);
      bodies[c.limb == "A" ? 0 : 1] = body_of_contact(c.frame);
    }
    if (start.base && (distance(stance.a, bodies[0]) > kPostureTolerance ||
                       std::abs(wrapped(stance.a.heading - bodies[0].heading)) > kPostureTolerance))
      refuse_request("start.base", "is not where the contact of body A is");
    stance = {bodies[0], configuration_between(mechanism, bodies[0], bodies[1])};
  }
  if (!start.joints.empty()) {
    if (start.joints.size() != 2)
      refuse_request("start.joints", "must be the lengths of both pistons, holds ", start.joints.size(), " values");
    const Pistons are = mechanism.pistons(stance.configuration);
    if (!(std::abs(start.joints[0] - are.l) <= kPostureTolerance && std::abs(start.joints[1] - are.r) <= kPostureTolerance))
      refuse_request("start.joints", "must be ", are.l, " and ", are.r, " m in configuration ", stance.configuration, ", are ",
                     start.joints[0], " and ", start.joints[1], " m");
  }
  return stance;
}

Target read_goal(const Placement& goal, const Parameters& parameters) {
  if (!goal.base) refuse_request("goal.base", "is missing: where body A shall be");
  if (!goal.contacts.empty()) refuse_request("goal.contacts", "are not planned for; give goal.base, where body A shall be");
  if (!goal.joints.empty()) refuse_request("goal.joints", "are not planned for; give goal.base, where body A shall be");
  demand_planar("goal.base", *goal.base, !goal.any_orientation);
  const PlanarPose at = planar(*goal.base);
  Target target{at.x, at.y, std::nullopt, parameters.real("heading_tolerance")};
  if (!goal.any_orientation) target.heading = at.heading;
  return target;
}

}  // namespace foothold::xrobin
