// Footsteps and strides, each kept only with the other.
#include "bioloid/steps/walk.hpp"

#include <algorithm>

namespace foothold::bioloid {
namespace {

constexpr double kSame = 1e-6;  // m, between a sole's place come to in different ways

// Rows of footsteps are searched for with room alone so often and within so many nodes; after that placements are judged as the
// search takes them.
constexpr int kUnjudgedRows = 8;
constexpr std::size_t kUnjudgedNodes = 1000;

}  // namespace

Walker::Walker(const Model& model, Gait& gait, const WalkOptions& options, const std::vector<Prism>& prisms)
    : model_(model), gait_(gait), options_(options), prisms_(prisms), among_(model, gait.options().demands, prisms) {}

std::optional<Stride> Walker::stride(Side support, const PlanarPose& sole, const PlanarPose& from, const PlanarPose& to,
                                     std::mt19937_64& random, std::stop_token stop) {
  if (!near(sole)) return gait_.stride(support, from, to, gait_.options().lift, random, stop);
  const auto [known, is_new] = strides_.try_emplace({ban_of({support, sole, from}), ban_of({support, sole, to})});
  if (is_new) known->second = stride_among(support, sole, from, to, random, stop);
  return known->second;
}

std::optional<Stride> Walker::stride_among(Side support, const PlanarPose& sole, const PlanarPose& from, const PlanarPose& to,
                                           std::mt19937_64& random, std::stop_token stop) {
  const auto leaves = lift_for(support, sole, from), comes = lift_for(support, sole, to);
  if (!leaves || !comes) return std::nullopt;
  const double straight = highest_between(model_, sole * from, sole * to, prisms_, gait_.options().demands.clearance);
  const bool passable = straight <= options_.step_over;
  const double least = std::max(*leaves, *comes);
  const auto among = [&](std::optional<Stride> found) {
    return found && clear(found->phases, sole) ? std::move(found) : std::nullopt;
  };
  if (gait_.options().paper) {
    const double lift = passable ? std::max(least, lift_over(straight)) : least;
    return among(
        gait_.stride_with(support, from, to, lift, gait_.paper_carry(among_, support, sole, from, to, lift, random, stop)));
  }
  // Straight over first; then beside the standing foot, where both ways were judged; then higher.
  for (int k = 0; k <= kHigherLifts; ++k) {
    const double lift = least + k * kLiftStep;
    if (passable)
      if (auto found = among(gait_.stride(support, from, to, lift, random, stop))) return found;
    if (auto found = among(gait_.stride_with(support, from, to, lift, gait_.carry_beside(support, from, to, lift)))) return found;
  }
  return std::nullopt;
}

// Of a row of footsteps. Empty if one fails; then it is recorded which placement no row may have, if that is the reason, or else
// which stride failed after the placement before.
std::optional<std::vector<WalkStep>> Walker::strides(const Feet& start, const std::vector<Footstep>& row, std::mt19937_64& random,
                                                     std::stop_token stop) {
  std::vector<WalkStep> out;
  Feet feet = start;
  std::optional<Placing> before;
  for (const Footstep& step : row) {
    const Side support = other(step.foot);
    const PlanarPose sole = feet.of(support);
    const PlanarPose from = rounded(relative(sole, feet.of(step.foot))), to = rounded(relative(sole, step.sole));
    const Placing placing{support, sole, to};
    auto found = stride(support, sole, from, to, random, stop);
    if (stop.stop_requested()) return std::nullopt;
    if (!found) {
      const auto counts = [&](const Placing& at, const PlanarPose& place) {
        Hindrance verdict = judge(at, Depth::kWhole);
        if (verdict == Hindrance::kNone && !departs(support, sole, place)) verdict = judged_[ban_of(at)] = Hindrance::kBody;
        return verdict == Hindrance::kNone;
      };
      if (counts(placing, to) && (!before || counts(*before, from))) failed_.push_back(placing);
      return std::nullopt;
    }
    feet.of(step.foot) = sole * to;
    out.push_back({sole, std::move(*found), feet});
    before = placing;
  }
  return out;
}

Walk Walker::walk(const Feet& start, const FootstepGoal& goal, std::mt19937_64& random, std::stop_token stop) {
  Walk out;
  Depth depth = Depth::kRoom;
  bool without_failed = true;
  const auto count = [&](Hindrance found) {
    ++hindrances_[static_cast<std::size_t>(found)];
    return found == Hindrance::kNone;
  };
  const Acceptance acceptance{
      .open =
          [&](const PlanarPose& sole) {
            return !near(sole) && !(without_failed && std::any_of(failed_.begin(), failed_.end(), [&](const Placing& placing) {
                                      return distance(placing.sole, sole) < kSame;
                                    }));
          },
      .reaches = [&](Side support, const PlanarPose& place) { return count(reaches(support, place, gait_.options().lift, depth)); },
      .accept =
          [&](const Placing& placing) {
            const bool failed = without_failed && std::any_of(failed_.begin(), failed_.end(), [&](const Placing& other) {
                                  return ban_of(other) == ban_of(placing);
                                });
            return count(failed ? Hindrance::kBody : judge(placing, depth));
          }};
  const auto ended = [&](Walk::End end) {
    out.end = end;
    return out;
  };

  // A walk. What strides need is dear to know and seldom lacking: so rows of footsteps first, their strides after.
  StepOptions unjudged = options_.steps;
  unjudged.most_nodes = std::min(unjudged.most_nodes, kUnjudgedNodes);
  while (out.steps.empty()) {
    if (failed_.size() >= static_cast<std::size_t>(options_.most_routes)) return ended(Walk::End::kNoStrides);
    if (out.routes >= kUnjudgedRows || out.expanded >= kUnjudgedNodes) depth = Depth::kWhole;
    const Footsteps route =
        find_footsteps(start, goal, half_spacing(), depth == Depth::kRoom ? unjudged : options_.steps, acceptance, stop);
    out.expanded += route.expanded;
    if (depth == Depth::kRoom && route.end == Footsteps::End::kTooMany) continue;
    if (route.end == Footsteps::End::kStopped) return ended(Walk::End::kStopped);
    if (route.end != Footsteps::End::kFound) {
      constexpr const char* kWhat[] = {"", "a foot would stand on an obstacle", "an obstacle is too high to step over",
                                       "the legs do not reach", "the body would meet an obstacle"};
      const auto most = std::max_element(hindrances_.begin() + 1, hindrances_.end());
      if (*most > 0) out.hindrance = kWhat[most - hindrances_.begin()];
      return ended(route.end == Footsteps::End::kTooMany ? Walk::End::kTooMany : Walk::End::kNoFootsteps);
    }
    if (route.steps.empty()) return ended(Walk::End::kFound);
    ++out.routes;
    if (auto found = strides(start, route.steps, random, stop)) out.steps = std::move(*found);
    if (stop.stop_requested()) return ended(Walk::End::kStopped);
  }

  // That it is least: what has room is more than what counts, so rows with room prove it too, where they are as long. Strides that
  // failed after one placement might not after another: without these shorter walks may be found, but nothing is proved.
  depth = Depth::kRoom;
  without_failed = false;
  for (int rows = 0; rows < kUnjudgedRows; ++rows) {
    const std::size_t nodes = options_.steps.proof_nodes;
    const Footsteps route = least_footsteps(start, goal, half_spacing(), options_.steps, out.steps.size(),
                                            depth == Depth::kRoom ? std::min(nodes, kUnjudgedNodes) : nodes, acceptance, stop);
    out.expanded += route.expanded;
    if (route.end == Footsteps::End::kStopped) return ended(Walk::End::kStopped);
    if (!without_failed) out.least = std::max(out.least, std::min(route.least, out.steps.size()));
    const bool shorter = route.end == Footsteps::End::kFound;
    bool sound = false;
    if (shorter) {
      ++out.routes;
      const std::size_t failed = failed_.size();
      auto found = strides(start, route.steps, random, stop);
      if (stop.stop_requested()) return ended(Walk::End::kStopped);
      if (found) out.steps = std::move(*found);
      sound = found.has_value();
      without_failed = without_failed || failed_.size() > failed;
    }
    if (out.least == out.steps.size() || (depth == Depth::kWhole && (!shorter || sound))) break;
    depth = Depth::kWhole;
  }
  return ended(Walk::End::kFound);
}

}  // namespace foothold::bioloid
