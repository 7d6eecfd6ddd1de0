// Searches and motions in turn.
#include "hyrecro/travel.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>

namespace foothold::hyrecro {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostBans = 8;
constexpr double kBanStep = 0.02;  // m
constexpr double kSameCost = 1e-9;

class Stopwatch {
 public:
  explicit Stopwatch(double& total) : total_(total) {}
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;
  ~Stopwatch() { total_ += std::chrono::duration<double, std::milli>(Clock::now() - begin_).count(); }

 private:
  double& total_;
  Clock::time_point begin_ = Clock::now();
};

// Nothing better than `bound` was ruled out.
void hold_to(double bound, Found& found) {
  found.lower_bound = std::min(bound, found.cost);
  found.optimal = found.cost - found.lower_bound <= kSameCost * std::max(1.0, found.cost);
}

struct Best {
  Found found;
  const Beginning* beginning = nullptr;
};

// The cheapest of all beginnings; if none leads to the goal, why the first does not. A proof must hold for every beginning.
Best cheapest(const Options& options, const std::vector<Beginning>& from, const Search& search) {
  using Outcome = Found::Outcome;
  Best best;
  double bound = std::numeric_limits<double>::infinity();
  for (const Beginning& beginning : from) {
    Found found = search(options, beginning.holding);
    if (found.outcome == Outcome::kStopped) return {std::move(found), &beginning};
    const bool reached = found.outcome == Outcome::kReached;
    // A search that gave up has not proved that there is no cheaper way.
    if (reached || found.failure.error == PlanError::kSearchLimit) bound = std::min(bound, found.lower_bound);
    const bool first = best.beginning == nullptr;
    if (first || (reached && (best.found.outcome != Outcome::kReached || found.cost < best.found.cost - kSameCost)))
      best = {std::move(found), &beginning};
  }
  if (best.found.outcome == Outcome::kReached) hold_to(bound, best.found);
  return best;
}

std::string told(const truss::Truss& truss, const Foothold& at) {
  char text[64];
  std::snprintf(text, sizeof text, " (%.3f, %.3f) m", at.at.x(), at.at.y());
  return "'" + truss.faces[static_cast<std::size_t>(at.face)].name + "'" + text;
}

}  // namespace

Travel plan_travel(const Model& model, const PreparedTruss& scene, const Options& options, const std::vector<Beginning>& from,
                   const Search& search, PlanContext& context) {
  Travel out;
  Options with = options;
  std::optional<double> bound;
  for (std::size_t bans = 0;; ++bans) {
    Best best;
    {
      const Stopwatch watch(out.times.search);
      best = cheapest(with, from, search);
    }
    if (best.found.outcome == Found::Outcome::kStopped || context.stop.stop_requested()) {
      out.stopped = true;
      return out;
    }
    if (best.found.outcome == Found::Outcome::kFailed) {
      if (bans == 0) out.failure = best.found.failure;
      return out;
    }
    if (!bound) bound = best.found.lower_bound;
    hold_to(*bound, best.found);
    out.beginning = *best.beginning;
    if (options.motion) {
      const Stopwatch watch(out.times.motion);
      const Route& route = best.found.route;
      RouteMotions motions = plan_motions(model, scene.obstacles, scene.truss, route, best.beginning->coordinates,
                                          best.beginning->stands, options.motions, context.random, context.stop);
      if (context.stop.stop_requested()) {
        out.stopped = true;
        return out;
      }
      if (motions.failed >= 0) {
        const auto k = static_cast<std::size_t>(motions.failed);
        const Foothold& holding = k == 0 ? route.start : route.strides[k - 1].to;
        out.failure = {PlanError::kNoPath, "",
                       "no motion was found for a stride to " + told(scene.truss, route.strides[k].to) +
                           " while the other foot holds at " + told(scene.truss, holding) + ": " + motions.reason + "; " +
                           (bans == 0 ? std::string("1 route was") : std::to_string(bans + 1) + " routes were") + " tried",
                       "lower clearance or lift, or plan with motion: false to see the footholds"};
        if (options.method == Method::kPaper || bans == kMostBans) return out;
        // Neighbours fail for the same reason as a rule; the further the more often it did.
        with.optimal.banned.push_back({holding, route.strides[k].to, kBanStep * static_cast<double>(bans + 1)});
        continue;
      }
      best.found.route = std::move(motions.route);
      out.motions = std::move(motions.motions);
    }
    out.found = std::move(best.found);
    return out;
  }
}

std::vector<double> costs_of(const Found& found, const Options& options, const truss::Truss& truss) {
  std::vector<double> out;
  double cost = 0.0;
  Foothold before = found.route.start;
  for (const Stride& stride : found.route.strides) {
    cost += options.optimal.objective == Objective::kDistance
                ? (pose_of(truss, stride.to).translation() - pose_of(truss, before).translation()).norm()
                : 1.0;
    out.push_back(cost);
    before = stride.to;
  }
  return out;
}

}  // namespace foothold::hyrecro
