// How near legs come to each other and to bodies, by many points.
#pragma once

#include "independent.hpp"
#include "octopod/posture/apart.hpp"

namespace foothold::octopod {

using Legs = std::array<LegPoints, kLegs>;

inline Legs legs_of(const Coordinates& at) {
  Legs out;
  for (int k = 0; k < kLegs; ++k) out[static_cast<std::size_t>(k)] = leg(octopod(), at, k);
  return out;
}

inline constexpr int kPoints = 80;  // on a link, 1.25 mm apart: a distance of 1 cm or more comes out less than 0.02 mm too great

// Points on both links of a leg, or on its tibia alone.
template <class Visit>
void along(const LegPoints& at, bool femur_too, Visit&& visit) {
  for (int k = 0; k <= kPoints; ++k) {
    const double part = static_cast<double>(k) / kPoints;
    if (femur_too) visit(Vector3d(at.shoulder + part * (at.knee - at.shoulder)));
    visit(Vector3d(at.knee + part * (at.foot - at.knee)));
  }
}

inline double between_legs(const LegPoints& a, const LegPoints& b) {
  double least = INFINITY;
  along(a, true, [&](const Vector3d& p) {
    least = std::min({least, squared_to_segment(p, b.shoulder, b.knee), squared_to_segment(p, b.knee, b.foot)});
  });
  return std::sqrt(least) - 2 * octopod().leg_radius;
}

inline double to_module(const LegPoints& at, int module, const Isometry3d& pose, bool own) {
  const Vector3d half = octopod().body / 2;
  const double forth = module == 0 ? -1.0 : 1.0;
  const Vector3d neck = pose * Vector3d(forth * half.x(), 0, 0), joint = pose * Vector3d(forth * octopod().arm(), 0, 0);
  double least = INFINITY;
  along(at, !own, [&](const Vector3d& p) {
    const Vector3d seen = pose.inverse() * p;
    least = std::min({least, (seen - seen.cwiseMin(half).cwiseMax(-half)).norm(),
                      std::sqrt(squared_to_segment(p, neck, joint)) - octopod().neck_radius});
  });
  return least - octopod().leg_radius;
}

// The two parts nearest to each other, legs and legs with modules.
struct Nearest {
  double distance = INFINITY;
  Touch parts;
};
inline Nearest nearest_parts(const std::array<Isometry3d, 2>& poses, const Legs& legs) {
  Nearest out;
  for (int i = 0; i < kLegs; ++i) {
    const LegPoints& at = legs[static_cast<std::size_t>(i)];
    for (int j = i + 1; j < kLegs; ++j)
      if (const double away = between_legs(at, legs[static_cast<std::size_t>(j)]); away < out.distance) out = {away, {i, j}};
    for (int m = 0; m < 2; ++m)
      if (const double away = to_module(at, m, poses[static_cast<std::size_t>(m)], module_of(i) == m); away < out.distance)
        out = {away, {i, kBodyOfA + m}};
  }
  return out;
}

}  // namespace foothold::octopod
