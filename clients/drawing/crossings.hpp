// Where a body of the robot reaches into the scene at a stance. Judged in the world, apart from how it is seen, so that a robot
// that stands through a beam is marked in both views whatever hides it.
#pragma once

#include <string>
#include <vector>

#include "plan.hpp"

namespace foothold::drawing {

struct Crossing {
  std::uint32_t step = 0;
  std::string body;   // the robot's
  std::string piece;  // the scene's
  Points region;      // in the world: where the one cuts the other; a segment or a point where that has no area
};

// A body may stand on the scene with its own contacts: the part of its cut that is near such a contact is left out. To let touching
// pass, bodies are taken smaller than they are: boxes by a thousandth of their shortest edge on each side, round ones by 4 % of
// their radius (within the error of the polyhedron that stands for them here). Polygons in one plane count as crossing where they
// overlap, unless a contact of the plan names the scene's polygon as its face.
std::vector<Crossing> crossings(const Plan& plan);

}  // namespace foothold::drawing
