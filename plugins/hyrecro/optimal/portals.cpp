#include "hyrecro/optimal/portals.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace foothold::hyrecro {
namespace {

constexpr double kEdge = 0.2;        // m, of a cell
constexpr double kUnparted = 0.2;    // m: a beam and half a plate to each side of it need more
constexpr double kOpposite = 0.157;  // m: half a sampling step aside still is opposite

std::uint64_t between(int face, int towards) {
  return (static_cast<std::uint64_t>(face) << 32) | static_cast<std::uint32_t>(towards);
}

}  // namespace

Portals::Portals(const Transitions& transitions, std::size_t faces) : transitions_(&transitions) {
  make_cells(faces);
  join();
}

void Portals::make_cells(std::size_t faces) {
  of_.resize(transitions_->all().size());
  footholds_.reserve(of_.size());
  std::vector<std::tuple<int, int, int>> sorted;
  for (std::size_t face = 0; face < faces; ++face) {
    face_begins_.push_back(static_cast<int>(begins_.size()));
    sorted.clear();
    for (const int k : transitions_->of_face(static_cast<int>(face))) {
      const Vector2d& place = at(k).foothold.at;
      sorted.emplace_back(static_cast<int>(std::floor(place.x() / kEdge)), static_cast<int>(std::floor(place.y() / kEdge)), k);
    }
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 0; i < sorted.size(); ++i) {
      const auto [x, y, k] = sorted[i];
      if (i == 0 || std::get<0>(sorted[i - 1]) != x || std::get<1>(sorted[i - 1]) != y) {
        begins_.push_back(footholds_.size());
        middles_.push_back(Vector3d::Zero());
        places_.emplace_back();
      }
      footholds_.push_back(k);
      middles_.back() += at(k).pose.translation();
      places_.back().extend(at(k).foothold.at);
      of_[static_cast<std::size_t>(k)] = static_cast<int>(begins_.size()) - 1;
    }
  }
  face_begins_.push_back(static_cast<int>(begins_.size()));
  begins_.push_back(footholds_.size());
  for (int cell = 0; cell < cells(); ++cell)
    middles_[static_cast<std::size_t>(cell)] /= static_cast<double>(footholds(cell).size());
}

void Portals::join() {
  std::vector<std::pair<int, int>> pairs;  // from, to
  for (std::size_t face = 0; face + 1 < face_begins_.size(); ++face)
    for (int a = face_begins_[face]; a < face_begins_[face + 1]; ++a)
      // Cells are in order of x.
      for (int b = a + 1; b < face_begins_[face + 1]; ++b) {
        const auto &one = places_[static_cast<std::size_t>(a)], &other = places_[static_cast<std::size_t>(b)];
        if (other.min().x() > one.max().x() + 2.0 * kEdge + kUnparted) break;
        if (one.squaredExteriorDistance(other) > kUnparted * kUnparted) continue;
        pairs.emplace_back(a, b);
        pairs.emplace_back(b, a);
      }
  std::unordered_map<std::uint64_t, std::vector<int>> rows;
  const int count = static_cast<int>(of_.size());
  for (int k = 0; k < count; ++k) rows[between(at(k).foothold.face, at(k).towards)].push_back(k);
  std::vector<std::pair<double, int>> others;
  for (const auto& [key, row] : rows) {
    const int face = at(row.front()).foothold.face, towards = at(row.front()).towards;
    if (towards < face) continue;
    const auto opposite = rows.find(between(towards, face));
    if (opposite == rows.end()) continue;
    const Vector3d line = at(row.front()).pose.linear().col(1);
    others.clear();
    for (const int k : opposite->second) others.emplace_back(along(k, line), k);
    std::sort(others.begin(), others.end());
    for (const int k : row) {
      const double place = along(k, line);
      for (auto other = std::lower_bound(others.begin(), others.end(), std::pair(place - kOpposite, 0));
           other != others.end() && other->first <= place + kOpposite; ++other) {
        const int a = of_[static_cast<std::size_t>(k)], b = of_[static_cast<std::size_t>(other->second)];
        pairs.emplace_back(a, b);
        pairs.emplace_back(b, a);
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  edge_begins_.assign(static_cast<std::size_t>(cells()) + 1, 0);
  edges_.reserve(pairs.size());
  for (const auto& [from, to] : pairs) {
    edges_.push_back({to, face_of(from) == face_of(to), (middle(from) - middle(to)).norm()});
    edge_begins_[static_cast<std::size_t>(from) + 1] = edges_.size();
  }
  for (std::size_t k = 1; k < edge_begins_.size(); ++k) edge_begins_[k] = std::max(edge_begins_[k], edge_begins_[k - 1]);
}

std::vector<Portals::Beside> Portals::beside(int face, const Vector2d& place) const {
  constexpr double kApart = 0.4;  // m
  std::vector<Beside> out;
  for (int cell = face_begins_[static_cast<std::size_t>(face)]; cell < face_begins_[static_cast<std::size_t>(face) + 1]; ++cell)
    if (const double distance = places_[static_cast<std::size_t>(cell)].exteriorDistance(place); distance < kApart)
      out.push_back({cell, distance});
  return out;
}

std::vector<std::pair<int, int>> Portals::opposite(int from, int to) const {
  std::vector<std::tuple<double, int, int>> sorted;
  const int face = face_of(from), towards = face_of(to);
  for (const int a : footholds(from)) {
    if (at(a).towards != towards) continue;
    const Vector3d line = at(a).pose.linear().col(1);
    const double place = along(a, line);
    for (const int b : footholds(to))
      if (at(b).towards == face && at(b).convex == at(a).convex)
        if (const double aside = std::fabs(along(b, line) - place); aside <= kOpposite)
          sorted.emplace_back(std::round(aside * 1e3), a, b);
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::pair<int, int>> out;
  for (const auto& [aside, a, b] : sorted) out.emplace_back(a, b);
  return out;
}

}  // namespace foothold::hyrecro
