#include "hyrecro/optimal/optimal.hpp"

#include <algorithm>
#include <cmath>

#include "hyrecro/optimal/gates.hpp"
#include "hyrecro/optimal/large.hpp"
#include "hyrecro/optimal/reasons.hpp"

namespace foothold::hyrecro {
namespace {

constexpr double kSameCost = 1e-9;

// What is kept depends on the room that is demanded, so plans with motions and without have their own; latest first.
struct KeptByRoom final : PreparedTruss::Kept {
  std::vector<std::unique_ptr<KeptTruss>> recent;
};
constexpr std::size_t kRooms = 2;

KeptTruss& kept_of(const Model& model, const PreparedTruss& scene, double lift) {
  auto* by_room = dynamic_cast<KeptByRoom*>(scene.kept.get());
  if (by_room == nullptr) {
    auto fresh = std::make_unique<KeptByRoom>();
    by_room = fresh.get();
    scene.kept = std::move(fresh);
  }
  auto& recent = by_room->recent;
  const auto known = std::find_if(recent.begin(), recent.end(), [&](const auto& kept) { return kept->strides.lift() == lift; });
  if (known != recent.end()) {
    std::rotate(recent.begin(), known, known + 1);
  } else {
    if (recent.size() == kRooms) recent.pop_back();
    recent.insert(recent.begin(), std::make_unique<KeptTruss>(model, scene));
    recent.front()->strides.demand_room(lift);
  }
  recent.front()->tidy();
  return *recent.front();
}

std::string in_words(const OptimalOptions& options, bool large) {
  std::string out =
      options.objective == Objective::kSteps ? "least strides, then least length" : "least length, then least strides";
  if (large)
    out = "few strides, not the least: the scene is so large that the first good route is taken";
  else
    out += ", over all routes through the sampled transition footholds, with any footholds on the faces";
  if (options.lift > 0.0) out += ", from which each foot can be lifted";
  if (!options.banned.empty())
    out += ", without " + std::to_string(options.banned.size()) + " strides for which no motion was found";
  return out;
}

// The search's own lengths hold preferences, which are taken out of what is reported.
void hold_costs(const PreparedTruss& scene, const OptimalOptions& options, const SearchResult& result, Found& out) {
  out.optimal = result.cost.first - result.bound.first <= kSameCost;
  out.cost = result.cost.first;
  out.lower_bound = result.bound.first;
  if (options.objective == Objective::kDistance) {
    out.cost = length_of(scene.truss, out.route);
    out.lower_bound -= 2.0 * kPreference * static_cast<double>(out.route.strides.size());
  }
  out.lower_bound = out.optimal ? out.cost : std::min(out.lower_bound, out.cost);
}

// As plan_optimal(), without what leads round ends that are hemmed in: `ends` tells which these are, if there is no route.
struct Ends {
  bool start = false, goal = false;
};
Found plan_between(const Model& model, const PreparedTruss& scene, KeptTruss& kept, const Foothold& start, const Foothold& goal,
                   const OptimalOptions& options, const std::stop_token& stop, Ends& hemmed) {
  Found out;
  out.objective = in_words(options, kept.large());
  TrussGraph graph(model, scene, kept, start, goal, options);
  if (!same(start, goal)) hemmed = {graph.hemmed_in(graph.start()), graph.hemmed_in(graph.goal())};
  if (hemmed.start || hemmed.goal) {
    const int end = hemmed.start ? graph.start() : graph.goal();
    out.failure = hemmed_in(scene, graph.at(end), hemmed.start ? "start" : "goal");
    return out;
  }
  SearchResult result;
  if (kept.large()) result = search_large(graph, *scene.portals, stop);
  if (!kept.large() || (kept.listable() && result.outcome == SearchResult::Outcome::kLimit)) {
    out.objective = in_words(options, false);
    result = search_route(graph, options.max_nodes, stop);
  }
  if (result.outcome == SearchResult::Outcome::kNone && graph.guessed()) {
    graph.stop_guessing();  // what is said to be unreachable is so without guesses
    result = search_route(graph, options.max_nodes, stop);
  }
  out.figures.push_back({"states", static_cast<double>(result.settled), 0.0, "1"});
  out.lower_bound = result.bound == kNever ? 0.0 : result.bound.first;
  switch (result.outcome) {
    case SearchResult::Outcome::kStopped:
      out.outcome = Found::Outcome::kStopped;
      return out;
    case SearchResult::Outcome::kLimit:
      if (!kept.listable()) {
        out.failure = {PlanError::kSearchLimit, "scene",
                       "no way from face to face that was tried on this large truss can be walked; there may be others",
                       "give a goal nearer by, or one between, or a part of the truss as the scene"};
        hemmed = {!kept.legs.has_footing(start, false), !kept.legs.has_footing(goal, false)};
      } else {
        out.failure = {PlanError::kSearchLimit, "parameters.max_nodes",
                       "the search gave up after " + std::to_string(result.settled) + " states", "raise max_nodes"};
      }
      return out;
    case SearchResult::Outcome::kNone:
      out.failure = why_unreachable(graph, scene, kept, stop);
      hemmed = {!kept.legs.has_footing(start, false), !kept.legs.has_footing(goal, false)};
      return out;
    case SearchResult::Outcome::kFound:
      break;
  }
  out.outcome = Found::Outcome::kReached;
  out.route.start = start;
  for (const Hop& hop : result.hops)
    for (Stride& stride : graph.strides_of(hop)) out.route.strides.push_back(std::move(stride));
  hold_costs(scene, options, result, out);
  return out;
}

// Routes through the gates of ends that are hemmed in; the best of them. No proof but that of the straight way.
Found plan_through_gates(const Model& model, const PreparedTruss& scene, KeptTruss& kept, const Foothold& start,
                         const Foothold& goal, const OptimalOptions& options, const std::stop_token& stop, const Ends& hemmed) {
  const Banned banned = banned_by(options.banned);
  const auto ways = [&](const Foothold& end, bool by_gates) {
    return by_gates ? gates(kept.strides, kept.legs, *kept.filter, end, banned, stop) : std::vector<Stride>{{end, {}}};
  };
  Found best;
  const std::vector<Stride> from = ways(start, hemmed.start);
  if (from.empty()) return best;
  const std::vector<Stride> to = ways(goal, hemmed.goal);
  const bool steps = options.objective == Objective::kSteps;
  for (const Stride& first : from)
    for (const Stride& last : to) {
      if (kept.large() && best.outcome == Found::Outcome::kReached) break;
      Ends none;
      Found one = plan_between(model, scene, kept, first.to, last.to, options, stop, none);
      if (one.outcome != Found::Outcome::kReached) continue;
      std::vector<Stride>& strides = one.route.strides;
      if (hemmed.start) strides.insert(strides.begin(), first);
      if (hemmed.goal) strides.push_back({goal, swapped(last.coordinates)});
      one.route.start = start;
      one.cost = steps ? static_cast<double>(strides.size()) : length_of(scene.truss, one.route);
      if (best.outcome == Found::Outcome::kReached && best.cost <= one.cost) continue;
      best = std::move(one);
    }
  const double straight = (pose_of(scene.truss, goal).translation() - pose_of(scene.truss, start).translation()).norm();
  best.lower_bound = steps ? std::ceil(straight / kept.strides.bounds().transition_reach() - kSameCost) : straight;
  best.optimal = best.cost - best.lower_bound <= kSameCost;
  best.objective += "; hardly any stride leads to or from an end, so through a few of these";
  return best;
}

}  // namespace

Found plan_optimal(const Model& model, const PreparedTruss& scene, const Foothold& start, const Foothold& goal,
                   const OptimalOptions& options, const std::stop_token& stop, const OnStride& on_stride) {
  KeptTruss& kept = kept_of(model, scene, options.lift);
  Ends hemmed;
  Found out = plan_between(model, scene, kept, start, goal, options, stop, hemmed);
  if (out.outcome == Found::Outcome::kFailed && (hemmed.start || hemmed.goal)) {
    Found through = plan_through_gates(model, scene, kept, start, goal, options, stop, hemmed);
    if (through.outcome == Found::Outcome::kReached)
      out = std::move(through);
    else if (stop.stop_requested())
      out.outcome = Found::Outcome::kStopped;
  }
  if (out.outcome != Found::Outcome::kReached) return out;
  if (on_stride)
    for (const Stride& stride : out.route.strides)
      if (!on_stride(stride)) {
        out.outcome = Found::Outcome::kStopped;
        break;
      }
  return out;
}

}  // namespace foothold::hyrecro
