// Edges in order, and those that face their own parts.
#include "terrain/adjacency.hpp"

#include <algorithm>

namespace foothold::terrain {
namespace {

struct Side {
  std::uint64_t edge;
  int triangle;
  bool operator<(const Side& other) const { return edge != other.edge ? edge < other.edge : triangle < other.triangle; }
};

struct Finder {
  const std::vector<Side>& sides;
  const Midpoints& midpoints;
  std::vector<std::pair<int, int>>& pairs;

  // `triangle` has the edge (a, b) whole; across it there are triangles with parts of it.
  void parts(int triangle, int a, int b) {
    const auto middle = midpoints.find(edge_key(a, b));
    if (middle == midpoints.end()) return;
    for (const int end : {a, b}) {
      const std::uint64_t part = edge_key(end, middle->second);
      const auto side = std::lower_bound(sides.begin(), sides.end(), Side{part, -1});
      if (side != sides.end() && side->edge == part)
        pairs.emplace_back(triangle, side->triangle), pairs.emplace_back(side->triangle, triangle);
      else
        parts(triangle, end, middle->second);
    }
  }
};

}  // namespace

void find_adjacent(Terrain& terrain, const Midpoints& midpoints) {
  std::vector<Side> sides;
  sides.reserve(3 * terrain.size());
  for (std::size_t t = 0; t < terrain.size(); ++t)
    for (std::size_t c = 0; c < 3; ++c)
      sides.push_back({edge_key(terrain.triangles[t][c], terrain.triangles[t][(c + 1) % 3]), static_cast<int>(t)});
  std::sort(sides.begin(), sides.end());
  std::vector<std::pair<int, int>> pairs;
  pairs.reserve(sides.size());
  Finder finder{sides, midpoints, pairs};
  for (std::size_t k = 0; k < sides.size(); ++k)
    if (k + 1 < sides.size() && sides[k + 1].edge == sides[k].edge) {
      pairs.emplace_back(sides[k].triangle, sides[k + 1].triangle);
      pairs.emplace_back(sides[k + 1].triangle, sides[k].triangle);
      ++k;
    } else {
      finder.parts(sides[k].triangle, static_cast<int>(sides[k].edge >> 32), static_cast<int>(sides[k].edge & 0xFFFFFFFFu));
    }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  terrain.adjacent.clear();
  terrain.adjacent_begin.assign(terrain.size() + 1, 0);
  for (const auto& [from, to] : pairs) {
    ++terrain.adjacent_begin[static_cast<std::size_t>(from) + 1];
    terrain.adjacent.push_back(to);
  }
  for (std::size_t t = 0; t < terrain.size(); ++t) terrain.adjacent_begin[t + 1] += terrain.adjacent_begin[t];
}

}  // namespace foothold::terrain
