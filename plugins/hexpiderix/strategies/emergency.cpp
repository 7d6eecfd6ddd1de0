// One more supporting leg: the paper's by the longest of twelve distances, ours by the greatest stability.
#include <algorithm>
#include <cmath>

#include "hexpiderix/strategies/orientation.hpp"
#include "hexpiderix/strategies/strategies.hpp"

namespace foothold::hexpiderix {
namespace {

constexpr std::pair<std::size_t, std::size_t> kPairs[12] = {{1, 3}, {3, 5}, {5, 1}, {0, 2}, {2, 4}, {4, 0},
                                                            {0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}, {5, 0}};

// Where a leg would stand: under its standing place, straight down onto the ground.
Footholds with_leg(const Model& model, const Situation& from, std::size_t leg) {
  Footholds out = from.footholds;
  const Vector3d place = from.thorax * standing_foot(model, leg);
  out.supports[leg] = true;
  out.points[leg] = place - from.ground.above(place) * from.ground.normal;
  out.normals[leg] = from.ground.normal;
  return out;
}

// The thorax turned level as far as it goes, in tenths of its inclination.
Adapted levelled(const Model& model, const Situation& from, std::size_t leg) {
  constexpr int kTenths = 10;
  Adapted out{Adapted::Strategy::kEmergency, with_leg(model, from, leg), {}, "leg " + std::to_string(leg + 1) + " added"};
  const Orientation now = orientation_of(from.thorax);
  for (int tenths = kTenths; tenths >= 0; --tenths) {
    const double rest = 1.0 - static_cast<double>(tenths) / kTenths;
    const Isometry3d thorax = turned(from.thorax, {.roll = rest * now.roll, .pitch = rest * now.pitch, .yaw = now.yaw});
    out.evaluation = evaluate(model, from.ground, out.footholds, thorax, {model.lift, true}, from.clearance);
    if (out.evaluation.valid()) break;
  }
  return out;
}

// Longest distance to a support, and the sum over all supports to settle ties: the hexagon has many equal distances.
std::pair<double, double> distances_to_supports(const Footholds& all, std::size_t leg, Legs supports) {
  constexpr double kSame = 1e-9;
  double longest = 0.0, sum = 0.0;
  for (const Distance& d : distances(all)) {
    if ((d.a != leg || !supports[d.b]) && (d.b != leg || !supports[d.a])) continue;
    longest = std::max(longest, d.metres);
    sum += d.metres;
  }
  return {kSame * std::round(longest / kSame), sum};
}

}  // namespace

std::vector<Distance> distances(const Footholds& footholds) {
  std::vector<Distance> out;
  for (const auto& [a, b] : kPairs) out.push_back({a, b, (footholds.points[a] - footholds.points[b]).norm()});
  return out;
}

Adapted emergency(const Model& model, const Situation& from, EmergencyRule rule) {
  Situation all = from;
  for (std::size_t leg = 0; leg < kLegs; ++leg)
    if (!from.footholds.supports[leg]) all.footholds.points[leg] = with_leg(model, from, leg).points[leg];
  Adapted best{Adapted::Strategy::kEmergency, from.footholds, {}, "no leg is left to add"};
  std::pair<double, double> farthest{-1.0, -1.0};
  for (std::size_t leg = 0; leg < kLegs; ++leg) {
    if (from.footholds.supports[leg]) continue;
    const Adapted with = levelled(model, from, leg);
    if (rule == EmergencyRule::kBestMargin) {
      if (best.about.starts_with("no leg") || with.evaluation.nesm > best.evaluation.nesm) best = with;
      continue;
    }
    const auto distance = distances_to_supports(all.footholds, leg, from.footholds.supports);
    if (distance > farthest) {
      farthest = distance;
      best = with;
    }
  }
  return best;
}

}  // namespace foothold::hexpiderix
