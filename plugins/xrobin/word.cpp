// The forward map of a word, half cycle by half cycle.
#include "word.hpp"

#include <stdexcept>

namespace foothold::xrobin {

std::vector<BodyPoses> trace(const Mechanism& mechanism, std::span<const std::uint8_t> word, const PlanarPose& start) {
  std::vector<BodyPoses> poses;
  poses.reserve(word.size());
  BodyPoses now{start, {}};
  for (std::size_t k = 0; k < word.size(); ++k) {
    const PlanarPose b_in_a = mechanism.b_in_a(word[k]);
    if (k % 2 == 0)
      now.b = now.a * b_in_a;
    else
      now.a = now.b * inverse(b_in_a);
    poses.push_back(now);
  }
  return poses;
}

PlanarPose forward(const Mechanism& mechanism, std::span<const std::uint8_t> word, const PlanarPose& start) {
  if (word.size() % 2 != 0) throw std::invalid_argument("a word holds two configurations for each cycle");
  PlanarPose now = start;
  for (std::size_t k = 0; k < word.size(); k += 2) now = now * mechanism.b_in_a(word[k]) * inverse(mechanism.b_in_a(word[k + 1]));
  return now;
}

Word from_paper(std::span<const int> first_halves, std::span<const int> second_halves) {
  if (first_halves.size() != second_halves.size()) throw std::invalid_argument("S1 and S2 must be of the same length");
  Word word;
  for (std::size_t i = 0; i < first_halves.size(); ++i) {
    for (const int number : {first_halves[i], second_halves[i]}) {
      if (number < 1 || number > kConfigurations) throw std::invalid_argument("a configuration is a number from 1 to 8");
      word.push_back(static_cast<std::uint8_t>(number));
    }
  }
  return word;
}

std::vector<int> to_paper(std::span<const std::uint8_t> word) {
  std::vector<int> out;
  for (const std::size_t half : {0u, 1u})
    for (std::size_t k = half; k < word.size(); k += 2) out.push_back(word[k]);
  return out;
}

}  // namespace foothold::xrobin
