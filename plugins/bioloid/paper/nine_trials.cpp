// Trials between two postures.
#include "bioloid/paper/nine_trials.hpp"

namespace foothold::bioloid::paper {

NineTrials nine_trials(const Model& model, Judge& judge, const Support& support, const Joints& a, const Joints& b,
                       const NineOptions& nine, const Options& options, std::size_t count, Choice choice, std::mt19937_64& random,
                       std::stop_token stop) {
  NineTrials out;
  const Space space = nine_space(model, judge, support, a, b, nine);
  const double heading = heading_of(model, support.foot, a);
  const Point start = nine_point(model, support.foot, a, space.dimension()),
              goal = nine_point(model, support.foot, b, space.dimension());
  for (const Point& end : {start, goal})
    if (!space.within_limits(end) || !space.valid(end)) return out;
  out.trials = trials(space, start, goal, options, count, balance_error(model, judge, support, heading), random, std::move(stop));
  out.best = best(out.trials, choice);
  if (!out.best) return out;
  for (const Point& point : out.trials[*out.best].plan.path)
    joints_at(model, support.foot, point, heading, out.postures.emplace_back());
  return out;
}

}  // namespace foothold::bioloid::paper
