// Where along a straight line a plate lies fully on a face: in closed form, for any outline with holes.
#pragma once

#include <vector>

#include "hyrecro/scene/face_edges.hpp"

namespace foothold::hyrecro {

struct Stretch {
  double begin = 0.0, end = 0.0;  // m, along the line; equal where the plate just fits
};

// A rectangle that slides along a line: from `low` to `high` (m) across it, to the left seen along it, and `half` to either side of
// its middle along it.
struct Slider {
  geometry::Vector2d origin = geometry::Vector2d::Zero();
  geometry::Vector2d along = geometry::Vector2d::UnitX();  // unit
  double low = 0.0, high = 0.0, half = 0.0;
};

// Middles within `window` for which the whole rectangle lies on the face, edges included (1e-9 m), in order. Any thread.
std::vector<Stretch> free_stretches(const FaceEdges& edges, const Slider& slider, const Stretch& window);

}  // namespace foothold::hyrecro
