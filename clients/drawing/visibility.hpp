// What the scene hides of the robot and of lines: exact on the screen, not by pixels.
#pragma once

#include <utility>
#include <vector>

#include "screen_grid.hpp"
#include "solids.hpp"

namespace foothold::drawing {

// A region of the screen: outer borders counter-clockwise and holes clockwise; to be filled by the non-zero rule. Depths are 0.
using Region = std::vector<Points>;

// The union of convex polygons.
Region unite(const std::vector<Points>& polygons);

struct SplitRegion {
  Region visible;
  Region hidden;
  bool untouched = false;  // nothing is hidden: `visible` is the polygon itself
};

// The scene's faces as things that hide others.
class Occluders {
 public:
  explicit Occluders(std::vector<SeenFace> faces);

  // Is the point behind a face by more than kSameDepth?
  bool hides(const Vector3d& point) const;
  // The stretches of the segment that are hidden, as parameters from 0 at `a` to 1 at `b`, apart and rising.
  std::vector<std::pair<double, double>> hidden(const Vector3d& a, const Vector3d& b) const;
  // A flat convex polygon in its visible and its hidden part.
  SplitRegion split(const Points& polygon) const;

 private:
  std::vector<SeenFace> faces_;
  std::vector<DepthPlane> planes_;
  ScreenGrid grid_;
};

}  // namespace foothold::drawing
