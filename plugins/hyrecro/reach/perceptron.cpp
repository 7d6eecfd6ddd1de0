// Inference, with AVX2 where the CPU has it.
#include "hyrecro/reach/perceptron.hpp"

#include <algorithm>
#include <cmath>

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace foothold::hyrecro {
namespace {

using P = Perceptron;

// The order in which eight partial sums are added, in both forms.
float total(const std::array<float, P::kLanes>& s) { return ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7])); }

#if defined(__x86_64__)
[[gnu::target("avx2,fma")]] float logit_avx2(const Perceptron& net, const NetworkInputs& inputs) {
  const float* const values = net.values.data();
  const __m256 zero = _mm256_setzero_ps();
  __m256 first[P::kFirst / P::kLanes];
  for (std::size_t k = 0; k < P::kFirst / P::kLanes; ++k) first[k] = _mm256_load_ps(values + P::kBias1 + P::kLanes * k);
  for (std::size_t i = 0; i < P::kInputs; ++i) {
    if (inputs[i] == 0.0F) continue;
    const __m256 input = _mm256_set1_ps(inputs[i]);
    const float* const weights = values + P::kWeights1 + P::kFirst * i;
    for (std::size_t k = 0; k < P::kFirst / P::kLanes; ++k)
      first[k] = _mm256_fmadd_ps(input, _mm256_load_ps(weights + P::kLanes * k), first[k]);
  }
  alignas(32) float hidden[P::kFirst];
  unsigned active = 0;
  for (std::size_t k = 0; k < P::kFirst / P::kLanes; ++k) {
    _mm256_store_ps(hidden + P::kLanes * k, first[k]);
    const int mask = _mm256_movemask_ps(_mm256_cmp_ps(first[k], zero, _CMP_GT_OQ));
    active |= static_cast<unsigned>(mask) << (P::kLanes * k);
  }
  __m256 second[P::kSecond / P::kLanes];
  for (std::size_t k = 0; k < P::kSecond / P::kLanes; ++k) second[k] = _mm256_load_ps(values + P::kBias2 + P::kLanes * k);
  for (; active != 0; active &= active - 1) {
    const auto i = static_cast<std::size_t>(__builtin_ctz(active));
    const __m256 input = _mm256_set1_ps(hidden[i]);
    const float* const weights = values + P::kWeights2 + P::kSecond * i;
    for (std::size_t k = 0; k < P::kSecond / P::kLanes; ++k)
      second[k] = _mm256_fmadd_ps(input, _mm256_load_ps(weights + P::kLanes * k), second[k]);
  }
  __m256 even = zero, odd = zero;
  const float* const weights3 = values + P::kWeights3;
  for (std::size_t k = 0; k < P::kSecond / P::kLanes; k += 2) {
    even = _mm256_fmadd_ps(_mm256_max_ps(second[k], zero), _mm256_load_ps(weights3 + P::kLanes * k), even);
    odd = _mm256_fmadd_ps(_mm256_max_ps(second[k + 1], zero), _mm256_load_ps(weights3 + P::kLanes * (k + 1)), odd);
  }
  std::array<float, P::kLanes> lanes;
  _mm256_storeu_ps(lanes.data(), _mm256_add_ps(even, odd));
  return values[P::kBias3] + total(lanes);
}
#endif

using Logit = float (*)(const Perceptron&, const NetworkInputs&);

Logit fastest() {
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return logit_avx2;
#endif
  return logit_plain;
}

const Logit kLogit = fastest();

}  // namespace

float logit(const Perceptron& net, const NetworkInputs& inputs) { return kLogit(net, inputs); }

float logit_plain(const Perceptron& net, const NetworkInputs& inputs) {
  const float* const values = net.values.data();
  std::array<float, P::kFirst> first;
  for (std::size_t j = 0; j < P::kFirst; ++j) first[j] = values[P::kBias1 + j];
  for (std::size_t i = 0; i < P::kInputs; ++i)
    for (std::size_t j = 0; j < P::kFirst; ++j) first[j] = std::fma(inputs[i], values[P::kWeights1 + P::kFirst * i + j], first[j]);
  std::array<float, P::kSecond> second;
  for (std::size_t j = 0; j < P::kSecond; ++j) second[j] = values[P::kBias2 + j];
  for (std::size_t i = 0; i < P::kFirst; ++i)
    if (first[i] > 0.0F)
      for (std::size_t j = 0; j < P::kSecond; ++j)
        second[j] = std::fma(first[i], values[P::kWeights2 + P::kSecond * i + j], second[j]);
  std::array<std::array<float, P::kLanes>, 2> sums{};
  for (std::size_t j = 0; j < P::kSecond; ++j) {
    float& sum = sums[j / P::kLanes % 2][j % P::kLanes];
    sum = std::fma(std::max(second[j], 0.0F), values[P::kWeights3 + j], sum);
  }
  for (std::size_t k = 0; k < P::kLanes; ++k) sums[0][k] += sums[1][k];
  return values[P::kBias3] + total(sums[0]);
}

}  // namespace foothold::hyrecro
