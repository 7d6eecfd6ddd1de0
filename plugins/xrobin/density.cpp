// Recursion over the cycles, cell by cell.
#include "density.hpp"

#include <algorithm>
#include <limits>

namespace foothold::xrobin {

void DensityGrid::make_ranks() {
  std::vector<double> values(words_);
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  if (values.front() > 0.0) values.insert(values.begin(), 0.0);
  // More densities than ranks (fine grids only): the lowest share rank 1, since the greatest decide.
  const std::size_t most = std::numeric_limits<std::uint16_t>::max();
  const std::size_t shift = values.size() > most + 1 ? values.size() - 1 - most : 0;
  ranks_.resize(words_.size());
  std::transform(words_.begin(), words_.end(), ranks_.begin(), [&](double words) {
    const auto place = static_cast<std::size_t>(std::lower_bound(values.begin(), values.end(), words) - values.begin());
    return static_cast<std::uint16_t>(place == 0 ? 0 : place <= shift ? 1 : place - shift);
  });
}

std::vector<DensityGrid> density_grids(const std::vector<Module>& modules, int most_cycles, int cells, double half_width) {
  std::vector<DensityGrid> grids;
  for (int n = 1; n <= most_cycles; ++n) {
    DensityGrid grid(cells, half_width);
    grid.words_.assign(static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells), 0.0);
    const auto add = [&](double x, double y, double words) {
      const std::ptrdiff_t cell = grid.cell(x, y);
      if (cell >= 0) grid.words_[static_cast<std::size_t>(cell)] += words;
    };
    if (n == 1) {
      for (const Module& m : modules) add(m.end.x, m.end.y, static_cast<double>(m.pairs.size()));
    } else {
      const DensityGrid& rest = grids.back();
      for (const Module& m : modules)
        for (int row = 0; row < cells; ++row)
          for (int column = 0; column < cells; ++column) {
            const double words =
                rest.words_[static_cast<std::size_t>(row) * static_cast<std::size_t>(cells) + static_cast<std::size_t>(column)];
            if (words == 0.0) continue;
            const double x = rest.centre(column);
            const double y = rest.centre(row);
            add(m.end.x + m.cosine * x - m.sine * y, m.end.y + m.sine * x + m.cosine * y,
                static_cast<double>(m.pairs.size()) * words);
          }
    }
    grid.make_ranks();
    grids.push_back(std::move(grid));
  }
  return grids;
}

}  // namespace foothold::xrobin
