// Placements one by one: room for the sole, height of what is on the way, the body among the obstacles.
#include <algorithm>

#include "bioloid/steps/walk.hpp"

namespace foothold::bioloid {
namespace {

constexpr double kSlack = 1e-9;

}  // namespace

Walker::Spot Walker::spot_of(Side side, const PlanarPose& at) {
  constexpr double kUnit = 1e-6;  // m and rad: soles come to one place in different ways
  const auto units = [](double value) { return static_cast<std::int64_t>(std::llround(value / kUnit)); };
  return {static_cast<std::int64_t>(index_of(side)), units(at.x), units(at.y), units(wrapped(at.heading))};
}

Walker::Ban Walker::ban_of(const Placing& placing) {
  const Spot sole = spot_of(placing.support, placing.sole), place = spot_of(placing.support, placing.place);
  return {sole[0], sole[1], sole[2], sole[3], place[1], place[2], place[3]};
}

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

// Of a sole's place alone: room for it, and for the robot over it.
Walker::Hindrance Walker::room(Side side, const PlanarPose& sole) {
  const auto [known, is_new] = rooms_.try_emplace(spot_of(side, sole), Hindrance::kNone);
  if (is_new)
    known->second = stands_on(model_, sole, prisms_, gait_.options().demands.clearance) ? Hindrance::kObstacle
                    : fits(side, sole)                                                  ? Hindrance::kNone
                                                                                        : Hindrance::kBody;
  return known->second;
}

// The robot over this foot, the other lifted beside it.
bool Walker::fits(Side foot, const PlanarPose& sole) {
  if (!near(sole)) return true;
  const Departure& middle = gait_.rough_departure(foot, beside(model_, foot), gait_.options().lift);
  if (!middle.sound()) return false;
  return among_.clears(middle.shift.points.back(), {.foot = foot, .at = to_world(sole)});
}

bool Walker::near(const PlanarPose& sole) const {
  constexpr double kReach = 0.3;  // m: nothing of the robot is farther from its standing sole's centre
  return std::any_of(prisms_.begin(), prisms_.end(), [&](const Prism& prism) {
    return geometry::distance(prism.polygon, {sole.x, sole.y}) < kReach;
  });
}

bool Walker::clear(const std::vector<Phase>& phases, const PlanarPose& sole) {
  return std::all_of(phases.begin(), phases.end(),
                     [&](const Phase& phase) { return clears(among_, phase, {.foot = phase.support.foot, .at = to_world(sole)}); });
}

// At the postures between which a stride moves; the stride itself is certified when the route is known.
bool Walker::passes(Side support, const PlanarPose& sole, const PlanarPose& place, double lift) {
  const Departure& leaves = gait_.rough_departure(support, place, lift);
  if (!leaves.sound()) return false;
  const Support at{.foot = support, .at = to_world(sole)};
  return among_.clears(leaves.shift.points.front(), at) && among_.clears(leaves.shift.points.back(), at) &&
         among_.clears(leaves.lift.points.back(), at);
}

// Whether the other sole can leave a place, or come to it, at any of the lifts that strides have.
bool Walker::departs(Side support, const PlanarPose& sole, const PlanarPose& place) {
  if (!near(sole)) return gait_.departure(support, place, gait_.options().lift).sound();
  const auto least = lift_for(support, sole, place);
  if (!least) return false;
  const double most = lift_over(options_.step_over) + kHigherLifts * kLiftStep;
  for (double lift = *least; lift <= most + kSlack; lift += kLiftStep) {
    const Departure& leaves = gait_.departure(support, place, lift);
    if (leaves.sound() && clear({leaves.shift, leaves.lift}, sole)) return true;
  }
  return false;
}

Walker::Hindrance Walker::judge(const Placing& placing, Depth depth) {
  if (!near(placing.sole)) return reaches(placing.support, placing.place, gait_.options().lift, depth);
  const auto key = ban_of(placing);
  if (const auto known = judged_.find(key); known != judged_.end()) return known->second;
  const Hindrance found = look(placing, depth);
  // What has room may still turn out to be none.
  if (found != Hindrance::kNone || depth == Depth::kWhole) judged_[key] = found;
  return found;
}

Walker::Hindrance Walker::reaches(Side support, const PlanarPose& place, double lift, Depth depth) {
  const bool yes = depth == Depth::kRoom ? gait_.may_be_placeable(support, place, lift) : gait_.placeable(support, place, lift);
  return yes ? Hindrance::kNone : Hindrance::kReach;
}

Walker::Hindrance Walker::look(const Placing& placing, Depth depth) {
  const PlanarPose target = placing.sole * placing.place;
  const Side moves = other(placing.support);
  if (const Hindrance found = room(moves, target); found != Hindrance::kNone) return found;
  // The way there, and later the way of the foot that stands now from there.
  const PlanarPose back = rounded(inverse(placing.place));
  const auto there = lift_for(placing.support, placing.sole, placing.place), away = lift_for(moves, target, back);
  if (!there || !away) return Hindrance::kHeight;
  const double lift = std::max(*there, *away);
  const Hindrance reach = reaches(placing.support, placing.place, lift, depth);
  if (reach != Hindrance::kNone || depth == Depth::kRoom) return reach;
  return passes(placing.support, placing.sole, placing.place, lift) && passes(moves, target, back, lift) ? Hindrance::kNone
                                                                                                         : Hindrance::kBody;
}

}  // namespace foothold::bioloid
