// A real vector space of nine joints; lines are those of the coupled joints.
#include "bioloid_ompl.hpp"

#include <ompl/base/MotionValidator.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/geometric/PathSimplifier.h>
#include <ompl/geometric/planners/kpiece/LBKPIECE1.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>
#include <ompl/util/RandomNumbers.h>

namespace foothold::bench {
namespace {

namespace ob = ompl::base;
namespace og = ompl::geometric;
using namespace bioloid;
using Space = ob::RealVectorStateSpace;

Free free_of(const ob::State* state, double heading) {
  Free out;
  out << Eigen::Map<const Nine>(state->as<Space::StateType>()->values), heading;
  return out;
}

class Lines : public ob::MotionValidator {
 public:
  Lines(const ob::SpaceInformationPtr& space, const Model& model, const SinglePhase& phase)
      : ob::MotionValidator(space), model_(model), phase_(phase) {}
  bool checkMotion(const ob::State* a, const ob::State* b) const override {
    const double heading = phase_.from[9];
    return free_line(model_, *phase_.judge, phase_.support, free_of(a, heading), free_of(b, heading), 0);
  }
  // Where the line is not free the planners go on from the last state that a halving of it reaches.
  bool checkMotion(const ob::State* a, const ob::State* b, std::pair<ob::State*, double>& last) const override {
    if (checkMotion(a, b)) return true;
    double reached = 0.0, blocked = 1.0;
    ob::State* middle = si_->allocState();
    for (int k = 0; k < 4; ++k) {
      const double t = 0.5 * (reached + blocked);
      si_->getStateSpace()->interpolate(a, b, t, middle);
      (checkMotion(a, middle) ? reached : blocked) = t;
    }
    si_->freeState(middle);
    last.second = reached;
    if (last.first) si_->getStateSpace()->interpolate(a, b, reached, last.first);
    return false;
  }

 private:
  const Model& model_;
  const SinglePhase& phase_;
};

}  // namespace

void seed_ompl(std::uint_fast32_t seed) {
  ompl::msg::setLogLevel(ompl::msg::LOG_NONE);
  ompl::RNG::setSeed(seed);
}

std::vector<Free> solve_by_ompl(const Model& model, const SinglePhase& phase, OmplPlanner which, double seconds, bool simplified,
                                double& spent) {
  const Side support = phase.support.foot;
  auto space = std::make_shared<Space>(9);
  ob::RealVectorBounds bounds(9);
  for (unsigned k = 0; k < 9; ++k) {
    const auto& limits = model.joints[k < 6 ? leg_joint(support, k) : leg_joint(other(support), k - 5)].limits;
    bounds.setLow(k, limits.low);
    bounds.setHigh(k, limits.high);
  }
  space->setBounds(bounds);
  auto information = std::make_shared<ob::SpaceInformation>(space);
  const double heading = phase.from[9];
  information->setStateValidityChecker([&](const ob::State* state) {
    Joints joints;
    return from_free(model, support, free_of(state, heading), joints) &&
           phase.judge->posture(joints, phase.support) == Fault::kNone;
  });
  information->setMotionValidator(std::make_shared<Lines>(information, model, phase));
  information->setup();
  auto problem = std::make_shared<ob::ProblemDefinition>(information);
  ob::ScopedState<Space> start(space), goal(space);
  for (unsigned k = 0; k < 9; ++k) {
    start[k] = phase.from[k];
    goal[k] = phase.to[k];
  }
  problem->setStartAndGoalStates(start, goal);
  // The longest extension: of 0.1, 0.3, 1 and OMPL's own choice the best for both planners, and ours.
  constexpr double kRange = 0.3;  // rad
  ob::PlannerPtr planner;
  const auto use = [&](auto own) {
    own->setRange(kRange);
    planner = own;
  };
  if (which == OmplPlanner::kRrtConnect)
    use(std::make_shared<og::RRTConnect>(information));
  else
    use(std::make_shared<og::LBKPIECE1>(information));
  planner->setProblemDefinition(problem);
  planner->setup();

  const double begin = cpu_seconds();
  std::vector<Free> out;
  const bool exact = planner->solve(ob::PlannerTerminationCondition([&] { return cpu_seconds() - begin > seconds; })) ==
                     ob::PlannerStatus::EXACT_SOLUTION;
  auto* path = exact ? problem->getSolutionPath()->as<og::PathGeometric>() : nullptr;
  if (path && simplified) og::PathSimplifier(information).simplify(*path, 1e-3);
  spent = cpu_seconds() - begin;
  if (path)
    for (const ob::State* state : path->getStates()) out.push_back(free_of(state, heading));
  return out;
}

}  // namespace foothold::bench
