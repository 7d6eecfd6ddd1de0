// Painter's order of opaque faces: each is drawn after all that it hides.
#pragma once

#include "solids.hpp"

namespace foothold::drawing {

// Depths that differ by less count as equal: what rests on a face neither hides it nor is hidden. px
inline constexpr double kSameDepth = 0.05;

// From the farthest to the nearest. Two faces are compared where they overlap on the screen, not by one depth for each; faces that
// pass through each other are cut along their meeting line, and one face of a ring (A before B before C before A) is cut between
// its two neighbours (after Newell, Newell and Sancha, 1972). Coinciding faces keep their order. Same input, same order.
std::vector<SeenFace> painters_order(std::vector<SeenFace> faces);

}  // namespace foothold::drawing
