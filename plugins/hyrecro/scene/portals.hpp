// Transition footholds gathered in cells of their faces, and which cells lead to which: how large scenes are searched, where what
// reaches what cannot be listed foothold by foothold.
//
// Cells of one face are neighbours where no beam can stand between them; what stands on a face parts them, as no plate finds room
// there. Cells of two faces are neighbours where footholds in them stand opposite each other across the line in which the faces
// meet, as they were sampled for each other.
#pragma once

#include <span>
#include <unordered_map>
#include <vector>

#include "hyrecro/scene/transitions.hpp"

namespace foothold::hyrecro {

// Transition footholds, from which on a scene counts as large: proving the best route takes seconds there, if it comes to an end.
inline constexpr std::size_t kLarge = 50'000;

// Immutable after construction, which takes time of the order of the footholds. Borrows them.
class Portals {
 public:
  Portals(const Transitions& transitions, std::size_t faces);

  struct Edge {
    int to = -1;
    bool leg = false;     // on one face; else a transition
    double length = 0.0;  // m, between the cells' middles
  };
  int cells() const { return static_cast<int>(begins_.size()) - 1; }
  std::span<const Edge> edges(int cell) const { return part(edges_, edge_begins_, cell); }
  // Index of edges(cell).front() among those of all cells.
  std::size_t first_edge(int cell) const { return edge_begins_[static_cast<std::size_t>(cell)]; }
  std::size_t edges() const { return edges_.size(); }
  std::span<const int> footholds(int cell) const { return part(footholds_, begins_, cell); }
  int face_of(int cell) const { return at(footholds(cell).front()).foothold.face; }
  const Vector3d& middle(int cell) const { return middles_[static_cast<std::size_t>(cell)]; }  // m, world
  // Cells beside a place on a face, to which nothing but the cells themselves can be in the way, with the distance to their
  // footholds (m).
  struct Beside {
    int cell = -1;
    double distance = 0.0;
  };
  std::vector<Beside> beside(int face, const Vector2d& place) const;
  // Pairs of footholds of two cells that stand opposite each other, the most opposite first.
  std::vector<std::pair<int, int>> opposite(int from, int to) const;

 private:
  template <class T>
  static std::span<const T> part(const std::vector<T>& all, const std::vector<std::size_t>& begins, int k) {
    const auto i = static_cast<std::size_t>(k);
    return {all.data() + begins[i], begins[i + 1] - begins[i]};
  }
  const TransitionFoothold& at(int foothold) const { return transitions_->all()[static_cast<std::size_t>(foothold)]; }
  // The line's direction is one for both sides but for its sign; places (m) along it.
  double along(int foothold, const Vector3d& line) const { return line.dot(at(foothold).pose.translation()); }
  struct Run;
  void make_cells(std::size_t faces);
  std::vector<Run> runs(const std::vector<int>& row, const Vector3d& line) const;
  void join();

  const Transitions* transitions_;
  std::vector<int> footholds_;  // by cell
  std::vector<std::size_t> begins_, edge_begins_;
  std::vector<Edge> edges_;
  std::vector<Vector3d> middles_;
  std::vector<Eigen::AlignedBox2d> places_;  // m, on the face, by cell
  std::vector<int> of_;                      // cell by foothold
  std::vector<int> face_begins_;             // first cell of each face, and the end
};

}  // namespace foothold::hyrecro
