// Trials of one movement, their error and its variance, and the best one.
#include "bioloid/paper/trials.hpp"

#include <algorithm>

namespace foothold::bioloid::paper {
namespace {

void measure(Trial& trial, const Error& error) {
  const std::vector<Point>& path = trial.plan.path;
  if (path.empty()) return;
  const double count = static_cast<double>(path.size());
  std::vector<double> errors;
  errors.reserve(path.size());
  for (const Point& point : path) errors.push_back(error(point));
  for (const double value : errors) trial.mean_error += value / count;
  for (const double value : errors) trial.error_variance += (value - trial.mean_error) * (value - trial.mean_error) / count;
}

double worth(const Trial& trial, Choice choice) {
  switch (choice) {
    case Choice::kFewestIterations:
      return static_cast<double>(trial.plan.iterations);
    case Choice::kLeastError:
      return trial.mean_error;
    case Choice::kLeastVariance:
      return trial.error_variance;
  }
  return 0.0;
}

}  // namespace

std::vector<Trial> trials(const Space& space, const Point& start, const Point& goal, const Options& options, std::size_t count,
                          const Error& error, std::mt19937_64& random, std::stop_token stop) {
  std::vector<Trial> out;
  while (out.size() < count && !stop.stop_requested()) {
    std::mt19937_64 own(random());
    Trial& trial = out.emplace_back();
    trial.plan = plan(space, start, goal, options, own, stop);
    measure(trial, error);
  }
  return out;
}

std::optional<std::size_t> best(const std::vector<Trial>& trials, Choice choice) {
  std::optional<std::size_t> out;
  for (std::size_t k = 0; k < trials.size(); ++k) {
    if (trials[k].plan.ending != Ending::kReached) continue;
    if (!out || worth(trials[k], choice) < worth(trials[*out], choice)) out = k;
  }
  return out;
}

}  // namespace foothold::bioloid::paper
