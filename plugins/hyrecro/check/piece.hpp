// A straight piece of a motion: all ten joints linear between two points.
#pragma once

#include <array>
#include <span>

#include "hyrecro/check/rates.hpp"

namespace foothold::hyrecro {

// Borrows the joints of its ends.
struct Piece {
  std::span<const double> from, to;
  Rates rates;
  double begin = 0.0, end = 0.0;  // s from the step's begin

  std::array<double, kJoints> joints_at(double part) const {
    std::array<double, kJoints> out{};
    for (std::size_t k = 0; k < kJoints; ++k) out[k] = from[k] + part * (to[k] - from[k]);
    return out;
  }
  double time_at(double part) const { return begin + part * (end - begin); }
};

}  // namespace foothold::hyrecro
