// The best trial's movements as a path, and its figures.
#include "bioloid/gait/paper_way.hpp"

#include <algorithm>

namespace foothold::bioloid {

std::optional<Phase> paper_way(const Model& model, Judge& judge, const Support& support, const Free& a, const Free& b,
                               const Pace& pace, const PaperOptions& options, PaperFigures& figures, std::mt19937_64& random,
                               std::stop_token stop) {
  Joints from, to;
  ++figures.ways;
  if (!from_free(model, support.foot, a, from) || !from_free(model, support.foot, b, to)) return std::nullopt;
  const paper::NineTrials found = paper::nine_trials(model, judge, support, from, to, options.nine, options.method, options.trials,
                                                     options.choice, random, stop);
  figures.trials += found.trials.size();
  for (const paper::Trial& trial : found.trials) {
    figures.iterations += trial.plan.iterations;
    figures.reached += trial.plan.ending == paper::Ending::kReached;
  }
  if (!found.best || found.postures.size() < 2) return std::nullopt;
  figures.movements += found.postures.size() - 1;

  std::vector<Free> corners;
  for (const Joints& joints : found.postures) corners.push_back(to_free(model, support.foot, joints));
  const JointPath path = [&](double s, Joints& joints) {
    const double at = s * static_cast<double>(corners.size() - 1);
    const std::size_t k = std::min(static_cast<std::size_t>(at), corners.size() - 2);
    return from_free(model, support.foot, corners[k] + (at - static_cast<double>(k)) * (corners[k + 1] - corners[k]), joints);
  };
  Phase phase = make_phase("carry", model, judge, support, path, pace, 0);
  if (!phase.sound()) return std::nullopt;
  ++figures.found;
  return phase;
}

}  // namespace foothold::bioloid
