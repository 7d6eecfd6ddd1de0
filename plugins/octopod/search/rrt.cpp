// RRT* (Karaman and Frazzoli 2011) by OMPL, which the paper names as future work, over the same states and edges as the other
// searches.
//
// A state is a number; a straight motion in OMPL's sense is one edge: steering goes to the neighbour nearest to the sample.
// Repeatable: samples and the bias to the goal are drawn by a sampler of ours (OMPL's own numbers depend on a seed of the whole
// process), and nearest neighbours are found without random pivots.
#include <ompl/base/MotionValidator.h>
#include <ompl/base/OptimizationObjective.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/goals/GoalRegion.h>
#include <ompl/base/spaces/DiscreteStateSpace.h>
#include <ompl/datastructures/NearestNeighborsSqrtApprox.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/rrt/RRTstar.h>
#include <ompl/util/Console.h>

#include <algorithm>
#include <chrono>
#include <numbers>

#include "octopod/search/route.hpp"

namespace foothold::octopod {
namespace {

namespace ob = ompl::base;
using Clock = std::chrono::steady_clock;

constexpr double kToGoal = 0.05;  // part of the samples that are the goal
constexpr double kRange = 1e-6;   // below any distance of states: every motion is steered
constexpr int kCopies = 3;        // of a state in the tree
constexpr double kTurning = 0.1;  // m/rad, of headings in the distance by which nearest states are found

int read(const ob::State* state) { return state->as<ob::DiscreteStateSpace::StateType>()->value; }
void write(ob::State* state, State value) { state->as<ob::DiscreteStateSpace::StateType>()->value = value; }

// Turns of 45 degrees from one heading to the other, -3 to 4.
int turns(State from, State to) {
  const int ahead = (orientation_of(to) - orientation_of(from) + kOrientations) % kOrientations;
  return ahead > kOrientations / 2 ? ahead - kOrientations : ahead;
}

class Space final : public ob::DiscreteStateSpace {
 public:
  Space(const Ground& ground, const RouteOptions& options)
      : ob::DiscreteStateSpace(0, ground.states() - 1), ground_(ground), options_(options) {}
  unsigned getDimension() const override { return 2; }  // a surface: the heading follows from the steering
  double distance(const ob::State* a, const ob::State* b) const override {
    return (ground_.place(node_of(read(a))) - ground_.place(node_of(read(b)))).norm() +
           kTurning * std::abs(turns(read(a), read(b))) * std::numbers::pi / 4;
  }
  bool hasSymmetricInterpolate() const override { return false; }
  void interpolate(const ob::State* from, const ob::State* to, double /*part*/, ob::State* out) const override {
    const Vector3d& aim = ground_.place(node_of(read(to)));
    int next = node_of(read(from));
    double least = std::numeric_limits<double>::infinity();
    for (const int node : ground_.adjacent(next))
      if (const double left = (ground_.place(node) - aim).norm(); left < least) {
        least = left;
        next = node;
      }
    write(out, best_heading(read(from), next));
    steered_ = true;
  }
  bool allowed(State state) const { return octopod::allowed(ground_, state, options_); }
  // Whether the motion that is asked for next is one that interpolate() made: a new state of the tree.
  bool take_steered() const { return std::exchange(steered_, false); }

 private:
  State best_heading(State from, int node) const {
    State best = kOrientations * node + orientation_of(from);
    double least = std::numeric_limits<double>::infinity();
    for (State state = kOrientations * node; state < kOrientations * (node + 1); ++state)
      if (allowed(state))
        if (const double cost = step_cost(ground_, from, state, options_); cost < least) {
          least = cost;
          best = state;
        }
    return best;
  }
  const Ground& ground_;
  const RouteOptions& options_;
  mutable bool steered_ = false;
};

bool beside(const Ground& ground, State a, State b) {
  const auto around = ground.adjacent(node_of(a));
  return std::binary_search(around.begin(), around.end(), node_of(b));
}

class Sampler final : public ob::StateSampler {
 public:
  Sampler(const ob::StateSpace* space, const Ground& ground, int goal_node, std::mt19937_64& random, long& drawn)
      : ob::StateSampler(space), ground_(ground), goal_node_(goal_node), random_(random), drawn_(drawn) {}
  void sampleUniform(ob::State* state) override {
    ++drawn_;
    const bool goal = static_cast<double>(random_() >> 11U) * 0x1.0p-53 < kToGoal;
    const auto nodes = static_cast<std::uint64_t>(ground_.nodes());
    const int node = goal ? goal_node_ : static_cast<int>(random_() % nodes);
    write(state, kOrientations * node + static_cast<int>(random_() % kOrientations));
  }
  void sampleUniformNear(ob::State* state, const ob::State*, double) override { sampleUniform(state); }
  void sampleGaussian(ob::State* state, const ob::State*, double) override { sampleUniform(state); }

 private:
  const Ground& ground_;
  int goal_node_;
  std::mt19937_64& random_;
  long& drawn_;
};

class Validator final : public ob::MotionValidator {
 public:
  Validator(const ob::SpaceInformationPtr& information, const Space& space, const Ground& ground, const Edge& edge)
      : ob::MotionValidator(information),
        space_(space),
        ground_(ground),
        edge_(edge),
        copies_(static_cast<std::size_t>(ground.states())) {}
  bool checkMotion(const ob::State* a, const ob::State* b) const override {
    const State from = read(a), to = read(b);
    const bool added = space_.take_steered();
    int& copies = copies_[static_cast<std::size_t>(to)];
    if (added && copies == kCopies) return false;
    if (!beside(ground_, from, to) || !space_.allowed(to) || (edge_ && !edge_(from, to))) return false;
    if (added) ++copies;
    return true;
  }
  bool checkMotion(const ob::State* a, const ob::State* b, std::pair<ob::State*, double>& last) const override {
    const bool valid = checkMotion(a, b);
    if (!valid) last.second = 0.0;
    return valid;
  }

 private:
  const Space& space_;
  const Ground& ground_;
  const Edge& edge_;
  mutable std::vector<int> copies_;
};

class Cost final : public ob::OptimizationObjective {
 public:
  Cost(const ob::SpaceInformationPtr& information, const Ground& ground, const RouteOptions& options)
      : ob::OptimizationObjective(information), ground_(ground), options_(options) {}
  ob::Cost stateCost(const ob::State*) const override { return ob::Cost(0.0); }
  ob::Cost motionCost(const ob::State* a, const ob::State* b) const override {
    if (!beside(ground_, read(a), read(b))) return infiniteCost();
    return ob::Cost(step_cost(ground_, read(a), read(b), options_));
  }

 private:
  const Ground& ground_;
  const RouteOptions& options_;
};

class AtGoal final : public ob::GoalRegion {
 public:
  AtGoal(const ob::SpaceInformationPtr& space, const Ground& ground, int node)
      : ob::GoalRegion(space), ground_(ground), node_(node) {}
  double distanceGoal(const ob::State* state) const override {
    return (ground_.place(node_of(read(state))) - ground_.place(node_)).norm();
  }

 private:
  const Ground& ground_;
  int node_;
};

}  // namespace

Route rrt_route(const Ground& ground, State from, int goal_node, const RouteOptions& options, std::mt19937_64& random,
                const std::stop_token& stop, const Edge& edge) {
  ompl::msg::noOutputHandler();
  const long before = ground.postures_made();
  Route out;
  out.bound = (ground.place(goal_node) - ground.place(node_of(from))).norm();
  const auto space = std::make_shared<Space>(ground, options);
  long drawn = 0;
  space->setStateSamplerAllocator(
      [&](const ob::StateSpace* of) { return std::make_shared<Sampler>(of, ground, goal_node, random, drawn); });
  const auto information = std::make_shared<ob::SpaceInformation>(space);
  const auto validator = std::make_shared<Validator>(information, *space, ground, edge);
  information->setMotionValidator(validator);
  information->setStateValidityChecker([&](const ob::State* state) { return space->allowed(read(state)); });
  information->setup();

  const auto problem = std::make_shared<ob::ProblemDefinition>(information);
  ob::ScopedState<> start(space);
  write(start.get(), from);
  problem->addStartState(start);
  problem->setGoal(std::make_shared<AtGoal>(information, ground, goal_node));
  problem->setOptimizationObjective(std::make_shared<Cost>(information, ground, options));

  ompl::geometric::RRTstar planner(information);
  planner.setRange(kRange);
  planner.setGoalBias(0.0);
  planner.setNearestNeighbors<ompl::NearestNeighborsSqrtApprox>();
  planner.setProblemDefinition(problem);
  planner.setup();
  const auto end = Clock::now() + std::chrono::duration<double>(options.budget);
  const ob::PlannerTerminationCondition enough(
      [&] { return drawn >= options.samples || stop.stop_requested() || Clock::now() >= end; });
  const bool found = planner.solve(enough) == ob::PlannerStatus::EXACT_SOLUTION;
  out.expanded = drawn;
  out.postures = ground.postures_made() - before;
  out.end = found ? Route::End::kFound : stop.stop_requested() ? Route::End::kStopped : Route::End::kExhausted;
  if (!found) return out;
  for (const ob::State* state : problem->getSolutionPath()->as<ompl::geometric::PathGeometric>()->getStates()) {
    if (!out.states.empty()) out.cost += step_cost(ground, out.states.back(), read(state), options);
    out.states.push_back(read(state));
    out.costs.push_back(out.cost);
  }
  return out;
}

}  // namespace foothold::octopod
