#include "hyrecro/tools/trainer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

namespace foothold::hyrecro {
namespace {

using P = Perceptron;

constexpr std::size_t kBlock = 64;  // samples that stay together
constexpr float kMean = 0.9F, kSquare = 0.999F, kEpsilon = 1e-8F;

// Kingma and Ba 2015.
struct Adam {
  Perceptron mean, square;
  double mean_decay = 1.0, square_decay = 1.0;

  void step(Perceptron& net, const Perceptron& gradient, float rate, float scale) {
    mean_decay *= kMean;
    square_decay *= kSquare;
    const auto step_size = static_cast<float>(rate * std::sqrt(1.0 - square_decay) / (1.0 - mean_decay));
    for (std::size_t i = 0; i < P::kCount; ++i) {
      const float g = scale * gradient.values[i];
      mean.values[i] += (1.0F - kMean) * (g - mean.values[i]);
      square.values[i] += (1.0F - kSquare) * (g * g - square.values[i]);
      net.values[i] -= step_size * mean.values[i] / (std::sqrt(square.values[i]) + kEpsilon);
    }
  }
};

struct Scale {
  std::array<double, P::kInputs> mean{}, deviation{};
};

Scale scale_of(std::span<const Sample> samples) {
  Scale out;
  const double count = static_cast<double>(samples.size());
  for (std::size_t i = 0; i < P::kInputs; ++i) {
    double sum = 0.0, squares = 0.0;
    for (const Sample& s : samples) sum += s.inputs[i];
    out.mean[i] = sum / count;
    for (const Sample& s : samples) squares += (s.inputs[i] - out.mean[i]) * (s.inputs[i] - out.mean[i]);
    const double deviation = std::sqrt(squares / count);
    out.deviation[i] = deviation > 1e-6 ? deviation : 1.0;
  }
  return out;
}

// The net that takes inputs as they are and gives what `scaled` gives for scaled ones.
Perceptron unscaled(const Perceptron& scaled, const Scale& scale) {
  Perceptron net = scaled;
  for (std::size_t j = 0; j < P::kFirst; ++j) {
    double bias = net.values[P::kBias1 + j];
    for (std::size_t i = 0; i < P::kInputs; ++i) {
      float& weight = net.values[P::kWeights1 + P::kFirst * i + j];
      const double per_unit = weight / scale.deviation[i];
      bias -= per_unit * scale.mean[i];
      weight = static_cast<float>(per_unit);
    }
    net.values[P::kBias1 + j] = static_cast<float>(bias);
  }
  return net;
}

}  // namespace

Perceptron random_perceptron(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Perceptron net;
  const auto fill = [&](std::size_t from, std::size_t inputs, std::size_t units) {
    for (std::size_t i = 0; i < inputs * units; ++i)
      net.values[from + i] = static_cast<float>(normal(random) * std::sqrt(2.0 / static_cast<double>(inputs)));
  };
  fill(P::kWeights1, P::kInputs, P::kFirst);
  fill(P::kWeights2, P::kFirst, P::kSecond);
  fill(P::kWeights3, P::kSecond, 1);
  return net;
}

Perceptron train(std::span<const Sample> samples, const TrainingOptions& options, const Progress& progress) {
  const Scale scale = scale_of(samples);
  std::vector<Sample> scaled(samples.begin(), samples.end());
  for (Sample& s : scaled)
    for (std::size_t i = 0; i < P::kInputs; ++i)
      s.inputs[i] = static_cast<float>((s.inputs[i] - scale.mean[i]) / scale.deviation[i]);

  std::mt19937_64 random(options.seed);
  Perceptron net = random_perceptron(options.seed);
  Adam adam;
  std::vector<std::size_t> blocks((scaled.size() + kBlock - 1) / kBlock);
  std::iota(blocks.begin(), blocks.end(), std::size_t{0});
  const double total = static_cast<double>(options.epochs) * static_cast<double>(scaled.size());
  double seen = 0.0;
  for (int epoch = 1; epoch <= options.epochs; ++epoch) {
    std::shuffle(blocks.begin(), blocks.end(), random);
    double loss = 0.0;
    Perceptron gradient;
    std::size_t in_batch = 0;
    for (std::size_t b = 0; b < blocks.size(); ++b) {
      const std::size_t begin = kBlock * blocks[b], end = std::min(begin + kBlock, scaled.size());
      loss += add_gradient(net, std::span(scaled).subspan(begin, end - begin), gradient);
      in_batch += end - begin;
      if (in_batch < options.batch && b + 1 < blocks.size()) continue;
      seen += static_cast<double>(in_batch);
      const double rate = options.rate * 0.5 * (1.0 + std::cos(std::numbers::pi * seen / total));
      adam.step(net, gradient, static_cast<float>(rate), 1.0F / static_cast<float>(in_batch));
      gradient = {};
      in_batch = 0;
    }
    progress(epoch, loss / static_cast<double>(scaled.size()));
  }
  return unscaled(net, scale);
}

}  // namespace foothold::hyrecro
