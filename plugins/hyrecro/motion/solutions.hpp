// Joint solutions of a pose on a grid of the free variables.
#pragma once

#include <vector>

#include "hyrecro/model/chain.hpp"

namespace foothold::hyrecro {

struct SolutionGrid {
  double phi1 = 0.0, lambda = 0.0, psi1 = 0.0;  // rad, m, rad: steps
};

// Splits stay in the middle. With `near` (a solution of the pose) only those of its branch, and of a singular pose only those with
// psi1 within four steps of its own. Any thread.
std::vector<Coordinates> solutions(const Model& model, const Isometry3d& free_in_holding, const SolutionGrid& grid,
                                   const Coordinates* near);

}  // namespace foothold::hyrecro
