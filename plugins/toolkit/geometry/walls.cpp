// Walls along a polygon's edges, and its roof.
#include "geometry/walls.hpp"

namespace foothold::geometry {

std::vector<Shape> walls_of(const Obstacle& obstacle, double height) {
  std::vector<Shape> out;
  const auto add = [&](std::vector<Vector3d> vertices) {
    out.push_back({Shape::Kind::kPolygon, obstacle.name, Isometry3d::Identity(), Vector3d::Zero(), std::move(vertices)});
  };
  std::vector<Vector3d> roof;
  for (const Vector2d& v : obstacle.polygon) roof.emplace_back(v.x(), v.y(), height);
  const Vector3d down(0.0, 0.0, -height);
  for (std::size_t i = 0; i < roof.size(); ++i) {
    const Vector3d &from = roof[i], &to = roof[(i + 1) % roof.size()];
    add({from + down, to + down, to, from});
  }
  add(std::move(roof));
  return out;
}

}  // namespace foothold::geometry
