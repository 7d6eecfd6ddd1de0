// Start and parameters of a request, with a named field for everything that cannot be planned for.
#include "hexpiderix/request.hpp"

#include <array>
#include <cmath>

#include "foothold/refuse.hpp"

namespace foothold::hexpiderix {
namespace {

constexpr double kOnGround = 1e-4;  // m, between a supporting foot of a given posture and the ground

std::size_t leg_of(const Contact& contact, const std::string& field) {
  for (std::size_t leg = 0; leg < kLegs; ++leg)
    if (contact.limb == "L" + std::to_string(leg + 1)) return leg;
  refuse_request(field + ".limb", "must be one of ", kLimbs, ", is '", contact.limb, "'");
}

void demand_joints(const Model& model, const std::vector<double>& joints) {
  constexpr std::size_t kJoints = 3 * kLegs;
  constexpr double kRounding = 1e-9;
  if (joints.size() != kJoints)
    refuse_request("start.joints", "must be ", kJoints, " values, are ", joints.size(), ": ", kJointNames);
  for (std::size_t k = 0; k < kJoints; ++k)
    if (!model.limits[k % 3].holds(joints[k], kRounding))
      refuse_request("start.joints[" + std::to_string(k) + "]", "must be between ", model.limits[k % 3].low, " and ",
                     model.limits[k % 3].high, " rad, is ", joints[k]);
}

// The ground's point nearest to a base.
Vector3d on_ground(const Ground& ground, const Options& options, const Isometry3d& base, const char* whose) {
  const terrain::Nearest near = ground.surface().nearest(base.translation());
  if (!(near.distance <= options.snap))
    refuse_request(std::string(whose) + ".base.position", "lies ", near.distance, " m from the ground, at most ", options.snap,
                   " m are allowed (parameter snap)");
  return near.point;
}

Legs named_legs(const std::vector<Contact>& contacts) {
  Legs out;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const std::string field = "start.contacts[" + std::to_string(k) + "]";
    const std::size_t leg = leg_of(contacts[k], field);
    if (out[leg]) refuse_request(field + ".limb", contacts[k].limb, " is given twice");
    out[leg] = true;
  }
  return out;
}

void demand_three(Legs supports, const std::string& field) {
  if (supports.count() < 3) refuse_request(field, "needs three legs on the ground at least, has ", supports.count());
}

// Feet of the legs that could stand, straight under where the standing robot has them.
void fill_footholds(const Model& model, const Ground& ground, const Isometry3d& thorax, Footholds& footholds) {
  const Vector3d down = -thorax.linear().col(2);
  for (std::size_t leg = 0; leg < kLegs; ++leg) {
    if (footholds.supports[leg]) continue;
    const auto found = footing(ground.surface(), thorax * standing_foot(model, leg), down, model.height());
    footholds.points[leg] = found ? found->point : Vector3d(thorax * standing_foot(model, leg));
    footholds.normals[leg] = found ? found->normal : Vector3d(thorax.linear().col(2));
  }
}

// Where legs that join may stand, straight under the standing robot's feet drawn in or out by some shares.
std::vector<Footholds> places_of(const Model& model, const Ground& ground, const Options& options, const Situation& situation) {
  constexpr std::array kShares{1.0, 0.85, 1.15, 1.3};
  const Isometry3d& thorax = situation.thorax;
  std::vector<Footholds> out;
  for (const double share : kShares) {
    if (share != 1.0 && !options.any_place) continue;
    Footholds place;
    for (std::size_t leg = 0; leg < kLegs; ++leg) {
      if (situation.footholds.supports[leg]) continue;
      Vector3d foot = standing_foot(model, leg);
      foot.head<2>() *= share;
      const auto found = footing(ground.surface(), thorax * foot, -thorax.linear().col(2), model.height());
      if (!found || !reach(model, leg, thorax.inverse() * found->point)) continue;
      place.supports[leg] = true;
      place.points[leg] = found->point;
      place.normals[leg] = found->normal;
    }
    out.push_back(place);
  }
  return out;
}

Start as_joints_say(const Model& model, const Ground& ground, const Options& options, const Placement& start) {
  demand_joints(model, start.joints);
  Start out;
  out.at = from_posture({*start.base, start.joints, {}});
  out.situation.thorax = *start.base;
  out.situation.clearance = options.clearance;
  Footholds& feet = out.situation.footholds;
  const Legs named = named_legs(start.contacts);
  for (std::size_t leg = 0; leg < kLegs; ++leg) {
    const Vector3d foot = out.at.thorax * leg_points(model, leg, out.at.legs[leg]).foot;
    const terrain::Nearest near = ground.surface().nearest(foot);
    const bool stands = near.distance <= kOnGround;
    if (named[leg] && !stands)
      refuse_request("start.joints", "foot L", leg + 1, " is ", near.distance,
                     " m off the ground, but start.contacts has it there");
    feet.supports[leg] = start.contacts.empty() ? stands : named[leg];
    if (!feet.supports[leg]) continue;
    feet.points[leg] = foot;
    feet.normals[leg] = ground.surface().terrain().normals[static_cast<std::size_t>(near.triangle)];
  }
  demand_three(feet.supports, start.contacts.empty() ? "start.joints" : "start.contacts");
  fill_footholds(model, ground, out.at.thorax, feet);
  out.situation.ground = plane_through(feet);
  out.situation.places = places_of(model, ground, options, out.situation);
  return out;
}

Start standing(const Model& model, const Ground& ground, const Options& options, const Placement& start) {
  const Vector3d place = start.base->translation();
  const terrain::Nearest near = ground.surface().nearest(place);
  if (!(near.distance <= options.snap))
    refuse_request("start.base.position", "lies ", near.distance, " m from the ground, at most ", options.snap,
                   " m are allowed (parameter snap)");
  const Plane plane{near.point, ground.surface().terrain().normals[static_cast<std::size_t>(near.triangle)]};
  const Vector3d ahead = start.base->linear().col(0);
  Start out;
  out.situation.thorax = standing_thorax(model, plane, near.point, std::atan2(ahead.y(), ahead.x()));
  out.situation.clearance = options.clearance;
  Footholds& feet = out.situation.footholds;
  feet.supports = start.contacts.empty() ? options.supports : named_legs(start.contacts);
  demand_three(feet.supports, "start.contacts");
  for (std::size_t leg = 0; leg < kLegs; ++leg) {
    if (!feet.supports[leg]) continue;
    const auto found =
        footing(ground.surface(), out.situation.thorax * standing_foot(model, leg), -plane.normal, model.height() / 2);
    if (!found) refuse_request("start.base.position", "there is no ground under foot L", leg + 1, " of the standing robot");
    feet.points[leg] = found->point;
    feet.normals[leg] = found->normal;
  }
  fill_footholds(model, ground, out.situation.thorax, feet);
  out.situation.ground = plane_through(feet);
  out.situation.places = places_of(model, ground, options, out.situation);
  const Evaluation stands = as_it_stands(model, out.situation);
  if (!stands.valid()) refuse_request("start.base", "the robot cannot stand there: ", reason(stands));
  out.at = stands.at;
  return out;
}

}  // namespace

Options read_options(const Parameters& parameters) {
  Options out;
  const std::string& method = parameters.text("method");
  AdaptOptions& adapt = out.adapt;
  if (method == "choice") adapt.method = Method::kChoice;
  if (method == "constant") adapt.method = Method::kConstant;
  if (method == "geometric") adapt.method = Method::kGeometric;
  if (method == "emergency") adapt.method = Method::kEmergency;
  const std::string& legs = parameters.text("legs");
  if (legs == "add") adapt.legs = FurtherLegs::kAdd;
  if (legs == "any") adapt.legs = FurtherLegs::kAny;
  out.any_place = parameters.text("places") == "any";
  if (out.any_place && adapt.legs == FurtherLegs::kKeep)
    refuse_request("parameters.places", "are of legs that join; set legs to add or any");
  if (adapt.method != Method::kOptimal && adapt.legs != FurtherLegs::kKeep)
    refuse_request("parameters.legs", "is of method optimal; the paper's strategies choose their legs by themselves");
  const std::string& supports = parameters.text("supports");
  out.supports = supports == "triad2" ? kTriad2 : supports == "all" ? Legs{0b111111} : kTriad1;
  adapt.share = parameters.real("share");
  adapt.best.friction = parameters.real("friction");
  adapt.best.most_boxes = parameters.integer("max_boxes");
  PoseGrid& grid = adapt.best.grid;
  grid.along.step = grid.across.step = grid.height.step = parameters.real("position_step");
  grid.roll.step = grid.pitch.step = parameters.real("tilt_step");
  grid.height.low = parameters.real("lowest");
  const double yaw = parameters.real("yaw");
  grid.yaw = {-yaw, yaw, grid.roll.step};
  if (grid.height.low > grid.height.high)
    refuse_request("parameters.lowest", "must be at most ", grid.height.high, " m, where the legs are stretched, is ",
                   grid.height.low);
  out.clearance = parameters.real("clearance");
  out.walk.stride = parameters.real("stride");
  out.walk.turn = parameters.real("turn");
  out.walk.least_nesm = parameters.real("least_nesm");
  out.walk.swing = parameters.real("swing");
  out.walk.friction = adapt.best.friction;
  out.walk.clearance = out.clearance;
  out.snap = parameters.real("snap");
  return out;
}

bool is_walk(const Request& request) { return request.goal.base || !request.goal.contacts.empty() || !request.goal.joints.empty(); }

Stand read_stand(const Model& model, const Ground& ground, const Options& options, const Placement& start) {
  if (start.any_orientation) refuse_request("start.any_orientation", "the start must be known");
  if (!start.joints.empty())
    refuse_request("start.joints", "are not read for a walk: it begins standing on six feet at start.base");
  if (!start.contacts.empty())
    refuse_request("start.contacts", "are not read for a walk: it begins standing on six feet at start.base");
  if (!start.base) refuse_request("start.base", "is missing: a point of the ground under the robot and its heading");
  const Vector3d place = on_ground(ground, options, *start.base, "start");
  const Vector3d ahead = start.base->linear().col(0);
  std::string because;
  const auto stand = stand_at(model, ground, {place, std::atan2(ahead.y(), ahead.x())}, options.walk, &because);
  if (!stand) refuse_request("start.base", "the robot cannot stand there on six feet: ", because);
  return *stand;
}

Station read_goal(const Ground& ground, const Options& options, const Stand& from, const Placement& goal) {
  if (!goal.contacts.empty()) refuse_request("goal.contacts", "are not planned for; give goal.base, the point to walk to");
  if (!goal.joints.empty()) refuse_request("goal.joints", "are not planned for; give goal.base, the point to walk to");
  const Vector3d ahead = goal.any_orientation ? from.at.thorax.linear().col(0) : goal.base->linear().col(0);
  return {on_ground(ground, options, *goal.base, "goal"), std::atan2(ahead.y(), ahead.x())};
}

Start read_start(const Model& model, const Ground& ground, const Options& options, const Placement& start) {
  if (start.any_orientation) refuse_request("start.any_orientation", "the start must be known");
  if (!start.base)
    refuse_request("start.base",
                   "is missing: a point of the ground under the robot and its heading; or, with joints, the thorax' pose");
  return start.joints.empty() ? standing(model, ground, options, start) : as_joints_say(model, ground, options, start);
}

}  // namespace foothold::hexpiderix
