// The trainer: its gradient, that it learns, that it is deterministic.
#include <gtest/gtest.h>

#include <cmath>

#include "fixtures.hpp"
#include "hyrecro/tools/trainer.hpp"

namespace foothold::hyrecro {
namespace {

double reference_loss(const std::vector<double>& w, std::span<const Sample> samples) {
  double loss = 0.0;
  for (const Sample& sample : samples) {
    const double z = reference_logit(w, sample.inputs);
    loss += std::log1p(std::exp(sample.reachable > 0.5F ? -z : z));
  }
  return loss;
}

// Reachable within a sphere that is dented on one side.
std::vector<Sample> dented_sphere(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<float> uniform(-2.0F, 2.0F);
  std::vector<Sample> out(count);
  for (Sample& sample : out) {
    for (float& value : sample.inputs) value = 3.0F + 0.1F * uniform(random);
    const auto from = [&](std::size_t i, float centre) { return (sample.inputs[i] - 3.0F) * 10.0F - centre; };
    const float ball = std::hypot(from(0, 0.0F), from(1, 0.0F), from(2, 0.0F)), dent = std::hypot(from(0, 2.0F), from(1, 0.0F));
    sample.reachable = ball < 1.8F && dent > 1.0F ? 1.0F : 0.0F;
  }
  return out;
}

TEST(Trainer, GradientIsThatOfFiniteDifferencesInDouble) {
  const Perceptron net = noisy_perceptron(3, 0.3F);
  std::mt19937_64 random(4);
  std::vector<Sample> samples(16);
  for (Sample& sample : samples) sample = {noisy_inputs(random), (random() & 1U) != 0U ? 1.0F : 0.0F};
  Perceptron gradient;
  const double loss = add_gradient(net, samples, gradient);
  std::vector<double> w = doubles(net);
  EXPECT_NEAR(loss, reference_loss(w, samples), 1e-4 * loss);
  for (std::size_t i = 0; i < Perceptron::kCount; ++i) {
    constexpr double kStep = 1e-6;
    const double middle = w[i];
    w[i] = middle + kStep;
    const double above = reference_loss(w, samples);
    w[i] = middle - kStep;
    const double below = reference_loss(w, samples);
    w[i] = middle;
    const double expected = (above - below) / (2.0 * kStep);
    ASSERT_NEAR(gradient.values[i], expected, 1e-4 * (1.0 + std::fabs(expected))) << "parameter " << i;
  }
}

TEST(Trainer, LearnsARegionOfSpace) {
  const std::vector<Sample> samples = dented_sphere(40000, 1), fresh = dented_sphere(5000, 2);
  TrainingOptions options;
  options.epochs = 15;
  options.batch = 64;
  double last = 1.0;
  const Perceptron net = train(samples, options, [&](int, double loss) { last = loss; });
  const Accuracy learned = accuracy(net, fresh), before = accuracy(random_perceptron(1), fresh);
  EXPECT_GT(learned.share(), 0.97);
  EXPECT_LT(before.share(), 0.90);
  EXPECT_LT(last, 0.1);
  EXPECT_GT(learned.reachable, fresh.size() / 10);
  EXPECT_LT(learned.reachable, fresh.size() - fresh.size() / 10);
}

TEST(Trainer, GivesTheSameWeightsForTheSameSeed) {
  const std::vector<Sample> samples = dented_sphere(3001, 1);
  TrainingOptions options;
  options.epochs = 2;
  int told = 0;
  const Perceptron one = train(samples, options, [&](int, double) { ++told; }), two = train(samples, options, [](int, double) {});
  EXPECT_EQ(one.values, two.values);
  EXPECT_EQ(told, 2);
  options.seed = 2;
  EXPECT_NE(train(samples, options, [](int, double) {}).values, one.values);
}

}  // namespace
}  // namespace foothold::hyrecro
