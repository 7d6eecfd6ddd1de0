// Planner interface of HyReCRo.
#include "hyrecro/planner.hpp"

#include <algorithm>

#include "hyrecro/check/check.hpp"
#include "hyrecro/departure.hpp"
#include "hyrecro/for_a_while.hpp"
#include "hyrecro/motion/lift.hpp"
#include "hyrecro/optimal/bounds.hpp"
#include "hyrecro/posture.hpp"
#include "hyrecro/reach/reach_filter.hpp"
#include "hyrecro/report.hpp"
#include "hyrecro/steps.hpp"
#include "hyrecro/travel.hpp"

namespace foothold::hyrecro {
namespace {

constexpr std::size_t kWorkspacesKept = 4;
constexpr double kSharedWithPaper = 0.5;

const PreparedTruss& truss_of(const PreparedScene& scene) { return dynamic_cast<const PreparedTruss&>(scene); }

truss::Truss read(const Scene& scene) {
  if (scene.path.empty()) throw InvalidScene("scene", "hyrecro climbs a truss; the request names no scene");
  if (scene.format == "yaml") return truss::read_truss(scene.path);
  return truss::read_mesh(scene.path);
}

}  // namespace

HyrecroPlanner::HyrecroPlanner(const RobotModel& model) : model_(Model::from_model(model)) {
  shared_reach_filter(model_);  // here rather than in the first plan
}

std::shared_ptr<const PlanarWorkspace> HyrecroPlanner::workspace(const Options& options, const std::stop_token& stop) {
  const double lift = options.paper.lift;
  const WorkspaceKey key{options.position_step, options.heading_step, options.clearance, lift};
  if (const auto kept = workspaces_.find(key); kept != workspaces_.end()) return kept->second;
  const auto liftable = [&](const Coordinates& c) { return legs_lift(model_, c, lift); };
  auto made = PlanarWorkspace::make(model_, options.position_step, options.heading_step, options.clearance, stop,
                                    lift > 0.0 ? Admit(liftable) : Admit());
  if (!made) return nullptr;
  if (workspaces_.size() == kWorkspacesKept) workspaces_.clear();
  return workspaces_[key] = std::make_shared<const PlanarWorkspace>(std::move(*made));
}

Reachability& HyrecroPlanner::exact(double clearance) const {
  auto& kept = exact_[clearance];
  if (!kept) kept = make_exact(model_, clearance);
  return *kept;
}

std::shared_ptr<const PreparedScene> HyrecroPlanner::prepare(const Scene& scene, const Parameters& parameters) {
  const Options options = read_options(parameters);
  return std::make_shared<PreparedTruss>(model_, read(scene), options.sampling, options.clearance);
}

std::vector<Beginning> HyrecroPlanner::beginnings(const Request& request, const PreparedTruss& scene,
                                                  const Options& options) const {
  const Start start = read_start(model_, scene, request.start);
  const Grip& first = start.grips.front();
  const Isometry3d sole = pose_of(scene.truss, first.at);
  const bool both = start.grips.size() == 2;
  std::optional<Coordinates> coordinates = start.coordinates;
  if (coordinates && !is_free(model_, scene, *coordinates, sole))
    throw InvalidRequest("start.joints", "in this posture the robot collides, or keeps less than the clearance");
  if (!coordinates && both) {
    const Isometry3d wanted = sole.inverse() * pose_of(scene.truss, start.grips[1].at);
    coordinates = standing_on_both(model_, scene, exact(scene.clearance), sole, wanted, options.motions, options.optimal.lift);
    if (!coordinates)
      throw InvalidRequest("start.contacts", "no posture free of collision stands on both; give one contact, or others");
  }
  if (!coordinates) coordinates = hanging(model_, scene, sole);
  if (!coordinates)
    throw InvalidRequest("start.contacts[0]",
                         "no posture free of collision was found that holds there with the other foot in the air");
  std::vector<Beginning> out{{first, *coordinates, both}};
  if (both) out.push_back({start.grips[1], swapped(*coordinates), true});
  return out;
}

Posture HyrecroPlanner::start(const Request& request, const Parameters& parameters, const PreparedScene& scene) const {
  const PreparedTruss& truss = truss_of(scene);
  return standing(beginnings(request, truss, read_options(parameters)), truss);
}

Posture HyrecroPlanner::standing(const std::vector<Beginning>& from, const PreparedTruss& truss) const {
  const Beginning& first = from.front();
  Posture out = posture_of(model_, first.coordinates, first.holding.foot, pose_of(truss.truss, first.holding.at));
  for (const Beginning& beginning : from) out.stance.push_back(to_contact(truss.truss, beginning.holding));
  return out;
}

// What is not proved may be behind the paper's method, which is asked then, for half of the budget (s) at most. With motions it is
// not: its strides leave no room to lift. Nor on large scenes, where it does not end in any time that is left.
Found HyrecroPlanner::optimal(const Options& options, const PreparedTruss& scene, const Grip& from, const Foothold& goal,
                              double budget, const std::stop_token& stop) {
  Found ours = plan_optimal(model_, scene, from.at, goal, options.optimal, stop, {});
  const bool large = scene.transitions.all().size() > kLarge;
  if (options.motion || options.optimal.objective != Objective::kSteps || ours.optimal || large ||
      ours.outcome == Found::Outcome::kStopped)
    return ours;
  const ForAWhile while_left(kSharedWithPaper * budget, stop);
  scene.workspace = workspace(options, while_left.token());
  if (!scene.workspace) return ours;
  PaperOptions as_kept = options.paper;
  as_kept.keeps = true;
  Found papers = plan_paper(model_, scene, exact(scene.clearance), from.at, goal, as_kept, while_left.token(), {});
  const bool better =
      papers.outcome == Found::Outcome::kReached && (ours.outcome != Found::Outcome::kReached || papers.cost < ours.cost);
  if (!better) return ours;
  papers.lower_bound = std::min(ours.lower_bound, papers.cost);
  papers.objective = ours.objective + "; these strides are the paper's method's";
  return papers;
}

Found HyrecroPlanner::search(const Options& options, const PreparedTruss& scene, const Grip& from, const Foothold& goal,
                             double budget, PlanContext& context) {
  if (options.method == Method::kOptimal) return optimal(options, scene, from, goal, budget, context.stop);
  std::unique_ptr<Reachability> other;
  if (options.reachability == ReachabilityKind::kNetwork) other = make_network(model_);
  if (options.reachability == ReachabilityKind::kIterative)
    other = make_iterative(model_, scene.clearance, options.tries, context.random);
  Reachability& reachability = other ? *other : exact(scene.clearance);
  return plan_paper(model_, scene, reachability, from.at, goal, options.paper, context.stop, {});
}

PlanReport HyrecroPlanner::plan(const Request& request, const Parameters& parameters, const PreparedScene& scene,
                                PlanContext& context) {
  const PreparedTruss& truss = truss_of(scene);
  const Options options = read_options(parameters);
  const std::vector<Beginning> from = beginnings(request, truss, options);
  const Foothold goal = read_goal(model_, truss, request.goal);
  std::vector<Beginning> ready = from;
  if (options.motion && std::none_of(from.begin(), from.end(), [&](const Beginning& b) { return same(b.holding.at, goal); })) {
    std::string reason;
    ready = departures(model_, truss, from, options.motions, context.stop, reason);
    if (context.stop.stop_requested()) return stopped_report();
    if (ready.empty())
      return failed_report({PlanError::kNoPath, request.start.joints.empty() ? "start.contacts" : "start.joints",
                            "neither foot can leave its face from the start: " + reason,
                            "lower lift, begin elsewhere, or plan with motion: false to see the footholds"});
  }
  if (options.method == Method::kPaper) {
    truss.workspace = workspace(options, context.stop);
    if (!truss.workspace) return stopped_report();
  }
  const Search searched = [&](const Options& with, const Grip& grip) {
    return search(with, truss, grip, goal, request.budget, context);
  };
  const Travel travel = plan_travel(model_, truss, options, ready, searched, context);
  if (travel.stopped) return stopped_report();
  if (!travel.found) return failed_report(travel.failure);

  std::vector<double> joints = standing(from, truss).joints;
  Grip holding = travel.beginning.holding;
  const std::vector<double> costs = costs_of(*travel.found, options, truss.truss);
  for (std::size_t k = 0; k < travel.found->route.strides.size(); ++k) {
    const Stride& stride = travel.found->route.strides[k];
    Step step = to_step(model_, truss.truss, holding, stride, costs[k]);
    if (options.motion) add_motion(model_, truss.truss, holding, travel.motions[k], joints, step);
    joints = step.after.joints;
    if (!context.emit(std::move(step))) return stopped_report();
    holding = {other(holding.foot), stride.to};
  }
  return report_of(*travel.found, options, truss.truss, travel.times);
}

StepVerdict HyrecroPlanner::check(const Step& step, const Posture& before, const Parameters& parameters,
                                  const PreparedScene& scene) const {
  const PreparedTruss& truss = truss_of(scene);
  const CheckOptions options{.clearance = parameters.real("clearance"), .lift = parameters.real("lift")};
  return check_step(model_, truss.truss, truss.obstacles, options, step, before);
}

std::vector<Shape> HyrecroPlanner::shapes(const Posture& posture) const {
  const Stand stand = stand_of(model_, posture);
  const Bodies bodies = bodies_at(model_, stand.coordinates, stand.sole);
  std::vector<Shape> out;
  const auto add_box = [&](const char* name, const collision::Box& box) {
    out.push_back({Shape::Kind::kBox, name, box.pose, 2.0 * box.half, {}});
  };
  const auto add_leg = [&](const char* name, const collision::Capsule& leg) {
    Isometry3d pose = Isometry3d::Identity();
    const Vector3d axis = leg.b - leg.a;
    pose.linear() = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), axis).toRotationMatrix();
    pose.translation() = 0.5 * (leg.a + leg.b);
    out.push_back({Shape::Kind::kCapsule, name, pose, Vector3d(leg.radius, 0.0, axis.norm()), {}});
  };
  add_box("plate A", bodies.plate[0]);
  add_leg("leg A", bodies.leg[0]);
  add_box("hip", bodies.hip);
  add_leg("leg B", bodies.leg[1]);
  add_box("plate B", bodies.plate[1]);
  return out;
}

}  // namespace foothold::hyrecro
