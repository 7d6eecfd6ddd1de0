// Sampling and certifying a path, finer where a line between samples does not do.
#include "bioloid/gait/phase.hpp"

#include <algorithm>

namespace foothold::bioloid {
namespace {

constexpr int kFinest = 4;  // halvings of a period

struct Sampler {
  const JointPath& path;
  Judge& judge;
  double duration;
  Phase& out;

  // From the last point to `next` at `until`; both in shares of the duration.
  bool advance(double from, double until, const Joints& next, int halvings) {
    const unsigned ends = (from <= 0.0 ? out.ground & 1U : 0U) | (until >= 1.0 ? out.ground & 2U : 0U);
    const Fault fault = judge.motion(out.points.back(), next, out.support, ends);
    if (fault == Fault::kNone) {
      out.points.push_back(next);
      out.times.push_back(until * duration);
      return true;
    }
    if (halvings == kFinest) {
      out.fault = fault;
      return false;
    }
    const double middle = 0.5 * (from + until);
    Joints between;
    if (!path(eased(middle), between)) {
      out.fault = Fault::kLimit;
      return false;
    }
    return advance(from, middle, between, halvings + 1) && advance(middle, until, next, halvings + 1);
  }
};

}  // namespace

Phase make_phase(const char* name, const Model& model, Judge& judge, const Support& support, const JointPath& path,
                 const Pace& pace, unsigned ground) {
  Phase out;
  out.name = name;
  out.support = support;
  out.ground = ground;
  const double time = duration(model, path, pace);
  Joints next;
  if (time < 0.0 || !path(0.0, next)) {
    out.fault = Fault::kLimit;
    return out;
  }
  const int samples = static_cast<int>(std::lround(time / pace.period));
  out.points.reserve(static_cast<std::size_t>(samples) + 1);
  out.points.push_back(next);
  out.times.push_back(0.0);
  Sampler sampler{path, judge, time, out};
  for (int k = 1; k <= samples; ++k) {
    const double from = static_cast<double>(k - 1) / samples, until = static_cast<double>(k) / samples;
    if (!path(eased(until), next)) {
      out.fault = Fault::kLimit;
      return out;
    }
    if (!sampler.advance(from, until, next, 0)) return out;
  }
  return out;
}

Fault certify(Judge& judge, const Phase& phase, const Support& support) {
  const std::size_t lines = phase.points.size() - 1;
  for (std::size_t k = 0; k < lines; ++k) {
    const unsigned ends = (k == 0 ? phase.ground & 1U : 0U) | (k + 1 == lines ? phase.ground & 2U : 0U);
    if (const Fault fault = judge.motion(phase.points[k], phase.points[k + 1], support, ends); fault != Fault::kNone) return fault;
  }
  return Fault::kNone;
}

bool clears(Judge& judge, const Phase& phase, const Support& support) {
  for (std::size_t k = 1; k < phase.points.size(); ++k)
    if (!judge.clears(phase.points[k - 1], phase.points[k], support)) return false;
  return true;
}

Phase reversed(const Phase& phase) {
  Phase out = phase;
  std::reverse(out.points.begin(), out.points.end());
  const double end = phase.times.empty() ? 0.0 : phase.times.back();
  for (std::size_t k = 0; k < phase.times.size(); ++k) out.times[k] = end - phase.times[phase.times.size() - 1 - k];
  out.ground = ((phase.ground & 1U) << 1) | ((phase.ground & 2U) >> 1);
  return out;
}

double duration(std::span<const Phase> phases) {
  double sum = 0.0;
  for (const Phase& phase : phases)
    if (!phase.times.empty()) sum += phase.times.back();
  return sum;
}

}  // namespace foothold::bioloid
