// The continuous way on a face (PPIC, section 3.2.1) and where circles cross it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/grid_path.hpp"
#include "hyrecro/paper/paper.hpp"

namespace foothold::hyrecro {

// The part of a face where the sole's centre may be: the paper's "safe" polygon, which may fall into parts. Immutable; any thread.
class SafeGround {
 public:
  SafeGround(const truss::Face& face, double inset);
  bool holds(const Vector2d& point) const;
  // From `from` to `to`, both included; face's frame. An end outside the safe polygon is joined to it by the shortest line. Empty
  // if the face is too narrow for a safe polygon, or if the ends' nearest parts are not the same.
  std::vector<Vector2d> way(const Vector2d& from, const Vector2d& to, FaceWay how) const;
  bool empty() const { return parts_.empty(); }

 private:
  std::vector<geometry::PolygonPaths> parts_;
};

// Where the way leaves the circle for the last time; its end if that lies within the circle; the point nearest to the circle if the
// way never is inside. Precondition: way.size() >= 2.
Vector2d crossing(const std::vector<Vector2d>& way, const Vector2d& centre, double radius);

}  // namespace foothold::hyrecro
