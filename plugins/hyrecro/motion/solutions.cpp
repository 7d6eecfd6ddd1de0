#include "hyrecro/motion/solutions.hpp"

#include <cmath>

#include "hyrecro/reach/inverse.hpp"

namespace foothold::hyrecro {
std::vector<Coordinates> solutions(const Model& model, const Isometry3d& pose, const SolutionGrid& grid, const Coordinates* near) {
  const double greatest = model.mechanism.greatest_phi();
  const double shortest = 2.0 * model.mechanism.shortest() - model.core, longest = 2.0 * model.mechanism.longest() - model.core;
  const bool any_psi1 = singular(pose);
  std::vector<Coordinates> out;
  const auto scan = [&](const Branch& branch, double psi1) {
    constexpr double kRounding = 1e-9;
    const int angles = static_cast<int>(greatest / grid.phi1), lengths = static_cast<int>((longest - shortest) / grid.lambda);
    for (int i = -angles; i <= angles; ++i) {
      const double phi1 = i * grid.phi1;
      double low = shortest, high = longest;
      if (any_psi1) {  // what psi1 leaves lambda, before all the rest is computed
        const kinematics::Interval one = model.mechanism.offsets(phi1), two = model.mechanism.offsets(psi1 - phi1);
        if (one.empty() || two.empty()) continue;
        low = one.low + two.low - model.core - kRounding;
        high = one.high + two.high - model.core + kRounding;
      }
      for (int j = 0; j <= lengths; ++j) {
        const double lambda = shortest + j * grid.lambda;
        if (lambda < low || lambda > high) continue;
        if (const auto c = inverse(model, pose, branch, {phi1, lambda, 0.5, 0.5, psi1})) out.push_back(*c);
      }
    }
  };
  const Branch given = near ? branch_of(*near) : Branch{};
  for (const int s2 : {1, -1}) {
    if (near && s2 != given.s2) continue;
    if (any_psi1) {  // the sign s1 means nothing there
      const double middle = near ? near->leg[1].psi() : 0.0;
      const int tilts = near ? 4 : static_cast<int>(2.0 * greatest / grid.psi1);
      for (int k = -tilts; k <= tilts; ++k) scan({1, s2}, middle + k * grid.psi1);
      continue;
    }
    for (const int s1 : {1, -1})
      if (!near || s1 == given.s1) scan({s1, s2}, 0.0);
  }
  return out;
}

}  // namespace foothold::hyrecro
