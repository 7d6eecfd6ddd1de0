// Density grids and the paper's inverse kinematics.
#include <gtest/gtest.h>

#include <map>

#include "brute_force.hpp"
#include "fixtures.hpp"
#include "greedy.hpp"

namespace foothold::xrobin {
namespace {

double total(const DensityGrid& grid) {
  double sum = 0.0;
  for (int k = 0; k < grid.cells() * grid.cells(); ++k) sum += grid.words(static_cast<std::size_t>(k));
  return sum;
}

TEST(DensityGrid, CountsEveryWordOnce) {
  const Mechanism m = mechanism();
  const std::vector<DensityGrid> grids = density_grids(modules(m), 6, 201, 7 * m.longest_cycle());
  double words = 1.0;
  for (const DensityGrid& grid : grids) EXPECT_EQ(total(grid), words *= 64.0);
}

TEST(DensityGrid, HasTheExactCountsForOneCycle) {
  const Mechanism m = mechanism();
  const DensityGrid grid = density_grids(modules(m), 1, 101, 0.12).front();
  std::map<std::ptrdiff_t, double> counted;
  for (const PlanarPose& end : ends_of_all_words(m, 1)) counted[grid.cell(end.x, end.y)] += 1.0;
  for (int k = 0; k < 101 * 101; ++k)
    EXPECT_EQ(grid.words(static_cast<std::size_t>(k)), counted.contains(k) ? counted[k] : 0.0) << k;
}

TEST(DensityGrid, ApproachesTheTrueDensityOfThreeCycles) {
  // The recursion takes points for their cells' centres: counts in blocks far wider than a cell must agree with the enumeration.
  const Mechanism m = mechanism();
  const double half = 4 * m.longest_cycle();
  const DensityGrid grid = density_grids(modules(m), 3, 400, half).back();
  constexpr int kBlocks = 8;
  std::vector<double> exact(kBlocks * kBlocks), counted(kBlocks * kBlocks);
  const auto block = [&](double x, double y) {
    return static_cast<std::size_t>((y + half) / (2 * half) * kBlocks) * kBlocks +
           static_cast<std::size_t>((x + half) / (2 * half) * kBlocks);
  };
  for (const PlanarPose& end : ends_of_all_words(m, 3)) exact[block(end.x + 0.013, end.y + 0.017)] += 1.0;
  for (int row = 0; row < 400; ++row)
    for (int column = 0; column < 400; ++column) {
      // Empty cells at the grid's edge would lie beside the blocks, which are shifted against it.
      const double words = grid.words(static_cast<std::size_t>(row * 400 + column));
      if (words > 0.0) counted[block(grid.centre(column) + 0.013, grid.centre(row) + 0.017)] += words;
    }
  for (std::size_t k = 0; k < exact.size(); ++k) EXPECT_NEAR(counted[k], exact[k], 0.03 * 64 * 64 * 64) << k;
}

TEST(DensityGrid, RanksAreInTheOrderOfTheDensities) {
  const Mechanism m = mechanism();
  for (const int cells : {51, 301}) {
    const DensityGrid grid = density_grids(modules(m), 4, cells, 5 * m.longest_cycle()).back();
    for (std::size_t k = 1; k < static_cast<std::size_t>(cells * cells); ++k) {
      EXPECT_EQ(grid.words(k) == 0.0, grid.rank(k) == 0);
      EXPECT_TRUE(!(grid.words(k) < grid.words(k - 1)) || grid.rank(k) <= grid.rank(k - 1));
      EXPECT_TRUE(grid.words(k) != grid.words(k - 1) || grid.rank(k) == grid.rank(k - 1));
    }
  }
}

TEST(Greedy, ReachesThePapersErrors) {
  const Mechanism m = mechanism();
  const Greedy greedy(m, 7, 201);
  for (const auto& [target, error] : {std::pair{0.4, 1.20e-3}, std::pair{0.2, 0.60e-3}}) {
    const PlanarPose end = forward(m, greedy.word(target, target, 7));
    EXPECT_NEAR(std::hypot(end.x - target, end.y - target), error, 0.01e-3);
  }
  const PlanarPose far = forward(m, greedy.word(1.0, 1.0, 7));
  EXPECT_NEAR(std::hypot(far.x - 1.0, far.y - 1.0), 819.73e-3, 0.01e-3);
}

TEST(Greedy, PrefersTheNearerEndAmongEqualDensities) {
  // Beyond the grids every cell is empty, so each cycle must be the one that ends nearest to the goal.
  const Mechanism m = mechanism();
  const Greedy greedy(m, 3, 51);
  const double x = 9.0, y = 4.0;
  PlanarPose at;
  const Word word = greedy.word(x, y, 3);
  for (std::size_t k = 0; k < word.size(); k += 2) {
    const auto end_of = [&](int a, int b) { return at * m.b_in_a(a) * inverse(m.b_in_a(b)); };
    const PlanarPose chosen = end_of(word[k], word[k + 1]);
    for (int a = 1; a <= 8; ++a)
      for (int b = 1; b <= 8; ++b) {
        const PlanarPose other = end_of(a, b);
        EXPECT_LE(std::hypot(chosen.x - x, chosen.y - y), std::hypot(other.x - x, other.y - y) + 1e-12);
      }
    at = chosen;
  }
}

TEST(Greedy, EarlyStopLeavesOutTheFolding) {
  const Mechanism m = mechanism();
  const Word word = Greedy(m, 7, 201).word(0.2, 0.2, 7);
  const std::size_t keep = cycles_to_keep(m, word, 0.2, 0.2, 0.0);
  EXPECT_LT(keep, 7u);  // the paper's figure 8: the last modules fold one on the other
  const PlanarPose all = forward(m, word);
  const PlanarPose kept = forward(m, std::span(word).first(2 * keep));
  EXPECT_LE(std::hypot(kept.x - 0.2, kept.y - 0.2), std::hypot(all.x - 0.2, all.y - 0.2) + 1e-12);
  EXPECT_LT(cycles_to_keep(m, word, 0.2, 0.2, 0.05), keep);
  EXPECT_EQ(cycles_to_keep(m, word, 0.0, 0.0, 1e-3), 0u);
}

}  // namespace
}  // namespace foothold::xrobin
