// Building the maps, and the scan in a portable and an AVX2 version.
#include "near_map.hpp"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include <bit>

namespace foothold::xrobin {
namespace {

std::size_t scan_portable(const NearMap& map, const float* x, const float* y, std::size_t from, std::size_t count, float dx,
                          float dy, std::uint32_t* out) {
  std::size_t found = 0;
  for (std::size_t k = from; k < count; ++k) {
    out[found] = static_cast<std::uint32_t>(k);
    found += map.at(x[k] + dx, y[k] + dy) ? 1 : 0;
  }
  return found;
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) std::size_t scan_avx2(const NearMap& map, const float* x, const float* y, std::size_t count,
                                                      float dx, float dy, std::uint32_t* out) {
  const __m256 shift_x = _mm256_set1_ps(dx);
  const __m256 shift_y = _mm256_set1_ps(dy);
  const __m256 scale = _mm256_set1_ps(map.per_metre);
  const __m256 offset = _mm256_set1_ps(map.offset);
  const __m256i columns = _mm256_set1_epi32(map.columns);
  const __m256i minus_one = _mm256_set1_epi32(-1);
  const __m256i low_bits = _mm256_set1_epi32(31);
  const int* words = reinterpret_cast<const int*>(map.bits.data());
  std::size_t found = 0;
  std::size_t k = 0;
  for (; k + 8 <= count; k += 8) {
    // Multiplied, then added, as the portable version does.
    const __m256 u = _mm256_add_ps(_mm256_mul_ps(_mm256_add_ps(_mm256_loadu_ps(x + k), shift_x), scale), offset);
    const __m256 v = _mm256_add_ps(_mm256_mul_ps(_mm256_add_ps(_mm256_loadu_ps(y + k), shift_y), scale), offset);
    const __m256i column = _mm256_cvttps_epi32(u);
    const __m256i row = _mm256_cvttps_epi32(v);
    __m256i inside = _mm256_and_si256(_mm256_cmpgt_epi32(column, minus_one), _mm256_cmpgt_epi32(columns, column));
    inside = _mm256_and_si256(inside, _mm256_and_si256(_mm256_cmpgt_epi32(row, minus_one), _mm256_cmpgt_epi32(columns, row)));
    if (_mm256_testz_si256(inside, inside)) continue;
    const __m256i bit = _mm256_add_epi32(_mm256_mullo_epi32(row, columns), column);
    const __m256i word = _mm256_mask_i32gather_epi32(_mm256_setzero_si256(), words, _mm256_srli_epi32(bit, 5), inside, 4);
    const __m256i up = _mm256_sllv_epi32(word, _mm256_sub_epi32(low_bits, _mm256_and_si256(bit, low_bits)));
    auto mask = static_cast<unsigned>(_mm256_movemask_ps(_mm256_castsi256_ps(up)));
    for (; mask != 0; mask &= mask - 1)
      out[found++] = static_cast<std::uint32_t>(k) + static_cast<std::uint32_t>(std::countr_zero(mask));
  }
  return found + scan_portable(map, x, y, k, count, dx, dy, out + found);
}
#endif

}  // namespace

NearMap near_map(std::span<const float> x, std::span<const float> y, double reach, double radius, double hair) {
  const double cell = 2.0 * radius;
  NearMap map;
  const int half = static_cast<int>((reach + radius) / cell) + 2;
  map.radius = static_cast<float>(radius);
  map.per_metre = static_cast<float>(1.0 / cell);
  map.offset = static_cast<float>(half);
  map.columns = 2 * half;
  const auto columns = static_cast<std::size_t>(map.columns);
  map.bits.assign((columns * columns + 31) / 32, 0);
  const float around = static_cast<float>(radius + hair);
  const auto cell_of = [&](float v) { return static_cast<std::size_t>(v * map.per_metre + map.offset); };
  for (std::size_t k = 0; k < x.size(); ++k) {
    const std::size_t left = cell_of(x[k] - around), right = cell_of(x[k] + around);
    for (std::size_t row = cell_of(y[k] - around); row <= cell_of(y[k] + around); ++row)
      for (std::size_t column = left; column <= right; ++column) {
        const std::size_t bit = row * columns + column;
        map.bits[bit / 32] |= 1u << (bit % 32);
      }
  }
  return map;
}

std::size_t near_places(const NearMap& map, const float* x, const float* y, std::size_t count, float dx, float dy,
                        std::uint32_t* out) {
#if defined(__x86_64__)
  static const bool avx2 = __builtin_cpu_supports("avx2");
  if (avx2) return scan_avx2(map, x, y, count, dx, dy, out);
#endif
  return scan_portable(map, x, y, 0, count, dx, dy, out);
}

}  // namespace foothold::xrobin
