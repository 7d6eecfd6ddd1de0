// How a judge of steps says no, and how far two frames are apart.
#pragma once

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "foothold/types.hpp"

namespace foothold::judge {

struct Refusal {
  std::string reason;
};

template <class... Parts>
[[noreturn]] void refuse(const Parts&... parts) {
  std::ostringstream out;
  out.precision(7);
  (out << ... << parts);
  throw Refusal{out.str()};
}

// What `judge` returns, or its refusal as a verdict.
template <class Judge>
StepVerdict verdict_of(const Judge& judge) {
  try {
    return judge();
  } catch (const Refusal& refusal) {
    return {false, refusal.reason, {}};
  }
}

inline constexpr double kPoseTolerance = 1e-6;  // m and rad, between what is sent and what the joints say
inline constexpr double kSame = 1e-9;           // m and rad, of what is sent twice

// m.
inline double apart(const Isometry3d& a, const Isometry3d& b) { return (a.translation() - b.translation()).norm(); }

// rad, of the rotation from one to the other; exact for small ones.
inline double turned(const Isometry3d& a, const Isometry3d& b) {
  const Eigen::Matrix3d r = a.linear().transpose() * b.linear();
  const Vector3d twice_sine(r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1));
  return std::atan2(twice_sine.norm(), r.trace() - 1.0);
}

// Whichever is larger; NaN counts as infinite.
inline double error_between(const Isometry3d& a, const Isometry3d& b) {
  const double error = std::max(apart(a, b), turned(a, b));
  return apart(a, b) + turned(a, b) >= 0.0 ? error : HUGE_VAL;
}

}  // namespace foothold::judge
