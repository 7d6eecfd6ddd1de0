// What both methods have in common: judging what is asked, and removing what is useless afterwards.
#include "bioloid/paper/paper.hpp"

#include <stdexcept>

#include "bioloid/paper/methods.hpp"
#include "bioloid/paper/sections.hpp"

namespace foothold::bioloid::paper {
namespace {

void judge(const Space& space, const Point& start, const Point& goal, const Options& options) {
  const auto refuse = [](const char* reason) { throw std::invalid_argument(reason); };
  const auto n = space.low.size();
  if (n == 0 || space.high.size() != n || space.step.size() != n || start.size() != n || goal.size() != n)
    refuse("limits, steps, start and goal need the same number of coordinates, at least 1");
  if (!(space.step.array() > 0.0).all() || !space.step.allFinite()) refuse("every step has to be above 0");
  if (options.growth < 1) refuse("growth has to be 1 or more");
  if (!space.valid) refuse("a space needs a judge of points");
  if (!space.within_limits(start)) refuse("the start is outside the limits");
  if (!space.within_limits(goal)) refuse("the goal is outside the limits");
  if (!space.valid(start)) refuse("the start is not valid");
  if (!space.valid(goal)) refuse("the goal is not valid");
}

}  // namespace

Plan plan(const Space& space, const Point& start, const Point& goal, const Options& options, std::mt19937_64& random,
          std::stop_token stop) {
  judge(space, start, goal, options);
  Plan out = options.method == Method::kRandom ? random_walk(space, start, goal, options, random, stop)
                                               : stochastic(space, start, goal, options, random, stop);
  out.found_movements = out.movements();
  if (options.method == Method::kRandom && options.clean) out.path = without_useless_sections(space, out.path, stop);
  if (options.trim) out.path = trimmed(space, out.path, stop);
  return out;
}

}  // namespace foothold::bioloid::paper
