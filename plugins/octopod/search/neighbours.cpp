// Nearest centroids by the tree, and their union with the mesh's own neighbours, both ways.
#include "octopod/search/neighbours.hpp"

#include <algorithm>

namespace foothold::octopod {

Neighbours make_neighbours(const terrain::Terrain& fine, const terrain::CentroidTree& tree, std::span<const int> triangles,
                           std::span<const int> node_of_triangle, int count) {
  Neighbours out;
  const auto centroid = [&](int node) {
    return fine.centroids[static_cast<std::size_t>(triangles[static_cast<std::size_t>(node)])];
  };
  std::vector<std::vector<int>> beside(triangles.size());
  for (std::size_t node = 0; node < triangles.size(); ++node) {
    const int self = static_cast<int>(node), triangle = triangles[node];
    // One more than wanted, as a centroid is nearest to itself.
    int taken = 0;
    for (const int t : tree.nearest(fine.centroids[static_cast<std::size_t>(triangle)], static_cast<std::size_t>(count) + 1)) {
      const int other = node_of_triangle[static_cast<std::size_t>(t)];
      if (other == self || taken == count) continue;
      ++taken;
      out.nearest.all.push_back(other);
      beside[node].push_back(other);
      beside[static_cast<std::size_t>(other)].push_back(self);
    }
    out.nearest.begin.push_back(out.nearest.all.size());
    for (const int t : fine.neighbours(triangle))
      if (const int other = node_of_triangle[static_cast<std::size_t>(t)]; other >= 0) {
        beside[node].push_back(other);
        beside[static_cast<std::size_t>(other)].push_back(self);
      }
  }
  for (auto& list : beside) {
    std::sort(list.begin(), list.end());
    out.adjacent.all.insert(out.adjacent.all.end(), list.begin(), std::unique(list.begin(), list.end()));
    for (std::size_t k = out.lengths.size(); k < out.adjacent.all.size(); ++k)
      out.lengths.push_back((centroid(out.adjacent.all[k]) - centroid(static_cast<int>(&list - beside.data()))).norm());
    out.adjacent.begin.push_back(out.adjacent.all.size());
  }
  return out;
}

}  // namespace foothold::octopod
