// Which node of the ground lies beside which.
#pragma once

#include <span>
#include <vector>

#include "terrain/centroids.hpp"

namespace foothold::octopod {

// Lists of nodes, one after the other.
struct Lists {
  std::vector<int> all;
  std::vector<std::size_t> begin{0};  // one more than there are lists

  std::span<const int> of(int node) const {
    const auto n = static_cast<std::size_t>(node);
    return std::span<const int>(all).subspan(begin[n], begin[n + 1] - begin[n]);
  }
};

struct Neighbours {
  Lists nearest;                // the nodes with the nearest centroids, nearest first (paper, section 5)
  Lists adjacent;               // those, whoever has this one among theirs, and the triangles across the edges; sorted
  std::vector<double> lengths;  // of adjacent.all, between centroids, m
};

// Nodes are the ground triangles of `fine`: `triangles` by node, `node_of_triangle` the other way (-1: none).
Neighbours make_neighbours(const terrain::Terrain& fine, const terrain::CentroidTree& tree, std::span<const int> triangles,
                           std::span<const int> node_of_triangle, int count);

}  // namespace foothold::octopod
