#include "hyrecro/scene/portals.hpp"

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

// Footholds of one face that head for one other, one after the other in one cell.
struct Portals::Run {
  int cell = -1;
  double low = 0.0, high = 0.0;  // m, along the line
};

void Portals::join() {
  std::vector<std::vector<int>> next(static_cast<std::size_t>(cells()));
  const auto both = [&](int a, int b) {
    next[static_cast<std::size_t>(a)].push_back(b);
    next[static_cast<std::size_t>(b)].push_back(a);
  };
  for (std::size_t face = 0; face + 1 < face_begins_.size(); ++face)
    for (int a = face_begins_[face]; a < face_begins_[face + 1]; ++a)
      // Cells are in order of x.
      for (int b = a + 1; b < face_begins_[face + 1]; ++b) {
        const auto &one = places_[static_cast<std::size_t>(a)], &other = places_[static_cast<std::size_t>(b)];
        if (other.min().x() > one.max().x() + 2.0 * kEdge + kUnparted) break;
        if (one.squaredExteriorDistance(other) <= kUnparted * kUnparted) both(a, b);
      }
  std::unordered_map<std::uint64_t, std::vector<int>> rows;
  std::vector<int>* row = nullptr;
  std::uint64_t last = 0;
  for (int k = 0; k < static_cast<int>(of_.size()); ++k) {
    const std::uint64_t key = between(at(k).foothold.face, at(k).towards);
    if (row == nullptr || key != last) row = &rows[key];
    last = key;
    row->push_back(k);
  }
  for (const auto& [key, one] : rows) {
    const int face = at(one.front()).foothold.face, towards = at(one.front()).towards;
    if (towards < face) continue;
    const auto other = rows.find(between(towards, face));
    if (other == rows.end()) continue;
    const Vector3d line = at(one.front()).pose.linear().col(1);
    const std::vector<Run> ours = runs(one, line), theirs = runs(other->second, line);
    for (const Run& a : ours) {
      auto b = std::lower_bound(theirs.begin(), theirs.end(), a.low - kOpposite - 2.0 * kEdge,
                                [](const Run& run, double low) { return run.low < low; });
      for (; b != theirs.end() && b->low <= a.high + kOpposite; ++b)
        if (b->high >= a.low - kOpposite) both(a.cell, b->cell);
    }
  }
  edge_begins_.assign(1, 0);
  for (int cell = 0; cell < cells(); ++cell) {
    std::vector<int>& to = next[static_cast<std::size_t>(cell)];
    std::sort(to.begin(), to.end());
    to.erase(std::unique(to.begin(), to.end()), to.end());
    for (const int other : to) edges_.push_back({other, face_of(cell) == face_of(other), (middle(cell) - middle(other)).norm()});
    edge_begins_.push_back(edges_.size());
  }
}

std::vector<Portals::Run> Portals::runs(const std::vector<int>& row, const Vector3d& line) const {
  std::vector<Run> out;
  for (const int k : row) {
    const int cell = of_[static_cast<std::size_t>(k)];
    const double place = along(k, line);
    if (out.empty() || out.back().cell != cell) out.push_back({cell, place, place});
    out.back().low = std::min(out.back().low, place);
    out.back().high = std::max(out.back().high, place);
  }
  std::stable_sort(out.begin(), out.end(), [](const Run& a, const Run& b) { return a.low < b.low; });
  return out;
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
