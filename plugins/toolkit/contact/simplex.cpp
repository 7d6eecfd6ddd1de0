// The loops of kernel.inc, once for each kind of machine.
#include "contact/simplex.hpp"

#include <immintrin.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

// Vectors are never passed through a real call.
#pragma GCC diagnostic ignored "-Wpsabi"

namespace foothold::contact::simplex {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr Eight kPerturbed = {{1.3e-7, 0.7e-7, 1.0 + 1.1e-7, 0.9e-7, 1.7e-7, 0.5e-7, 0.0, 0.0}};
constexpr double kZero = 1e-12;            // of an x
constexpr double kLeastPivot = 1e-9;       // of a step's change of a basic x
constexpr double kDependent = 1e-7;        // of a column's change of each artificial x
constexpr double kLeastKnownPivot = 1e-3;  // of a column in the row that it had before
constexpr double kSeparation = 2.5e-10;    // least y.w of a separating wrench of unit size
constexpr double kOverhang = 0.5e-5;       // greatest y.g of one, as a part of y.w
// Columns of a circular cone come from one wider by this part of mu, which certificates forgive: then a column near to the best one
// is as good as the best one is for the cone as it is, and the method ends instead of making columns ever closer to each other.
constexpr double kWidening = 2e-10;
constexpr double kRoundoff = 1e-14;  // of a price, as a part of |y|
constexpr double kSettled = 1e-11;   // of a price beyond which phase two does not go on, as a part of |y|
constexpr double kUnit = 2e-6;       // of the square of a normal's length
constexpr int kPivotsWithPerturbation = 200, kPivotsWithout = 200;

struct Wrench {
  std::array<double, 3> force, torque;
};

struct Best {
  double price = 0.0;  // of the column
  double reach = 0.0;  // the greatest y.g over the cones as they are
  Column column;
};

// The corners of a regular simplex round w, in the five other rows.
std::array<std::array<double, 6>, 6> directions_round_w() {
  constexpr double kSpread = 2.0;  // measured: the fewest pivots on random stances
  constexpr std::array<std::size_t, 5> kRows = {0, 1, 3, 4, 5};
  std::array<std::array<double, 6>, 6> out;
  for (std::size_t k = 0; k < 6; ++k) {
    out[k].fill(0.0);
    out[k][2] = 1.0;
    // Rows of Helmert's matrix.
    for (std::size_t j = 1; j < 6; ++j) {
      const double entry = k < j ? 1.0 : (k == j ? -static_cast<double>(j) : 0.0);
      out[k][kRows[j - 1]] = kSpread * entry / std::sqrt(static_cast<double>(j * (j + 1)));
    }
  }
  return out;
}

const std::array<std::array<double, 6>, 6> kDirections = directions_round_w();

// The power of 2 above the square root of this, or twice that.
double power_above_root(double square) {
  const int exponent = static_cast<int>(std::bit_cast<std::uint64_t>(square) >> 52) - 1023;
  return std::bit_cast<double>(static_cast<std::uint64_t>((exponent >> 1) + 1024) << 52);
}

}  // namespace

#pragma GCC push_options
#pragma GCC target("avx512f,avx512vl,avx512dq")
#define FOOTHOLD_WIDTH 8
namespace {
namespace eight {
constexpr int kWidth = 8;
#include "contact/lanes.inc"
// which the next one is written in
#include "contact/kernel.inc"
}  // namespace eight
}  // namespace
#undef FOOTHOLD_WIDTH
#undef FOOTHOLD_INLINE
#pragma GCC pop_options

#pragma GCC push_options
#pragma GCC target("avx2")
#define FOOTHOLD_WIDTH 4
namespace {
namespace four {
constexpr int kWidth = 4;
#include "contact/lanes.inc"
// which the next one is written in
#include "contact/kernel.inc"
}  // namespace four
}  // namespace
#undef FOOTHOLD_WIDTH
#undef FOOTHOLD_INLINE
#pragma GCC pop_options

#define FOOTHOLD_WIDTH 2
namespace {
namespace two {
constexpr int kWidth = 2;
#include "contact/lanes.inc"
// which the next one is written in
#include "contact/kernel.inc"
}  // namespace two
}  // namespace
#undef FOOTHOLD_WIDTH
#undef FOOTHOLD_INLINE

const Kernel* kernel_of_width(int width) {
  __builtin_cpu_init();
  if (width == 8 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq"))
    return &eight::kKernel;
  if (width == 4 && __builtin_cpu_supports("avx2")) return &four::kKernel;
  return width == 2 ? &two::kKernel : nullptr;
}

const Kernel& kernel() {
  static const Kernel& best = []() -> const Kernel& {
    for (const int width : {8, 4})
      if (const Kernel* here = kernel_of_width(width)) return *here;
    return two::kKernel;
  }();
  return best;
}

}  // namespace foothold::contact::simplex
