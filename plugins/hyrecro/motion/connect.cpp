// RRTConnect by OMPL, made repeatable: its own random numbers depend on a seed of the whole process, so states are drawn by a
// sampler of ours, and neighbours are found without random pivots.
#include <ompl/base/MotionValidator.h>
#include <ompl/base/ProblemDefinition.h>
#include <ompl/base/SpaceInformation.h>
#include <ompl/base/goals/GoalStates.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/datastructures/NearestNeighborsLinear.h>
#include <ompl/geometric/PathGeometric.h>
#include <ompl/geometric/planners/rrt/RRTConnect.h>
#include <ompl/util/Console.h>

#include <numbers>

#include "hyrecro/motion/transfer.hpp"

namespace foothold::hyrecro {
namespace {

namespace ob = ompl::base;
using Space = ob::RealVectorStateSpace;

// s: how long the longest edge of the trees takes.
constexpr double kRange = 1.5;

// States are actuators in the time that they take, s.
Actuators units(const Model& model) {
  Actuators out = Actuators::Constant(model.actuator_speed);
  out.tail<2>().setConstant(model.hip_speed);
  return out;
}

class Sampler final : public ob::StateSampler {
 public:
  Sampler(const ob::StateSpace* space, std::mt19937_64& random) : ob::StateSampler(space), random_(random) {}
  void sampleUniform(ob::State* state) override {
    const ob::RealVectorBounds& bounds = space_->as<Space>()->getBounds();
    for (unsigned i = 0; i < 10; ++i) draw(state, i, bounds.low[i], bounds.high[i]);
  }
  void sampleUniformNear(ob::State* state, const ob::State* near, double distance) override {
    const ob::RealVectorBounds& bounds = space_->as<Space>()->getBounds();
    for (unsigned i = 0; i < 10; ++i) {
      const double middle = near->as<Space::StateType>()->values[i];
      draw(state, i, std::max(bounds.low[i], middle - distance), std::min(bounds.high[i], middle + distance));
    }
  }
  void sampleGaussian(ob::State* state, const ob::State* mean, double deviation) override {
    sampleUniformNear(state, mean, 2.0 * deviation);
  }

 private:
  void draw(ob::State* state, unsigned i, double low, double high) {
    state->as<Space::StateType>()->values[i] = low + (high - low) * (static_cast<double>(random_() >> 11U) * 0x1.0p-53);
  }
  std::mt19937_64& random_;
};

class Validator final : public ob::MotionValidator {
 public:
  Validator(const ob::SpaceInformationPtr& space, const Surroundings& around, const Actuators& unit)
      : ob::MotionValidator(space), around_(around), unit_(unit) {}
  bool checkMotion(const ob::State* a, const ob::State* b) const override { return !judge_way(around_, read(a), read(b)); }
  bool checkMotion(const ob::State* a, const ob::State* b, std::pair<ob::State*, double>& last) const override {
    const Blocked blocked = judge_way(around_, read(a), read(b));
    if (blocked) last.second = 0.0;
    return !blocked;
  }
  Actuators read(const ob::State* state) const {
    return unit_.cwiseProduct(Eigen::Map<const Actuators>(state->as<Space::StateType>()->values));
  }

 private:
  const Surroundings& around_;
  Actuators unit_;
};

}  // namespace

std::optional<std::vector<Actuators>> connect(const Surroundings& around, const Actuators& a, const std::vector<Actuators>& goals,
                                              long most_judged, std::mt19937_64& random) {
  ompl::msg::noOutputHandler();
  const Actuators unit = units(around.model);
  const auto space = std::make_shared<Space>(10);
  ob::RealVectorBounds bounds(10);
  bounds.setLow(around.model.mechanism.shortest() / around.model.actuator_speed);
  bounds.setHigh(around.model.mechanism.longest() / around.model.actuator_speed);
  for (unsigned i = 8; i < 10; ++i) {
    double low = a[i], high = a[i];
    for (const Actuators& goal : goals) {
      low = std::min(low, goal[i]);
      high = std::max(high, goal[i]);
    }
    bounds.setLow(i, (low - 0.5 * std::numbers::pi) / around.model.hip_speed);
    bounds.setHigh(i, (high + 0.5 * std::numbers::pi) / around.model.hip_speed);
  }
  space->setBounds(bounds);
  space->setStateSamplerAllocator([&random](const ob::StateSpace* of) { return std::make_shared<Sampler>(of, random); });

  const auto information = std::make_shared<ob::SpaceInformation>(space);
  const auto validator = std::make_shared<Validator>(information, around, unit);
  information->setMotionValidator(validator);
  information->setStateValidityChecker(
      [&](const ob::State* state) { return !judge_posture(around, from_actuators(around.model, validator->read(state))); });
  information->setup();

  const auto put = [&](const Actuators& q, ob::State* state) {
    Eigen::Map<Actuators>(state->as<Space::StateType>()->values) = q.cwiseQuotient(unit);
    space->enforceBounds(state);
  };
  ob::ScopedState<> state(space);
  const auto problem = std::make_shared<ob::ProblemDefinition>(information);
  put(a, state.get());
  problem->addStartState(state);
  const auto ends = std::make_shared<ob::GoalStates>(information);
  for (const Actuators& goal : goals) {
    put(goal, state.get());
    ends->addState(state);
  }
  problem->setGoal(ends);

  ompl::geometric::RRTConnect planner(information);
  planner.setRange(kRange);
  planner.setNearestNeighbors<ompl::NearestNeighborsLinear>();
  planner.setProblemDefinition(problem);
  planner.setup();
  const long last = around.judged + most_judged;
  const ob::PlannerTerminationCondition enough([&] { return around.judged > last || around.stop.stop_requested(); });
  if (planner.solve(enough) != ob::PlannerStatus::EXACT_SOLUTION) return std::nullopt;

  std::vector<Actuators> out;
  for (const ob::State* point : problem->getSolutionPath()->as<ompl::geometric::PathGeometric>()->getStates())
    out.push_back(validator->read(point));
  out.front() = a;
  // Scaling to and fro rounds; the end is the goal itself.
  for (const Actuators& goal : goals)
    if ((goal - out.back()).cwiseAbs().maxCoeff() < 1e-9) out.back() = goal;
  return out;
}

}  // namespace foothold::hyrecro
