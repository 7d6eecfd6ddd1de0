// Training of a perceptron: binary cross entropy, Adam, minibatches, a learning rate that falls to nothing along half a cosine.
//
// The same data, options and seed give the same weights on the same machine. Values; any thread.
#pragma once

#include <cstdint>
#include <functional>

#include "hyrecro/reach/accuracy.hpp"

namespace foothold::hyrecro {

// He et al. 2015: weights normal with variance 2 / inputs, biases 0. Inputs of mean 0 and variance 1 are assumed.
Perceptron random_perceptron(std::uint64_t seed);

// Adds the gradient of the samples' summed loss to `gradient` and returns that loss.
double add_gradient(const Perceptron& net, std::span<const Sample> samples, Perceptron& gradient);

struct TrainingOptions {
  int epochs = 40;
  std::size_t batch = 256;
  float rate = 2e-3F;  // at the start
  std::uint64_t seed = 1;
};
// Called after every epoch with its number (from 1) and the mean loss over it.
using Progress = std::function<void(int epoch, double loss)>;

// From random weights. Samples come in any order; they are taken in blocks whose order changes with every epoch. Takes inputs in
// their own units: they are brought to mean 0 and variance 1 inside, and the result takes them as they are.
Perceptron train(std::span<const Sample> samples, const TrainingOptions& options, const Progress& progress);

}  // namespace foothold::hyrecro
