// The fully random method (Bioloid paper, section II.D; Figures 6 and 9 to 11): in every iteration each joint turns one way by a
// fixed angle, the other way, or stays, until all have reached their goals.
//
// Taken so: the three choices are equally likely; an iteration that leads to an invalid point is discarded and the joints stay ("se
// descartan"); no joint is held back when it arrives, all have to be at their goals in the same iteration (excluding those that
// have arrived is introduced as a rule of the other method).
#include "bioloid/paper/methods.hpp"

namespace foothold::bioloid::paper {
namespace {

// Three choices for each coordinate from one random word: 3^18 of them are so few beside 2^64 that none is preferred.
Directions choices(int dimension, std::uint64_t word) {
  Directions out(dimension);
  for (int k = 0; k < dimension; ++k, word /= 3) out[k] = static_cast<int>(word % 3) - 1;
  return out;
}

// The path from the words that were followed: eight octets a movement while it is searched, for a million of them.
std::vector<Point> followed(const Space& space, const Point& start, const Point& goal, const std::vector<std::uint64_t>& words) {
  std::vector<Point> out{start};
  out.reserve(words.size() + 1);
  for (const std::uint64_t word : words) out.push_back(advanced(space, out.back(), goal, choices(space.dimension(), word)));
  return out;
}

}  // namespace

Plan random_walk(const Space& space, const Point& start, const Point& goal, const Options& options, std::mt19937_64& random,
                 std::stop_token stop) {
  Plan out;
  Point here = start;
  std::vector<std::uint64_t> words;
  while (here != goal) {
    if (stop.stop_requested()) return out.ending = Ending::kStopped, out;
    if (out.iterations == options.iterations) return out;
    ++out.iterations;
    const std::uint64_t word = random();
    const Directions directions = choices(space.dimension(), word);
    if (directions.isZero()) continue;
    const Point next = advanced(space, here, goal, directions);
    if (!space.moves(here, next)) continue;
    here = next;
    words.push_back(word);
  }
  out.ending = Ending::kReached;
  out.path = followed(space, start, goal, words);
  return out;
}

}  // namespace foothold::bioloid::paper
