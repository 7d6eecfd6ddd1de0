// A plane scene to prisms.
#include "bioloid/ground.hpp"

#include "geometry/plane_scene.hpp"
#include "geometry/triangulation.hpp"
#include "geometry/walls.hpp"

namespace foothold::bioloid {
namespace {

constexpr double kHigh = 0.5;  // m: what has no height reaches over every pose of the robot

}  // namespace

Ground::Ground(const std::string& path) {
  for (const geometry::Obstacle& obstacle : geometry::read_plane_scene(path).obstacles) {
    const double height = obstacle.height.value_or(kHigh);
    for (geometry::Polygon& piece : geometry::convex_pieces(obstacle.polygon))
      prisms_.push_back({obstacle.name, std::move(piece), height});
    const std::vector<Shape> walls = geometry::walls_of(obstacle, height);
    shapes_.insert(shapes_.end(), walls.begin(), walls.end());
  }
}

std::vector<Shape> Ground::shapes() const { return shapes_; }

}  // namespace foothold::bioloid
