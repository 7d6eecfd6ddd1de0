// Footsteps and strides, each kept only with the other.
#include "bioloid/steps/walk.hpp"

#include <algorithm>

namespace foothold::bioloid {
namespace {

constexpr double kLiftStep = 0.005;  // m: lifts are multiples of it, so that strides repeat

std::array<double, 7> ban_of(Side support, const PlanarPose& sole, const PlanarPose& place) {
  const PlanarPose at = rounded(sole);
  return {static_cast<double>(index_of(support)), at.x, at.y, at.heading, place.x, place.y, place.heading};
}

}  // namespace

Walker::Walker(const Model& model, Gait& gait, const WalkOptions& options, const std::vector<Prism>& prisms)
    : model_(model), gait_(gait), options_(options), prisms_(prisms), among_(model, gait.options().demands, prisms) {}

double Walker::half_spacing() const { return 0.5 * std::abs(beside(model_, Side::kRight).y); }

double Walker::lift_over(double height) const {
  if (height <= 0.0) return gait_.options().lift;
  const double needed = std::ceil((height + gait_.options().demands.clearance + 3e-3) / kLiftStep) * kLiftStep;
  return std::max(needed, gait_.options().lift);
}

// On the way between a place and beside the standing foot. Empty if something is too high.
std::optional<double> Walker::lift_for(Side support, const PlanarPose& sole, const PlanarPose& place) const {
  const double height =
      highest_between(model_, sole * beside(model_, support), sole * place, prisms_, gait_.options().demands.clearance);
  if (height > options_.step_over) return std::nullopt;
  return lift_over(height);
}

std::string Walker::refusal(Side side, const PlanarPose& sole) {
  if (const Prism* prism = stands_on(model_, sole, prisms_, gait_.options().demands.clearance))
    return "the foot would stand on or nearer than " + std::to_string(gait_.options().demands.clearance) + " m to obstacle '" +
           prism->name + "'";
  if (!fits(side, sole)) return "the robot's body meets an obstacle there";
  return "";
}

// The robot over this foot, the other lifted beside it.
bool Walker::fits(Side foot, const PlanarPose& sole) {
  if (!near(prisms_, sole)) return true;
  const Departure& middle = gait_.rough_departure(foot, beside(model_, foot), gait_.options().lift);
  if (!middle.sound()) return false;
  return among_.posture(middle.shift.points.back(),
                        {.foot = foot, .at = to_world(sole), .both = true, .second = to_world(beside(model_, foot))}) !=
         Fault::kObstacle;
}

bool Walker::near(const std::vector<Prism>& prisms, const PlanarPose& sole) {
  constexpr double kReach = 0.3;  // m: nothing of the robot is farther from its standing sole's centre
  for (const Prism& prism : prisms)
    if (geometry::distance(prism.polygon, {sole.x, sole.y}) < kReach) return true;
  return false;
}

bool Walker::clear(const std::vector<Phase>& phases, const PlanarPose& sole) {
  for (const Phase& phase : phases) {
    Support at = phase.support;
    at.at = to_world(sole);
    if (certify(among_, phase, at) != Fault::kNone) return false;
  }
  return true;
}

// At the postures between which a stride moves; the stride itself is certified when the route is known.
bool Walker::passes(Side support, const PlanarPose& sole, const PlanarPose& place, double lift) {
  const Departure& leaves = gait_.rough_departure(support, place, lift);
  if (!leaves.sound()) return false;
  Support both = leaves.shift.support, one = leaves.lift.support;
  both.at = one.at = to_world(sole);
  return among_.posture(leaves.shift.points.front(), both) != Fault::kObstacle &&
         among_.posture(leaves.shift.points.back(), both) != Fault::kObstacle &&
         among_.posture(leaves.lift.points.back(), one) != Fault::kObstacle;
}

Walker::Hindrance Walker::judge(const Placing& placing) {
  const bool close = near(prisms_, placing.sole);
  if (!close && judged_.empty()) return Hindrance::kNone;
  const auto key = ban_of(placing.support, placing.sole, placing.place);
  if (const auto known = judged_.find(key); known != judged_.end()) return known->second;
  if (!close) return Hindrance::kNone;
  return judged_[key] = look(placing);
}

Walker::Hindrance Walker::look(const Placing& placing) {
  const PlanarPose target = placing.sole * placing.place;
  const Side moves = other(placing.support);
  if (stands_on(model_, target, prisms_, gait_.options().demands.clearance)) return Hindrance::kObstacle;
  // The way there, and later the way of the foot that stands now from there.
  const PlanarPose back = rounded(inverse(placing.place));
  const auto there = lift_for(placing.support, placing.sole, placing.place), away = lift_for(moves, target, back);
  if (!there || !away) return Hindrance::kHeight;
  if (!fits(moves, target)) return Hindrance::kBody;
  const double lift = std::max(*there, *away);
  if (!gait_.placeable(placing.support, placing.place, lift)) return Hindrance::kReach;
  return passes(placing.support, placing.sole, placing.place, lift) && passes(moves, target, back, lift) ? Hindrance::kNone
                                                                                                         : Hindrance::kBody;
}

std::optional<Stride> Walker::stride(Side support, const PlanarPose& sole, const PlanarPose& from, const PlanarPose& to,
                                     std::mt19937_64& random, std::stop_token stop) {
  if (!near(prisms_, sole)) return gait_.stride(support, from, to, gait_.options().lift, random, stop);
  const auto leaves = lift_for(support, sole, from), comes = lift_for(support, sole, to);
  if (!leaves || !comes) return std::nullopt;
  const double straight = highest_between(model_, sole * from, sole * to, prisms_, gait_.options().demands.clearance);
  const double least = std::max(*leaves, *comes);
  // Straight over first; then beside the standing foot, where both ways were judged; higher where lines between key postures sag.
  for (int k = 0; k < 4; ++k) {
    const double lift = least + k * kLiftStep;
    if (straight <= options_.step_over)
      if (auto found = gait_.stride(support, from, to, lift, random, stop); found && clear(found->phases, sole)) return found;
    auto found = gait_.stride_with(support, from, to, lift, gait_.carry_beside(support, from, to, lift));
    if (found && clear(found->phases, sole)) return found;
  }
  return std::nullopt;
}

Walk Walker::walk(const Feet& start, const FootstepGoal& goal, std::mt19937_64& random, std::stop_token stop) {
  Walk out;
  const auto reaches = [&](Side support, const PlanarPose& place) {
    const bool yes = gait_.placeable(support, place, gait_.options().lift);
    if (!yes) ++hindrances_[static_cast<std::size_t>(Hindrance::kReach)];
    return yes;
  };
  const auto accept = [&](const Placing& placing) {
    const Hindrance found = judge(placing);
    ++hindrances_[static_cast<std::size_t>(found)];
    return found == Hindrance::kNone;
  };
  for (out.routes = 1; out.routes <= options_.most_routes; ++out.routes) {
    const Footsteps route = find_footsteps(start, goal, half_spacing(), options_.steps, reaches, accept, stop);
    out.expanded += route.expanded;
    // Later searches leave out what failed as a stride after one placement, though it might do after another: they prove nothing.
    if (out.routes == 1) out.least = route.least;
    if (route.end != Footsteps::End::kFound) {
      out.end = route.end == Footsteps::End::kStopped   ? Walk::End::kStopped
                : route.end == Footsteps::End::kTooMany ? Walk::End::kTooMany
                                                        : Walk::End::kNoFootsteps;
      constexpr const char* kWhat[] = {"", "a foot would stand on an obstacle", "an obstacle is too high to step over",
                                       "the legs do not reach", "the body would meet an obstacle"};
      const auto most = std::max_element(hindrances_.begin() + 1, hindrances_.end());
      if (*most > 0) out.hindrance = kWhat[most - hindrances_.begin()];
      return out;
    }
    out.steps.clear();
    Feet feet = start;
    bool sound = true;
    for (const Footstep& step : route.steps) {
      const Side support = other(step.foot);
      const PlanarPose sole = feet.of(support);
      const PlanarPose from = rounded(relative(sole, feet.of(step.foot))), to = rounded(relative(sole, step.sole));
      auto found = stride(support, sole, from, to, random, stop);
      if (stop.stop_requested()) {
        out.end = Walk::End::kStopped;
        return out;
      }
      if (!found) {
        judged_[ban_of(support, sole, to)] = Hindrance::kBody;
        sound = false;
        break;
      }
      feet.of(step.foot) = sole * to;
      out.steps.push_back({sole, std::move(*found), feet});
    }
    if (sound) {
      out.end = Walk::End::kFound;
      return out;
    }
  }
  out.steps.clear();
  out.end = Walk::End::kNoStrides;
  return out;
}

}  // namespace foothold::bioloid
