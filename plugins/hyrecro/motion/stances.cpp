#include "hyrecro/motion/stances.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "hyrecro/motion/lift.hpp"
#include "hyrecro/motion/liftable.hpp"
#include "hyrecro/motion/solutions.hpp"
#include "hyrecro/reach/inverse.hpp"

namespace foothold::hyrecro {
namespace {

constexpr SolutionGrid kGrid{0.15, 0.02, 0.2};
// Of a grid at most.
constexpr std::size_t kMost = 8;
// Of exact reachability at most.
constexpr int kMostOffered = 32;
// s: what a stance without room to lift costs.
constexpr double kNoRoom = 20.0;

// How far from the middle of their strokes the actuators are, s.
double eccentricity(const Model& model, const Actuators& q) {
  const double middle = 0.5 * (model.mechanism.shortest() + model.mechanism.longest());
  return (q.head<8>().array() - middle).abs().maxCoeff() / model.actuator_speed;
}

std::vector<Stance> of_grid(const Surroundings& around, const Surroundings& from_placed, const Isometry3d& pose, bool last,
                            double height) {
  const Model& model = around.model;
  std::vector<Stance> all, out;
  for (const Coordinates& c : solutions(model, pose, kGrid, nullptr)) {
    Stance stance = stance_of(model, c, height);
    if (!stance.lands || !(stance.leaves || last)) continue;
    stance.cost = eccentricity(model, to_actuators(model, c));
    all.push_back(std::move(stance));
  }
  std::stable_sort(all.begin(), all.end(), [](const Stance& a, const Stance& b) { return a.cost < b.cost; });
  // Half of them may be of one side of the hip.
  std::array<std::size_t, 2> taken{0, 0};
  for (Stance& stance : all) {
    std::size_t& of_side = taken[std::cos(stance.coordinates.hip[0]) < 0.0 ? 1 : 0];
    if (of_side == kMost / 2 || judge_posture(around, stance.coordinates) ||
        judge_posture(around, from_actuators(model, stance.landing)) ||
        (!last && judge_posture(from_placed, from_actuators(model, stance.leaving))))
      continue;
    ++of_side;
    out.push_back(std::move(stance));
    if (out.size() == kMost) break;
  }
  return out;
}

// A stance below a posture that has the free foot `height` over `pose`, both free of collisions; among the first that reachability
// offers, as to prove that there is none takes far longer.
std::optional<Coordinates> from_above(const Surroundings& around, Reachability& exact, const Isometry3d& pose, double height) {
  std::optional<Coordinates> out;
  int offered = 0;
  exact.reach(pose * Eigen::Translation3d(0.0, 0.0, height), [&](const Coordinates& top) {
    out = lifted(around.model, top, -height);
    if (!out) out = inverse(around.model, pose, branch_of(top), free_of(around.model, top));
    if (out && (judge_posture(around, top) || judge_posture(around, *out))) out.reset();
    return out.has_value() || ++offered == kMostOffered;
  });
  return out;
}

}  // namespace

Stance stance_of(const Model& model, const Coordinates& c, double height) {
  const std::optional<Coordinates> landing = lifted(model, c, height), leaving = lifted(model, swapped(c), height);
  return {c,
          to_actuators(model, landing.value_or(c)),
          to_actuators(model, leaving.value_or(swapped(c))),
          landing.has_value(),
          leaving.has_value(),
          (landing ? 0.0 : kNoRoom) + (leaving ? 0.0 : kNoRoom)};
}

std::vector<Stance> stances_at(const Surroundings& around, Reachability& exact, const Isometry3d& placed, const Coordinates& given,
                               bool last, double height, std::string& reason) {
  const Model& model = around.model;
  const Isometry3d pose = around.holding.inverse(Eigen::Isometry) * placed;
  const Surroundings from_placed{model, around.obstacles, placed, around.clearance, around.stop};
  std::vector<Stance> out = of_grid(around, from_placed, pose, last, height);
  if (out.empty()) {
    // At the border of the workspace the grid finds nothing; exact reachability does, from above.
    if (!free_foot_liftable(exact, pose, height)) {
      reason = "the foot cannot be set down: at its place it cannot be lifted, reachability ends there";
      return {};
    }
    if (!last && !holding_foot_liftable(exact, pose, height)) {
      reason = "the other foot could not be lifted next: reachability ends there";
      return {};
    }
    if (const auto c = from_above(around, exact, pose, height)) out.push_back(stance_of(model, *c, height));
    if (!last)
      if (const auto c = from_above(from_placed, exact, pose.inverse(Eigen::Isometry), height))
        out.push_back(stance_of(model, swapped(*c), height));
  }
  out.push_back(stance_of(model, given, height));
  return out;
}

}  // namespace foothold::hyrecro
