// How well a perceptron judges poses whose answer is known.
#pragma once

#include <cstddef>
#include <span>

#include "hyrecro/reach/perceptron.hpp"

namespace foothold::hyrecro {

// A pose as inputs, and whether it is reachable.
struct Sample {
  NetworkInputs inputs{};
  float reachable = 0.0F;  // 0 or 1
};

// How a perceptron judges labelled poses.
struct Accuracy {
  std::size_t poses = 0, reachable = 0;  // truly
  std::size_t false_positives = 0;       // said to be reachable, are not
  std::size_t false_negatives = 0;

  double share() const { return 1.0 - static_cast<double>(false_positives + false_negatives) / static_cast<double>(poses); }
};
Accuracy accuracy(const Perceptron& net, std::span<const Sample> samples);

}  // namespace foothold::hyrecro
