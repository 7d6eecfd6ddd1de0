// The ring as eight edges, each judged once for a place.
#include "passage.hpp"

namespace foothold::xrobin {
namespace {

constexpr double kCell = 1e-9;  // m and rad

}  // namespace

std::size_t Passage::Hash::operator()(const Place& place) const {
  std::uint64_t h = static_cast<std::uint64_t>(place.x) * 0x9E3779B97F4A7C15ull;
  h ^= static_cast<std::uint64_t>(place.y) * 0xC2B2AE3D27D4EB4Full;
  h ^= static_cast<std::uint64_t>(place.heading) * 0x165667B19E3779F9ull;
  h ^= h >> 31;
  h *= 0xBF58476D1CE4E5B9ull;
  return static_cast<std::size_t>(h ^ (h >> 29));
}

Passage::Edges& Passage::edges_at(bool a_holds, const PlanarPose& held) {
  const Place place{std::llround(held.x / kCell), std::llround(held.y / kCell),
                    2 * std::llround(wrapped(held.heading) / kCell) + (a_holds ? 1 : 0)};
  return places_[place];
}

bool Passage::clear(Edges& edges, bool a_holds, const PlanarPose& held, int from) {
  const auto bit = static_cast<std::uint8_t>(1u << (from - 1));
  if ((edges.known & bit) == 0) {
    if (stop_.stop_requested()) return false;
    edges.known |= bit;
    if (surroundings_->edge_clear(a_holds, held, surroundings_->ring().edge(from))) edges.clear |= bit;
  }
  return (edges.clear & bit) != 0;
}

std::optional<RingWay> Passage::way(bool a_holds, const PlanarPose& held, int from, int to) {
  if (from == to) return RingWay::kUp;
  Edges& edges = edges_at(a_holds, held);
  const RingWay first = shorter_way(from, to);
  for (const RingWay way : {first, first == RingWay::kUp ? RingWay::kDown : RingWay::kUp}) {
    int now = from;
    while (now != to && clear(edges, a_holds, held, way == RingWay::kUp ? now : neighbour(now, way))) now = neighbour(now, way);
    if (now == to) return way;
  }
  return std::nullopt;
}

bool Passage::connected(bool a_holds, const PlanarPose& held, ConfigurationSet from, ConfigurationSet to) {
  if ((from & to) != 0) return true;
  if (from == 0 || to == 0) return false;
  for (int a = 1; a <= kConfigurations; ++a) {
    if (!holds(from, a)) continue;
    for (int b = 1; b <= kConfigurations; ++b)
      if (holds(to, b) && way(a_holds, held, a, b)) return true;
  }
  return false;
}

ConfigurationSet Passage::reachable(bool a_holds, const PlanarPose& held, ConfigurationSet from) {
  Edges& edges = edges_at(a_holds, held);
  ConfigurationSet out = from;
  for (int start = 1; start <= kConfigurations; ++start) {
    if (!holds(from, start)) continue;
    for (const RingWay way : {RingWay::kUp, RingWay::kDown})
      for (int now = start; out != 0xFF;) {
        const int next = neighbour(now, way);
        if (next == start || !clear(edges, a_holds, held, way == RingWay::kUp ? now : next)) break;
        out |= set_of(next);
        now = next;
      }
  }
  return out;
}

}  // namespace foothold::xrobin
