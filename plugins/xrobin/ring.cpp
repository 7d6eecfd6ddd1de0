// The eight curves of the ring and the ways along them.
#include "ring.hpp"

#include <algorithm>
#include <string>

#include "foothold/errors.hpp"

namespace foothold::xrobin {
namespace {

// What is under the root of w.
double radicand(const Lengths& n, double kept, double phi) {
  const double across = n.b + n.p * std::cos(phi);
  return kept * kept - across * across;
}

}  // namespace

Ring::Ring(const Mechanism& mechanism) : mechanism_(mechanism) {
  const Lengths& n = mechanism_.lengths();
  for (int from = 1; from <= kConfigurations; ++from) {
    const int to = neighbour(from, RingWay::kUp);
    const Configuration& a = mechanism_.configuration(from);
    const Configuration& b = mechanism_.configuration(to);
    RingEdge edge{from, to, a.l_extended != b.l_extended, 0.0, 0.0, a.phi, b.phi};
    edge.kept = edge.l_moves ? mechanism_.pistons(from).r : mechanism_.pistons(from).l;
    const double lift = edge.l_moves ? -1.0 : 1.0;
    const double w_from = a.y + lift * n.p * std::sin(a.phi);
    const double w_to = b.y + lift * n.p * std::sin(b.phi);
    edge.sign = w_from < 0.0 ? -1.0 : 1.0;
    // cos phi has no extremum between neighbours but at their ends, so the least radicand is at one of them.
    const bool open = radicand(n, edge.kept, a.phi) > 0.0 && radicand(n, edge.kept, b.phi) > 0.0;
    if (w_from * w_to <= 0.0 || !open)
      throw InvalidModel("piston.extended", "configurations " + std::to_string(from) + " and " + std::to_string(to) +
                                                " are not joined by the stroke of one piston");
    edges_[static_cast<std::size_t>(from - 1)] = edge;
  }
}

SlotPosture Ring::at(const RingEdge& edge, double phi) const {
  const Lengths& n = mechanism_.lengths();
  const double w = edge.sign * std::sqrt(std::max(0.0, radicand(n, edge.kept, phi)));
  const double lift = n.p * std::sin(phi);
  return {phi, w + (edge.l_moves ? lift : -lift)};
}

double Ring::slope_bound(const RingEdge& edge, double phi_a, double phi_b) const {
  // dy/dphi = +-p cos phi + (b + p cos phi) p sin phi / w, bounded factor by factor; |phi| is monotone on an edge.
  const Lengths& n = mechanism_.lengths();
  const double least = std::min(std::abs(phi_a), std::abs(phi_b));
  const double most = std::max(std::abs(phi_a), std::abs(phi_b));
  const double cosine = std::max(std::abs(std::cos(least)), std::abs(std::cos(most)));
  const double sine =
      most >= 0.5 * std::numbers::pi && least <= 0.5 * std::numbers::pi ? 1.0 : std::max(std::sin(least), std::sin(most));
  const double across = std::max(std::abs(n.b + n.p * std::cos(least)), std::abs(n.b + n.p * std::cos(most)));
  const double root = std::sqrt(std::min(radicand(n, edge.kept, phi_a), radicand(n, edge.kept, phi_b)));
  return n.p * cosine + across * n.p * sine / root;
}

std::vector<SlotPosture> way_along(const Ring& ring, int from, int to, RingWay way, int per_stroke) {
  std::vector<SlotPosture> out;
  for (int now = from; now != to; now = neighbour(now, way)) {
    const bool up = way == RingWay::kUp;
    const RingEdge& edge = ring.edge(up ? now : neighbour(now, way));
    const double begin = up ? edge.phi_from : edge.phi_to;
    const double end = up ? edge.phi_to : edge.phi_from;
    for (int k = 1; k < per_stroke; ++k) out.push_back(ring.at(edge, begin + (end - begin) * k / per_stroke));
    const Configuration& reached = ring.mechanism().configuration(neighbour(now, way));
    out.push_back({reached.phi, reached.y});
  }
  return out;
}

}  // namespace foothold::xrobin
