// Legs that are hard to find: their first and last strides are as long as they can be, or lead past what stands on the face.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "hyrecro/optimal/legs.hpp"

namespace foothold::hyrecro {
namespace {

constexpr int kAcross = 6, kTurns = 8, kAlong = 16;  // footholds looked at: across the strip, by heading, along the strip
constexpr double kStep = 0.001;                      // m: no nearer to each other along it
constexpr std::size_t kPairs = 60;                   // of first and last footholds that are tried, at most

}  // namespace

// Footholds whose paces along the strip, seen from `end`, are from `least` to `most`, the furthest first; `take` says whether to go
// on to the next nearer one (1), to the next line (0), or to end (-1: then true).
template <typename Take>
bool Legs::scan(const Foothold& end, double sense, double least, double most, const Take& take) {
  const Strip along = strip(end.face);
  const Vector2d aside(-along.along.y(), along.along.x()), plate = strides_.model().plate.head<2>();
  const double turned = std::atan2(along.along.y(), along.along.x()), step = std::max(kStep, (most - least) / kAlong);
  for (int turn = 0; turn < kTurns; ++turn) {
    // Along first, then across, then between.
    constexpr int order[kTurns] = {0, 4, 2, 6, 1, 7, 3, 5};
    const double heading = std::numbers::pi * order[turn] / kTurns;
    const double half = 0.5 * (plate.x() * std::fabs(std::sin(heading)) + plate.y() * std::fabs(std::cos(heading)));
    const double low = along.low - along.inset + half, high = along.high + along.inset - half;
    if (low > high) continue;
    for (int line = -1; line <= kAcross; ++line) {
      const double own = along.across(end.at), across = line < 0 ? own : low + line * (high - low) / kAcross;
      if (across < low || across > high) continue;
      for (double advance = most; advance >= least; advance -= step) {
        const Foothold there{end.face, end.at + sense * advance * along.along + (across - own) * aside, heading + turned};
        if (least_anywhere(end, there) != 1 || !strides_.on_face(there)) continue;
        const int next = take(there, advance);
        if (next < 0) return true;
        if (next == 0) break;
      }
    }
  }
  return false;
}

std::vector<Legs::Reached> Legs::reached_from(const Foothold& end, double sense, double least, double most, const Banned& banned) {
  std::vector<Reached> out;
  scan(end, sense, least, most, [&](const Foothold& there, double advance) {
    if (banned && banned(end, there)) return 1;
    const std::optional<Coordinates> found = strides_.level(end, there);
    if (!found) return 1;
    out.push_back({{there, *found}, advance});
    return 0;
  });
  std::stable_sort(out.begin(), out.end(), [](const Reached& a, const Reached& b) { return a.advance > b.advance; });
  return out;
}

std::optional<std::vector<Stride>> Legs::two(const Foothold& u, const Foothold& v, const Banned& banned) {
  const double way = strip(u.face).along.dot(v.at - u.at), sense = way < 0.0 ? -1.0 : 1.0;
  const Advances of_u = advances_of(u), of_v = advances_of(v);
  const double least = std::fabs(way) - (way < 0.0 ? of_v.forth : of_v.back), most = way < 0.0 ? of_u.back : of_u.forth;
  std::optional<std::vector<Stride>> out;
  scan(u, sense, least, most, [&](const Foothold& there, double) {
    if (least_anywhere(there, v) != 1 || (banned && (banned(u, there) || banned(there, v)))) return 1;
    const std::optional<Coordinates> first = strides_.level(u, there);
    if (!first) return 1;
    const std::optional<Coordinates> second = strides_.level(there, v);
    if (!second) return 1;
    out = {{there, *first}, {v, *second}};
    return -1;
  });
  return out;
}

std::optional<std::vector<Stride>> Legs::find_thoroughly(const Foothold& u, const Foothold& v, int count, const Banned& banned) {
  if (count < 2) return find(u, v, count, banned);
  if (count == 2) return two(u, v, banned);
  const double way = strip(u.face).along.dot(v.at - u.at), sense = way < 0.0 ? -1.0 : 1.0;
  const Advances of_u = advances_of(u), of_v = advances_of(v);
  const double first = way < 0.0 ? of_u.back : of_u.forth, last = way < 0.0 ? of_v.forth : of_v.back;
  const double between = (count - 2) * bounds_.reach();
  const std::vector<Reached> from = reached_from(u, sense, std::fabs(way) - between - last, first, banned);
  const std::vector<Reached> to = reached_from(v, -sense, std::fabs(way) - between - first, last, banned);
  std::size_t pairs = 0;
  // Far ones with far ones first.
  for (std::size_t sum = 0; sum + 1 < from.size() + to.size(); ++sum)
    for (std::size_t i = sum < to.size() ? 0 : sum - to.size() + 1; i <= sum && i < from.size(); ++i) {
      const Foothold &one = from[i].stride.to, &other = to[sum - i].stride.to;
      if (least_anywhere(one, other) > count - 2 || same(one, other)) continue;
      if (++pairs > kPairs) return std::nullopt;
      auto middle = find(one, other, count - 2, banned);
      if (!middle) continue;
      std::vector<Stride> out{from[i].stride};
      out.insert(out.end(), middle->begin(), middle->end());
      out.push_back({v, swapped(to[sum - i].stride.coordinates)});
      return out;
    }
  return std::nullopt;
}

}  // namespace foothold::hyrecro
