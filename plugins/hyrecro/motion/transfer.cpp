#include "hyrecro/motion/transfer.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include "hyrecro/motion/lift.hpp"

namespace foothold::hyrecro {
namespace {

// Of postures that RRTConnect may judge before it gives up; about 50 ms.
constexpr long kMostJudged = 12'000;
// m: how much higher the free sole is taken over what is in its way.
constexpr double kHigher[] = {0.02, 0.05};
// Tries to cut corners, after a way in closed form and after RRTConnect.
constexpr int kCuts = 6, kCutsAfterSearch = 40;

double duration(const Model& model, const std::vector<Actuators>& way) {
  double out = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) out += duration(model, way[i - 1], way[i]);
  return out;
}

// `b` with its hips turned either way round, quickest first.
std::vector<Actuators> ends_of(const Model& model, const Actuators& a, const Actuators& b) {
  constexpr double turn = 2.0 * std::numbers::pi;
  const Actuators nearest = with_nearest_turns(a, b);
  std::vector<Actuators> out;
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j) {
      Actuators end = nearest;
      end[8] += i * turn;
      end[9] += j * turn;
      if (std::max(std::abs(end[8] - a[8]), std::abs(end[9] - a[9])) < 0.9 * turn) out.push_back(end);
    }
  std::stable_sort(out.begin(), out.end(),
                   [&](const Actuators& x, const Actuators& y) { return duration(model, a, x) < duration(model, a, y); });
  return out;
}

Actuators higher(const Model& model, const Actuators& q, double height) {
  const Coordinates stance = from_actuators(model, q);
  const std::optional<Coordinates> top = lifted(model, stance, room_to_lift(model, stance, height));
  return top ? with_nearest_turns(q, to_actuators(model, *top)) : q;
}

// Both legs upright, the one that holds long, the free one short, hips as in `q`.
Actuators tucked(const Model& model, const Actuators& q) {
  const double shortest = model.mechanism.shortest(), longest = model.mechanism.longest(), inset = 0.1 * (longest - shortest);
  Actuators out = q;
  out.head<4>().setConstant(longest - inset);
  out.segment<4>(4).setConstant(shortest + inset);
  return out;
}

// Ways in closed form, quickest first.
std::vector<std::vector<Actuators>> candidates(const Model& model, const Actuators& a, const std::vector<Actuators>& ends) {
  constexpr std::size_t kHeights = std::size(kHigher);
  std::array<Actuators, kHeights> above_a, above_b;
  for (std::size_t k = 0; k < kHeights; ++k) {
    above_a[k] = higher(model, a, kHigher[k]);
    above_b[k] = higher(model, ends.front(), kHigher[k]);
  }
  std::vector<std::vector<Actuators>> out;
  for (const Actuators& end : ends) {
    const auto above_end = [&](std::size_t k) {
      Actuators above = above_b[k];
      above.tail<2>() = end.tail<2>();
      return above;
    };
    out.push_back({a, end});
    for (std::size_t k = 0; k < kHeights; ++k) out.push_back({a, above_a[k], above_end(k), end});
    const Actuators tucked_a = tucked(model, a), tucked_end = tucked(model, end);
    out.push_back({a, tucked_a, tucked_end, end});
    out.push_back({a, 0.5 * (tucked_a + tucked_end), end});
    out.push_back({a, above_a[1], tucked_a, tucked_end, above_end(1), end});
  }
  std::stable_sort(out.begin(), out.end(), [&](const auto& x, const auto& y) { return duration(model, x) < duration(model, y); });
  return out;
}

}  // namespace

std::optional<Transfer> transfer(const Surroundings& around, const Actuators& a, const Actuators& b, bool search,
                                 std::mt19937_64& random, std::string& reason) {
  const std::vector<Actuators> ends = ends_of(around.model, a, b);
  Blocked first;
  for (const Actuators& end : {a, b})
    if (const Blocked blocked = judge_posture(around, from_actuators(around.model, end))) {
      reason = "with the foot lifted, " + blocked.what;
      return std::nullopt;
    }
  for (const auto& way : candidates(around.model, a, ends)) {
    const Blocked blocked = judge_way(around, way);
    if (around.stop.stop_requested()) break;
    if (blocked) {
      if (!first) first = blocked;
      continue;
    }
    Transfer out{way, false};
    if (way.size() > 2) shorten(around, kCuts, random, out.points);
    return out;
  }
  if (!search) {
    reason = "on the straight way " + first.what;
    return std::nullopt;
  }
  if (std::optional<std::vector<Actuators>> way = connect(around, a, ends, kMostJudged, random)) {
    shorten(around, kCutsAfterSearch, random, *way);
    return Transfer{std::move(*way), true};
  }
  reason = around.stop.stop_requested() ? "stopped"
                                        : "on the straight way " + first.what + ", and RRTConnect found no other way in " +
                                              std::to_string(kMostJudged) + " postures";
  return std::nullopt;
}

void shorten(const Surroundings& around, int tries, std::mt19937_64& random, std::vector<Actuators>& way) {
  const Model& model = around.model;
  const auto drawn = [&random] { return static_cast<double>(random() >> 11U) * 0x1.0p-53; };
  for (int i = 0; i < tries && way.size() > 2; ++i) {
    // Two places, each a piece and a part of it.
    const double pieces = static_cast<double>(way.size() - 1);
    double first = drawn() * pieces, second = drawn() * pieces;
    if (i == 0) first = 0.0, second = pieces;
    if (first > second) std::swap(first, second);
    const auto piece = [&](double at) { return std::min(static_cast<std::size_t>(at), way.size() - 2); };
    const std::size_t from = piece(first), to = piece(second);
    if (from == to) continue;
    const auto place = [&](std::size_t k, double at) -> Actuators {
      return way[k] + (at - static_cast<double>(k)) * (way[k + 1] - way[k]);
    };
    const Actuators a = place(from, first), b = place(to, second);
    double before = duration(model, a, way[from + 1]) + duration(model, way[to], b);
    for (std::size_t k = from + 1; k < to; ++k) before += duration(model, way[k], way[k + 1]);
    if (duration(model, a, b) > 0.999 * before || judge_way(around, a, b)) continue;
    std::vector<Actuators> next(way.begin(), way.begin() + static_cast<std::ptrdiff_t>(from) + 1);
    for (const Actuators& corner : {a, b})
      if ((corner - next.back()).cwiseAbs().maxCoeff() > 1e-12) next.push_back(corner);
    for (std::size_t k = to + 1; k < way.size(); ++k)
      if ((way[k] - next.back()).cwiseAbs().maxCoeff() > 1e-12) next.push_back(way[k]);
    next.back() = way.back();
    way = std::move(next);
  }
}

}  // namespace foothold::hyrecro
