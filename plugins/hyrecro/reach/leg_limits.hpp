// How far a leg is from its limits, without angles: what the searches ask most often.
//
// The margin is the least of: what the leg's length lambda may still shrink or grow before an actuator meets its limit, and half
// the stroke that is left to each mechanism at its angle; m, negative out of limits. As a function of where the hip is and of psi
// it is continuous with slopes below kSlope (per m) and turn_slope() (per rad), which lets a search discard whole cells. Values;
// any thread.
#pragma once

#include <algorithm>
#include <cmath>

#include "hyrecro/reach/leg_plane.hpp"

namespace foothold::hyrecro {

class LegLimits {
 public:
  static constexpr double kSlope = 1.1;

  explicit LegLimits(const Model& model)
      : b_(model.mechanism.base()),
        p_(model.mechanism.body()),
        shortest2_(model.mechanism.shortest() * model.mechanism.shortest()),
        longest2_(model.mechanism.longest() * model.mechanism.longest()),
        core_(model.core),
        least_(2.0 * model.mechanism.offsets(0.0).low - model.core) {}

  // Per rad of psi, with the hip where it is.
  double turn_slope() const { return 1.1 * b_; }

  // `w`: from the ankle pin to the upper pin; psi by its cosine and sine.
  double margin(double wx, double wy, double cos_psi, double sin_psi) const {
    const double lambda = std::sqrt(wx * wx + wy * wy);
    if (lambda < 0.5 * least_) return lambda - least_;
    const double sine = -wx / lambda, cosine = wy / lambda;
    return margin(lambda, stroke(cosine, sine), stroke(cos_psi * cosine + sin_psi * sine, sin_psi * cosine - cos_psi * sine));
  }

  struct Stroke {
    double low, high;
  };
  // The offsets y of a mechanism at an angle. Beyond a right angle the interval goes on to turn inside out.
  Stroke stroke(double cosine, double sine) const {
    const double e = p_ - b_ * cosine, d = b_ * (cosine < 0.0 ? 2.0 - std::fabs(sine) : std::fabs(sine));
    return {std::sqrt(shortest2_ - e * e) + d, std::sqrt(longest2_ - e * e) - d};
  }
  double margin(double lambda, const Stroke& one, const Stroke& two) const {
    const double y = lambda + core_;
    return std::min(std::min(y - one.low - two.low, one.high + two.high - y),
                    0.5 * std::min(one.high - one.low, two.high - two.low));
  }

 private:
  double b_, p_, shortest2_, longest2_, core_, least_;
};

}  // namespace foothold::hyrecro
