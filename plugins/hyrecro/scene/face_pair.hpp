// Two faces whose planes meet: the line in which they do, and the stretches along it where a sole may stand on either for a
// transition. Symbols: l the line's direction, u_k the direction in face k's plane away from the line into the front of the other.
#pragma once

#include <array>
#include <optional>

#include "hyrecro/scene/strip.hpp"
#include "hyrecro/scene/transitions.hpp"

namespace foothold::hyrecro {

// A face with what the sampling asks of it over and over.
struct SeenFace {
  explicit SeenFace(const truss::Face& of);

  const truss::Face* face;
  FaceEdges edges;
  std::array<Vector3d, 4> corner;  // of the outline's bounding rectangle in the face's frame, world
  Vector3d normal;
  Eigen::AlignedBox3d bounds;
};

struct FacePair {
  std::array<const SeenFace*, 2> faces;
  Vector3d at, l;  // a point of the meeting line and its direction
  std::array<Vector3d, 2> u;
  std::array<Stretch, 2> along;              // what of t each face's rectangle takes up
  std::array<std::array<double, 2>, 2> off;  // what of the distance along u_k from the line: least and most
};
// Empty if the planes are parallel (1e-3 rad) or the faces are apart by more than `apart` (m) along the line.
std::optional<FacePair> meet(const SeenFace& a, const SeenFace& b, double apart);

// The edge that they share and both fall away from: stretches of t along l, in order. Empty if there is none.
std::vector<Stretch> convex_edge(const FacePair& pair);

// A line on one face along which soles may stand, at one distance from the meeting line.
struct SoleLine {
  Vector2d origin, along;          // in the face's frame; origin at t = 0
  double heading = 0.0;            // rad, towards the meeting line
  std::vector<Stretch> stretches;  // of t, within the window asked for
};
// Soles on face k (0, 1) at `distance` (m) from the line, in front of the other face (`front`) or behind it.
SoleLine sole_line(const Model& model, const FacePair& pair, std::size_t k, double distance, bool front, const Stretch& window);

// The parts of `own` that are within `apart` (m) of `others`; both in order.
std::vector<Stretch> near_to(const std::vector<Stretch>& own, const std::vector<Stretch>& others, double apart);

}  // namespace foothold::hyrecro
