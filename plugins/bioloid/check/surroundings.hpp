// What the robot has to keep clear of, seen from the sole that stands: itself, the obstacles, the ground.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "bioloid/check/skeleton.hpp"
#include "bioloid/prism.hpp"

namespace foothold::bioloid::check {

class Surroundings {
 public:
  // `standing_at`: of the standing sole, in the world. Throws judge::Refusal for an obstacle that is no convex prism.
  Surroundings(const Model& model, const Skeleton& skeleton, std::span<const Prism> obstacles, const Isometry3d& standing_at,
               Side standing);

  // Two that have to keep clear of each other.
  struct Item {
    enum class Kind { kPair, kObstacle, kGround } kind = Kind::kPair;
    std::size_t body = 0;   // unused by pairs
    std::size_t index = 0;  // of the pair or the obstacle
  };
  const std::vector<Item>& items() const { return items_; }
  // m, of what is demanded between bodies: nothing but not to be below it from the ground.
  static double demanded(const Item& item, double clearance) { return item.kind == Item::Kind::kGround ? 0.0 : clearance; }
  // m, at most `limit`, which is quicker than the distance itself; 0 or less if they touch.
  double distance(const Instant& instant, const Item& item, double limit) const;
  // m per unit of a line, at most.
  double slope(const Item& item, const Joints& change, const Rates& rates) const;
  std::string names(const Item& item) const;

 private:
  struct Obstacle {
    std::string name;
    std::vector<std::vector<Vector3d>> faces;  // top and sides
    geometry::Polygon outline;                 // counter-clockwise
    Vector3d centre = Vector3d::Zero();
    double radius = 0.0, height = 0.0;
  };
  double to_obstacle(const collision::Box& box, const Obstacle& obstacle, double limit) const;

  const Model& model_;
  const Skeleton& skeleton_;
  std::vector<Obstacle> obstacles_;
  std::vector<Item> items_;
};

}  // namespace foothold::bioloid::check
