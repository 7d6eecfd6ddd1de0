// Shortest ways inside a polygon with holes: exact, over the visibility graph of its reflex vertices.
//
// A shortest way bends at reflex vertices only, and touches them like a taut thread (Lee and Preparata, Networks 14:393, 1984). So
// the ways between reflex vertices are kept, and a query looks for what both its ends see; ends that see each other are asked
// first.
#pragma once

#include <vector>

#include "geometry/polygon.hpp"

namespace foothold::geometry {

// Depth (m) by which a way may leave the polygon: what is outside by less counts as on the boundary, and ways may run along it.
inline constexpr double kOnBoundary = 1e-9;

// Immutable; any thread. Building takes (reflex vertices)^2 * vertices, a query reflex vertices * vertices.
class PolygonPaths {
 public:
  // `outline` simple and counter-clockwise; `holes` simple and clockwise, inside the outline, none touching another. All edges
  // longer than 1e-6 m.
  explicit PolygonPaths(const Polygon& outline, const std::vector<Polygon>& holes = {});

  // m; infinite if an end is outside. Exact but for rounding and kOnBoundary.
  double length(const Vector2d& from, const Vector2d& to) const;
  // From `from` to `to`, both included, with the vertices where the way bends; empty if an end is outside.
  std::vector<Vector2d> path(const Vector2d& from, const Vector2d& to) const;

  bool holds(const Vector2d& point) const;  // inside or on the boundary
  // The straight way stays in the polygon. Precondition: it holds `from`.
  bool sees(const Vector2d& from, const Vector2d& to) const;
  // `point` itself if it is inside, else the nearest point of the boundary.
  Vector2d nearest(const Vector2d& point) const;
  std::size_t reflex_vertices() const { return reflex_.size(); }

 private:
  // An edge and the vertex that it begins at; the polygon lies on the side of its normal.
  struct Edge {
    Vector2d at, normal;
    double offset;      // normal . at
    int before, after;  // the edges that end and begin at its ends
    bool reflex;        // its vertex
    double side(const Vector2d& point) const { return normal.dot(point) - offset; }
  };
  struct Link {
    double length;
    int next;  // the reflex vertex after this one on the way; the other end itself if they see each other
  };
  struct Bends {
    int first = -1, last = -1;  // reflex vertices by index; -1: straight
    double length = 0.0;
  };

  void add(const Polygon& ring);
  bool tangent(const Vector2d& from, const Edge& corner) const;
  Bends shortest(const Vector2d& from, const Vector2d& to) const;
  const Link& link(int a, int b) const {
    return links_[static_cast<std::size_t>(a) * reflex_.size() + static_cast<std::size_t>(b)];
  }
  const Edge& edge(int index) const { return edges_[static_cast<std::size_t>(index)]; }
  const Edge& reflex(int index) const { return edge(reflex_[static_cast<std::size_t>(index)]); }

  std::vector<Edge> edges_;
  std::vector<int> reflex_;  // edges whose vertex is reflex
  std::vector<Link> links_;  // reflex x reflex: the shortest ways between them
};

}  // namespace foothold::geometry
