// The edges of one face, outline and holes, found by where they are: faces of long beams have hundreds of cuts.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "truss/truss.hpp"

namespace foothold::hyrecro {

// In the face's frame, m. Immutable after construction; any thread.
class FaceEdges {
 public:
  // The face lies to the left of the way from a to b.
  struct Edge {
    geometry::Vector2d a, b;
  };
  explicit FaceEdges(const truss::Face& face);

  // Calls visit(edge) for each edge that comes into low <= x <= high, some others perhaps, none twice.
  template <class Visit>
  void visit(double low, double high, Visit&& visit) const {
    for (const Edge& edge : wide_) visit(edge);
    const int first = cell(low), last = cell(high);
    for (int c = first; c <= last; ++c)
      for (const Edge& edge : in_cell(c))
        if (c == std::max(first, cell(std::min(edge.a.x(), edge.b.x())))) visit(edge);
  }
  // On an edge: either.
  bool contains(const geometry::Vector2d& point) const;
  const Eigen::AlignedBox2d& bounds() const { return bounds_; }

 private:
  int cell(double x) const {
    return static_cast<int>(std::clamp((x - bounds_.min().x()) / width_, 0.0, static_cast<double>(begins_.size() - 2)));
  }
  std::span<const Edge> in_cell(int c) const {
    const auto k = static_cast<std::size_t>(c);
    return {edges_.data() + begins_[k], begins_[k + 1] - begins_[k]};
  }

  Eigen::AlignedBox2d bounds_;
  double width_ = 1.0;               // of a cell along x
  std::vector<Edge> wide_;           // edges over many cells
  std::vector<Edge> edges_;          // by cell, once for each cell that they come into
  std::vector<std::size_t> begins_;  // of each cell in edges_, and the end
};

}  // namespace foothold::hyrecro
