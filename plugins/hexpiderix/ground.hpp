// The ground that Hex-piderix stands on: a terrain, and the plane that a stance sees of it.
#pragma once

#include <optional>

#include "foothold/planner.hpp"
#include "hexpiderix/stance/stance.hpp"
#include "terrain/surface.hpp"

namespace foothold::hexpiderix {

// Immutable; any thread.
class Ground final : public PreparedScene {
 public:
  explicit Ground(terrain::Terrain terrain);
  const terrain::Surface& surface() const { return surface_; }
  std::vector<Shape> shapes() const override;

 private:
  terrain::Terrain terrain_;
  terrain::Surface surface_;
};

// The foot of a leg that reaches down or up along `down` (unit) from `place` (m): where it meets the ground within `reach` (m).
struct Footing {
  Vector3d point, normal;
};
std::optional<Footing> footing(const terrain::Surface& surface, const Vector3d& place, const Vector3d& down, double reach);

// "Whatever the ground is like, three feet make a plane" (paper, section 4.1.1): through three supports, or the plane of least
// squares through more; its normal faces up. Precondition: three supports or more that do not stand in one line.
Plane plane_through(const Footholds& footholds);

}  // namespace foothold::hexpiderix
