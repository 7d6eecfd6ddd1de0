// The paper's inverse kinematics (section 3.1, after Ebert-Uphoff and Chirikjian 1996): the cycles are fixed one after the other,
// each so that the goal lies in the cell of greatest density of the cycles that remain; among equal densities the cycle that ends
// nearest to the goal.
#pragma once

#include <functional>

#include "density.hpp"

namespace foothold::xrobin {

class Greedy {
 public:
  // `cells` along a side of each grid; the grids cover what all cycles together can reach.
  Greedy(const Mechanism& mechanism, int cycles, int cells);
  int cycles() const { return static_cast<int>(grids_.size()) + 1; }
  const std::vector<DensityGrid>& grids() const { return grids_; }
  int cells() const { return cells_; }
  // Which second configurations can follow which first one (index first - 1; bit second - 1) from where body A is, in the frame of
  // its start, after a cycle that ended in configuration `before` (0: none yet).
  using Possible = std::array<std::uint8_t, kConfigurations>;
  using Filter = std::function<Possible(const PlanarPose& a, int before)>;

  // The word of `cycles` cycles, at most cycles(), towards (x, y), in m in the frame of body A before the first of them.
  Word word(double x, double y, int cycles) const;
  // The same among the cycles that are possible. Staying must always be.
  Word word(double x, double y, int cycles, const Filter& filter) const;

 private:
  template <class Choose>
  Word fix_cycles(double x, double y, int cycles, Choose choose) const;

  Mechanism mechanism_;
  int cells_;
  std::vector<Module> modules_;
  std::vector<DensityGrid> grids_;
};

// The least number of cycles at the begin of `word` after which body A is as near to (x, y) as it ever comes, or the first that
// ends within `tolerance`: what follows only folds the arm up.
std::size_t cycles_to_keep(const Mechanism& mechanism, const Word& word, double x, double y, double tolerance);

}  // namespace foothold::xrobin
