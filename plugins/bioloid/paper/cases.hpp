// The paper's demonstrations (section III, Figures 6, 9, 10 and 12): a point in the plane and in space that goes round an obstacle,
// three joints within 25 degrees. Values; any thread.
#pragma once

#include "bioloid/paper/space.hpp"

namespace foothold::bioloid::paper {

struct Case {
  Space space;
  Point start, goal;
};

// From (7, 17) to (5, 2), bounds 0..10 and 0..20, forbidden X 2..9, Y 3..12 with its border; steps of 1.
Case plane_case();
// "With the same conditions": the obstacle stretched along all Z. Bounds of Z as of X, and Z from 7 to 5 as X does (assumed).
Case space_case();
// Three joints from a common point (0) to three different goals (20, -15 and 10 degrees: assumed), |angle| < 25 degrees; steps
// of 1.
Case joints_case();

}  // namespace foothold::bioloid::paper
