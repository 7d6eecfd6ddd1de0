// Thinner bodies and one backward tree for each eighth of a turn.
#include "near_goal.hpp"

namespace foothold::xrobin {

Bodies thinner(const Bodies& bodies, double by) {
  const auto less = [&](const Block& block) {
    return Block{std::max(0.0, block.half_x - by), std::max(0.0, block.half_y - by), block.height};
  };
  return {less(bodies.a), less(bodies.b), bodies.piston_radius - by};
}

NearGoal::NearGoal(const HalfCycles& half_cycles, const Origins& origins, const Surroundings& surroundings, int most_levels,
                   const Target& goal, double heading, double radius, const std::stop_token& stop)
    : half_cycles_(&half_cycles),
      origins_(&origins),
      most_levels_(most_levels),
      goal_(goal),
      heading_(heading),
      radius_(radius),
      // A pose `most_levels` links away from an end moves by the end's distance from the goal and by its turn times that far.
      thinner_(surroundings.ring(),
               thinner(surroundings.bodies(), radius + kMostTurn * (most_levels * half_cycles.mechanism().travel() +
                                                                    2.0 * half_cycles.mechanism().lengths().p)),
               surroundings.obstacles(), surroundings.clearance()),
      passage_(thinner_, stop) {}

bool NearGoal::may_lead(int n, std::uint32_t suffix, const PlanarPose& end) {
  const double eighths = (end.heading - heading_) / (0.25 * std::numbers::pi);
  const double nearest = std::round(eighths);
  if (std::abs(eighths - nearest) * 0.25 * std::numbers::pi > kMostTurn) return true;
  auto& tree = trees_[static_cast<std::size_t>(static_cast<long>(nearest) & 7)];
  if (!tree) {
    tree = std::make_unique<ReachTree>(*half_cycles_, *origins_, passage_, most_levels_);
    tree->plant({goal_.x, goal_.y, heading_ + nearest * 0.25 * std::numbers::pi}, 0);
  }
  return tree->reach(n, suffix) != 0 || passage_.stopped();
}

}  // namespace foothold::xrobin
