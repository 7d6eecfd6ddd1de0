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
  const truss::Face* face = nullptr;
  std::vector<Vector3d> outline;  // in the world
  Vector3d normal;
  Eigen::AlignedBox3d bounds;
};
SeenFace seen(const truss::Face& face);

// A line on one face along which soles may stand, at one distance from the meeting line.
struct SoleLine {
  Vector2d origin, along;          // in the face's frame; origin at t = 0
  double heading = 0.0;            // rad, towards the meeting line
  std::vector<Stretch> stretches;  // of t
};

struct FacePair {
  std::array<const SeenFace*, 2> faces;
  Vector3d at, l;  // a point of the meeting line and its direction
  std::array<Vector3d, 2> u;
};
// Empty if the planes are parallel (1e-3 rad).
std::optional<FacePair> meet(const SeenFace& a, const SeenFace& b);

// The edge that they share and both fall away from: stretches of t along l. Empty if there is none.
std::vector<Stretch> convex_edge(const FacePair& pair);
// Face k (0, 1) reaches into the front of the other far enough for a plate at `distance`.
bool concave_room(const FacePair& pair, std::size_t k, double distance, double half_plate);
// Soles on face k at `distance` (m) from the line, in front of the other face (`front`) or behind it.
SoleLine sole_line(const Model& model, const FacePair& pair, std::size_t k, double distance, bool front);
// The parts of `own` that are within `apart` (m) of `others`.
std::vector<Stretch> near_to(const std::vector<Stretch>& own, const std::vector<Stretch>& others, double apart);

}  // namespace foothold::hyrecro
