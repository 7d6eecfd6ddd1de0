// Backpropagation through the perceptron, compiled twice: with AVX2 and without.
#include <cmath>

#include "hyrecro/tools/trainer.hpp"

namespace foothold::hyrecro {
namespace {

using P = Perceptron;
using Lanes [[gnu::vector_size(sizeof(float) * P::kLanes), gnu::aligned(4), gnu::may_alias]] = float;

constexpr std::size_t kVectors1 = P::kFirst / P::kLanes, kVectors2 = P::kSecond / P::kLanes;

[[gnu::always_inline]] inline double one(const float* w, const Sample& sample, float* g) {
  const auto at = [](const float* p, std::size_t k) -> const Lanes& { return *reinterpret_cast<const Lanes*>(p + P::kLanes * k); };
  const auto to = [](float* p, std::size_t k) -> Lanes& { return *reinterpret_cast<Lanes*>(p + P::kLanes * k); };

  Lanes first[kVectors1], second[kVectors2];
  for (std::size_t k = 0; k < kVectors1; ++k) first[k] = at(w + P::kBias1, k);
  for (std::size_t i = 0; i < P::kInputs; ++i)
    for (std::size_t k = 0; k < kVectors1; ++k) first[k] += sample.inputs[i] * at(w + P::kWeights1 + P::kFirst * i, k);
  alignas(32) float hidden[P::kFirst];
  for (std::size_t k = 0; k < kVectors1; ++k) to(hidden, k) = first[k];
  for (std::size_t k = 0; k < kVectors2; ++k) second[k] = at(w + P::kBias2, k);
  for (std::size_t i = 0; i < P::kFirst; ++i)
    if (hidden[i] > 0.0F)
      for (std::size_t k = 0; k < kVectors2; ++k) second[k] += hidden[i] * at(w + P::kWeights2 + P::kSecond * i, k);
  Lanes sum{};
  for (std::size_t k = 0; k < kVectors2; ++k) {
    second[k] = second[k] > 0.0F ? second[k] : Lanes{};
    sum += second[k] * at(w + P::kWeights3, k);
  }
  float z = w[P::kBias3];
  for (std::size_t k = 0; k < P::kLanes; ++k) z += sum[k];

  // loss = log(1 + exp(z)) - reachable z, of which the derivative is sigmoid(z) - reachable.
  const float small = std::exp(-std::fabs(z));
  const double loss = std::fmax(z, 0.0F) - z * sample.reachable + std::log1p(small);
  const float error = (z >= 0.0F ? 1.0F / (1.0F + small) : small / (1.0F + small)) - sample.reachable;

  g[P::kBias3] += error;
  Lanes back2[kVectors2];
  for (std::size_t k = 0; k < kVectors2; ++k) {
    to(g + P::kWeights3, k) += error * second[k];
    back2[k] = second[k] > 0.0F ? error * at(w + P::kWeights3, k) : Lanes{};
    to(g + P::kBias2, k) += back2[k];
  }
  alignas(32) float back1[P::kFirst] = {};
  for (std::size_t i = 0; i < P::kFirst; ++i)
    if (hidden[i] > 0.0F) {
      Lanes product{};
      for (std::size_t k = 0; k < kVectors2; ++k) {
        to(g + P::kWeights2 + P::kSecond * i, k) += hidden[i] * back2[k];
        product += back2[k] * at(w + P::kWeights2 + P::kSecond * i, k);
      }
      back1[i] = ((product[0] + product[4]) + (product[2] + product[6])) + ((product[1] + product[5]) + (product[3] + product[7]));
    }
  for (std::size_t k = 0; k < kVectors1; ++k) to(g + P::kBias1, k) += at(back1, k);
  for (std::size_t i = 0; i < P::kInputs; ++i)
    for (std::size_t k = 0; k < kVectors1; ++k) to(g + P::kWeights1 + P::kFirst * i, k) += sample.inputs[i] * at(back1, k);
  return loss;
}

[[gnu::always_inline]] inline double all(const float* w, std::span<const Sample> samples, float* g) {
  double loss = 0.0;
  for (const Sample& sample : samples) loss += one(w, sample, g);
  return loss;
}

double all_plain(const float* w, std::span<const Sample> samples, float* g) { return all(w, samples, g); }
#if defined(__x86_64__)
[[gnu::target("avx2")]] double all_avx2(const float* w, std::span<const Sample> samples, float* g) { return all(w, samples, g); }
const bool kAvx2 = (__builtin_cpu_init(), __builtin_cpu_supports("avx2") != 0);
#endif

}  // namespace

double add_gradient(const Perceptron& net, std::span<const Sample> samples, Perceptron& gradient) {
#if defined(__x86_64__)
  if (kAvx2) return all_avx2(net.values.data(), samples, gradient.values.data());
#endif
  return all_plain(net.values.data(), samples, gradient.values.data());
}

}  // namespace foothold::hyrecro
