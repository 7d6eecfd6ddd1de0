// The search. With h the longest advance of a foot over the other and D the way to the goal, the foot of step k stands at most k h
// from the start; both feet must arrive, so no plan has fewer than ceil(D / h) + 1 steps. The plan below has exactly so many.
#include "planner.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "foothold/export.hpp"

namespace foothold::biped {
namespace {

constexpr double kOnGround = 1e-6;  // m

// Base poses are those of the middle between the feet, on the ground, upright. What else a client gives is refused, not ignored.
void check_placement(const Placement& placement, const std::string& field) {
  if (!placement.contacts.empty())
    throw InvalidRequest(field + ".contacts", "give " + field + ".base instead: it stands at rest there");
  if (!placement.joints.empty()) throw InvalidRequest(field + ".joints", "this robot has none");
  if (!placement.base) return;
  const Isometry3d& base = *placement.base;
  if (std::abs(base.translation().z()) > kOnGround)
    throw InvalidRequest(field + ".base.position.z", "must be 0, the ground; is " + std::to_string(base.translation().z()));
  if ((base.linear() * Vector3d::UnitZ() - Vector3d::UnitZ()).norm() > 1e-6)
    throw InvalidRequest(field + ".base.orientation", "must be upright");
}

// ceil(D / h) + 1; a quotient that is whole but for rounding counts as whole.
int fewest_steps(double distance, double advance) {
  return distance > kOnGround ? static_cast<int>(std::ceil(distance / advance - 1e-12)) + 1 : 0;
}

}  // namespace

std::shared_ptr<const PreparedScene> BipedPlanner::prepare(const Scene& scene, const Parameters&) {
  if (!scene.path.empty()) throw InvalidScene("", "this planner walks on flat ground and takes no scene");
  return std::make_shared<const PreparedScene>();
}

Posture BipedPlanner::start(const Request& request, const Parameters&, const PreparedScene&) const {
  check_placement(request.start, "start");
  const Isometry3d base = request.start.base.value_or(Isometry3d::Identity());
  return biped_.standing(base);
}

PlanReport BipedPlanner::plan(const Request& request, const Parameters& parameters, const PreparedScene& scene,
                              PlanContext& context) {
  if (!request.goal.base) throw InvalidRequest("goal.base", "is needed");
  check_placement(request.goal, "goal");
  Posture posture = start(request, parameters, scene);
  const Isometry3d begin = posture.base;
  if (!request.goal.any_orientation && !request.goal.base->linear().isApprox(begin.linear(), 1e-6))
    throw InvalidRequest("goal.base.orientation", "must be that of the start: this robot does not turn");

  const Vector3d way = request.goal.base->translation() - begin.translation();
  const double distance = way.norm();
  const double advance = parameters.real("stride") * biped_.reach;
  // A hair less than may be, so that rounding does not put a foot out of reach.
  const int steps = fewest_steps(distance, advance * (1.0 - 1e-9));
  const Foot first = parameters.text("first") == "left" ? kLeft : kRight;

  PlanReport report;
  report.cost_unit = "1";
  report.objective = "number of steps that advance a foot by stride * reach at most";
  for (int k = 1; k <= steps; ++k) {
    if (context.stop.stop_requested()) {
      report.outcome = PlanReport::Outcome::kStopped;
      return report;
    }
    // The last step brings the other foot beside the one that has arrived.
    const double progress = std::min(1.0, static_cast<double>(k) / (steps - 1));
    const Foot foot = k % 2 == 1 ? first : (first == kLeft ? kRight : kLeft);
    Step step;
    step.label = std::string(kLimbs[foot]) + " foot, step " + std::to_string(k) + " of " + std::to_string(steps);
    posture.stance[foot].frame.translation() = begin.translation() + progress * way + begin.linear() * biped_.rest(foot);
    posture.base.translation() = 0.5 * (posture.stance[kLeft].frame.translation() + posture.stance[kRight].frame.translation());
    step.placed = {posture.stance[foot]};
    step.after = posture;
    step.attributes = {{"progress", std::to_string(progress)}};
    step.cost = k;
    if (!context.emit(std::move(step))) {
      report.outcome = PlanReport::Outcome::kStopped;
      return report;
    }
  }
  report.outcome = PlanReport::Outcome::kReached;
  report.cost = steps;
  report.lower_bound = fewest_steps(distance, advance);
  report.optimal = report.cost == report.lower_bound;
  report.figures = {{"distance", distance, 0.0, "m"}};
  return report;
}

std::vector<Shape> BipedPlanner::shapes(const Posture& posture) const {
  const double sole = 0.02;  // m thick, for drawing
  Shape body{.kind = Shape::Kind::kBox, .body = "body", .pose = posture.base, .size = biped_.body_size, .vertices = {}};
  body.pose.translation().z() += biped_.body_height;
  std::vector<Shape> shapes = {body};
  for (const Contact& contact : posture.stance) {
    Shape foot{.kind = Shape::Kind::kBox,
               .body = contact.limb,
               .pose = contact.frame,
               .size = {biped_.foot_length, biped_.foot_width, sole},
               .vertices = {}};
    foot.pose.translation().z() += 0.5 * sole;
    shapes.push_back(foot);
  }
  return shapes;
}

}  // namespace foothold::biped

namespace {

using foothold::ParameterKind;

constexpr std::array kParameters = {
    foothold::ParameterSpec{"stride", ParameterKind::kReal, "1", "1", 0.05, 1.0, "", "How much of its reach a step may use."},
    foothold::ParameterSpec{"first", ParameterKind::kChoice, "", "left", 0, 0, "left|right", "The foot that begins."}};

}  // namespace

FOOTHOLD_EXPORT_PLANNER(foothold::biped::BipedPlanner,
                        (foothold::PlannerInfo{
                            .name = "template",
                            .version = "1.0.0",
                            .description = "the fewest straight steps on flat ground",
                            .limbs = "left|right",
                            .start_needs = "base: the middle between the feet, on the ground; the origin if absent",
                            .goal_needs = "base: position on the ground, heading as at the start",
                            .parameters = kParameters.data(),
                            .parameter_count = kParameters.size()}))
