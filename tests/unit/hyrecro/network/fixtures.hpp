// What the tests of the reachability networks share: the repository's robot and the perceptron as plain loops in double.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <random>
#include <vector>

#include "foothold/robot_file.hpp"
#include "hyrecro/model/chain.hpp"
#include "hyrecro/reach/poses.hpp"

namespace foothold::hyrecro {

inline Model model() { return Model::from_model(load_robot_model(FOOTHOLD_CONFIG_DIR "/robots/hyrecro.yaml")); }

// Full counts when asked for: minutes instead of seconds.
inline bool long_run() {
  const char* word = std::getenv("FOOTHOLD_LONG");
  return word != nullptr && *word == '1';
}

// As the figure in the paper draws it.
inline double reference_logit(const std::vector<double>& w, const NetworkInputs& inputs) {
  using P = Perceptron;
  std::vector<double> first(P::kFirst), second(P::kSecond);
  for (std::size_t j = 0; j < P::kFirst; ++j) {
    double sum = w[P::kBias1 + j];
    for (std::size_t i = 0; i < P::kInputs; ++i) sum += inputs[i] * w[P::kWeights1 + P::kFirst * i + j];
    first[j] = std::max(0.0, sum);
  }
  for (std::size_t j = 0; j < P::kSecond; ++j) {
    double sum = w[P::kBias2 + j];
    for (std::size_t i = 0; i < P::kFirst; ++i) sum += first[i] * w[P::kWeights2 + P::kSecond * i + j];
    second[j] = std::max(0.0, sum);
  }
  double out = w[P::kBias3];
  for (std::size_t j = 0; j < P::kSecond; ++j) out += second[j] * w[P::kWeights3 + j];
  return out;
}

inline std::vector<double> doubles(const Perceptron& net) { return {net.values.begin(), net.values.begin() + Perceptron::kCount}; }

// Every parameter random, biases too.
inline Perceptron noisy_perceptron(std::uint64_t seed, float size) {
  std::mt19937_64 random(seed);
  std::normal_distribution<float> normal(0.0F, size);
  Perceptron net;
  for (std::size_t i = 0; i < Perceptron::kCount; ++i) net.values[i] = normal(random);
  return net;
}

inline NetworkInputs noisy_inputs(std::mt19937_64& random) {
  std::normal_distribution<float> normal;
  NetworkInputs out;
  for (float& value : out) value = normal(random);
  return out;
}

}  // namespace foothold::hyrecro
