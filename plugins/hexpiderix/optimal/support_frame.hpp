// Where poses are counted from: the mean of the supports, on the ground; Z the ground's normal, X the thorax' heading.
#pragma once

#include <algorithm>

#include "hexpiderix/strategies/strategies.hpp"

namespace foothold::hexpiderix {

inline Isometry3d support_frame(const Situation& from) {
  Vector3d sum = Vector3d::Zero();
  for (std::size_t leg = 0; leg < kLegs; ++leg)
    if (from.footholds.supports[leg]) sum += from.footholds.points[leg];
  const Vector3d mean = sum / std::max(1.0, static_cast<double>(from.footholds.supports.count()));
  Isometry3d frame = Isometry3d::Identity();
  frame.linear() = axes_along(from.ground.normal, from.thorax.linear().col(0));
  frame.translation() = mean - from.ground.above(mean) * from.ground.normal;
  return frame;
}

}  // namespace foothold::hexpiderix
