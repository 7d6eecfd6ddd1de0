// One module after the other; the goal is carried along in the frame of the module to be fixed.
#include "greedy.hpp"

#include <limits>

namespace foothold::xrobin {

Greedy::Greedy(const Mechanism& mechanism, int most, int cells)
    : mechanism_(mechanism),
      cells_(cells),
      modules_(modules(mechanism)),
      grids_(density_grids(modules_, most - 1, cells, most * mechanism.longest_cycle())) {}

// choose(module, word so far) gives the pair of configurations to take for a module, or none.
template <class Choose>
Word Greedy::fix_cycles(double x, double y, int cycles, Choose choose) const {
  Word word;
  for (int left = cycles - 1; left >= 0; --left) {
    const std::array<std::uint8_t, 2>* best = nullptr;
    int best_rank = -1;
    double best_square = 0.0;
    double next_x = 0.0;
    double next_y = 0.0;
    for (const Module& m : modules_) {
      const double dx = x - m.end.x;
      const double dy = y - m.end.y;
      const double in_x = m.cosine * dx + m.sine * dy;
      const double in_y = m.cosine * dy - m.sine * dx;
      int rank = 0;  // of the last cycle: only the distance counts
      if (left > 0) {
        const DensityGrid& grid = grids_[static_cast<std::size_t>(left - 1)];
        const std::ptrdiff_t cell = grid.cell(in_x, in_y);
        if (cell >= 0) rank = grid.rank(static_cast<std::size_t>(cell));
      }
      if (rank < best_rank) continue;
      const double square = dx * dx + dy * dy;
      if (rank == best_rank && square >= best_square) continue;
      const std::array<std::uint8_t, 2>* pair = choose(m, word);
      if (pair == nullptr) continue;
      best = pair, best_rank = rank, best_square = square, next_x = in_x, next_y = in_y;
    }
    word.push_back((*best)[0]);
    word.push_back((*best)[1]);
    x = next_x, y = next_y;
  }
  return word;
}

Word Greedy::word(double x, double y, int cycles) const {
  return fix_cycles(x, y, cycles, [](const Module& m, const Word&) { return &m.pairs.front(); });
}

Word Greedy::word(double x, double y, int cycles, const Filter& filter) const {
  Possible possible{};
  PlanarPose a;
  std::size_t asked_at = 1;  // the length of the word for which `possible` holds; no word is of odd length here
  return fix_cycles(x, y, cycles, [&](const Module& m, const Word& word) -> const std::array<std::uint8_t, 2>* {
    if (word.size() != asked_at) {
      if (!word.empty()) a = a * mechanism_.b_in_a(word[word.size() - 2]) * inverse(mechanism_.b_in_a(word.back()));
      possible = filter(a, word.empty() ? 0 : word.back());
      asked_at = word.size();
    }
    for (const auto& pair : m.pairs)
      if ((possible[pair[0] - 1u] >> (pair[1] - 1u) & 1u) != 0) return &pair;
    return nullptr;
  });
}

std::size_t cycles_to_keep(const Mechanism& mechanism, const Word& word, double x, double y, double tolerance) {
  std::size_t keep = 0;
  double nearest = std::hypot(x, y);
  PlanarPose a;
  for (std::size_t k = 0; k < word.size() && nearest > tolerance; k += 2) {
    a = a * mechanism.b_in_a(word[k]) * inverse(mechanism.b_in_a(word[k + 1]));
    const double away = std::hypot(a.x - x, a.y - y);
    // Rounding must not make a folding word look like progress.
    if (away < nearest - 1e-12) nearest = away, keep = k / 2 + 1;
  }
  return keep;
}

}  // namespace foothold::xrobin
