#include "hyrecro/optimal/optimal.hpp"

#include <algorithm>

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
  out += ", over all routes through the sampled transition footholds, with any footholds on the faces";
  if (large) out += ", transitions between opposite ones alone as there are so many";
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

}  // namespace

Found plan_optimal(const Model& model, const PreparedTruss& scene, const Foothold& start, const Foothold& goal,
                   const OptimalOptions& options, const std::stop_token& stop, const OnStride& on_stride) {
  Found out;
  KeptTruss& kept = kept_of(model, scene, options.lift);
  out.objective = in_words(options, kept.large());
  TrussGraph graph(model, scene, kept, start, goal, options);
  for (const auto& [end, field] : {std::pair(graph.start(), "start"), std::pair(graph.goal(), "goal")})
    if (!same(start, goal) && graph.hemmed_in(end)) {
      out.failure = hemmed_in(scene, graph.at(end), field);
      return out;
    }
  SearchResult result = search_route(graph, options.max_nodes, stop);
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
      out.failure = {PlanError::kSearchLimit, "parameters.max_nodes",
                     "the search gave up after " + std::to_string(result.settled) + " states", "raise max_nodes"};
      return out;
    case SearchResult::Outcome::kNone:
      out.failure = why_unreachable(graph, scene, kept, stop);
      return out;
    case SearchResult::Outcome::kFound:
      break;
  }
  out.outcome = Found::Outcome::kReached;
  out.route.start = start;
  for (const Hop& hop : result.hops)
    for (Stride& stride : graph.strides_of(hop)) out.route.strides.push_back(std::move(stride));
  hold_costs(scene, options, result, out);
  if (on_stride)
    for (const Stride& stride : out.route.strides)
      if (!on_stride(stride)) {
        out.outcome = Found::Outcome::kStopped;
        break;
      }
  return out;
}

}  // namespace foothold::hyrecro
