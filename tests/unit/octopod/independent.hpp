// Judges of postures that share nothing with the plugin but forward kinematics: nearest points triangle by triangle, bodies by
// points.
#pragma once

#include "grounds.hpp"
#include "octopod/posture/posture.hpp"

namespace foothold::octopod {

inline double squared_to_segment(const Vector3d& p, const Vector3d& a, const Vector3d& b) {
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - t * (b - a)).squaredNorm();
}

// Distance of a point to the nearest of all triangles, by planes and edges.
inline double distance_to_ground(const terrain::Terrain& ground, const Vector3d& p) {
  double least = INFINITY;
  for (int t = 0; t < static_cast<int>(ground.size()); ++t) {
    const Vector3d a = ground.corner(t, 0), b = ground.corner(t, 1), c = ground.corner(t, 2);
    const Vector3d normal = (b - a).cross(c - a);
    const Vector3d foot = p - (p - a).dot(normal) / normal.squaredNorm() * normal;
    const bool inside = (b - a).cross(foot - a).dot(normal) >= 0 && (c - b).cross(foot - b).dot(normal) >= 0 &&
                        (a - c).cross(foot - c).dot(normal) >= 0;
    const double squared = inside
                               ? (p - foot).squaredNorm()
                               : std::min({squared_to_segment(p, a, b), squared_to_segment(p, b, c), squared_to_segment(p, c, a)});
    least = std::min(least, squared);
  }
  return std::sqrt(least);
}

// z of a ground without overhangs above (x, y); -infinity beside it.
inline double height_at(const terrain::Terrain& ground, const Vector3d& p) {
  for (int t = 0; t < static_cast<int>(ground.size()); ++t) {
    const Vector3d &a = ground.corner(t, 0), &b = ground.corner(t, 1), &c = ground.corner(t, 2);
    const auto twice_area = [](const Vector3d& u, const Vector3d& v, const Vector3d& w) {
      return (v.x() - u.x()) * (w.y() - u.y()) - (v.y() - u.y()) * (w.x() - u.x());
    };
    const double of_a = twice_area(b, c, p), of_b = twice_area(c, a, p), of_c = twice_area(a, b, p), all = of_a + of_b + of_c;
    if (std::min({of_a, of_b, of_c}) < -1e-9 * all) continue;
    return (of_a * a.z() + of_b * b.z() + of_c * c.z()) / all;
  }
  return -INFINITY;
}

// How deep points of bodies and legs lie under the ground at most, m; negative: above it. Of feet only what is above the ground by
// a part `sole` of the tibia counts.
inline double depth(const Model& model, const terrain::Terrain& ground, const Coordinates& at, double sole, int points = 6) {
  double deepest = -INFINITY;
  const auto look = [&](const Vector3d& p) { deepest = std::max(deepest, height_at(ground, p) - p.z()); };
  for (const Isometry3d& module : modules(model, at))
    for (int i = 0; i <= points; ++i)
      for (int j = 0; j <= points; ++j)
        for (const double z : {-0.5, 0.5})
          look(module * model.body.cwiseProduct(Vector3d(i, j, 0) / points - Vector3d(0.5, 0.5, z)));
  for (int leg_index = 0; leg_index < kLegs; ++leg_index) {
    const LegPoints points_of = leg(model, at, leg_index);
    const Vector3d ankle = points_of.foot + (points_of.knee - points_of.foot) * sole;
    for (int i = 0; i <= points; ++i) {
      const double part = static_cast<double>(i) / points;
      look(points_of.shoulder + part * (points_of.knee - points_of.shoulder));
      look(points_of.knee + part * (ankle - points_of.knee));
    }
  }
  return deepest;
}

}  // namespace foothold::octopod
