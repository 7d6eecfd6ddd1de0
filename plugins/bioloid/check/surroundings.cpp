// Distances of boxes to boxes, prisms and the ground.
#include "bioloid/check/surroundings.hpp"

#include <algorithm>

#include "judge/refusal.hpp"

namespace foothold::bioloid::check {
namespace {

using collision::Box;

// A ball round the box says most quickly that something is far.
bool balls_apart(const Box& box, const Vector3d& centre, double radius, double limit) {
  const double reach = box.half.norm() + radius + limit;
  return (box.pose.translation() - centre).squaredNorm() > reach * reach;
}

double between(const Box& a, const Box& b, double limit) {
  if (balls_apart(a, b.pose.translation(), b.half.norm(), limit) || !collision::nearer(a, b, limit)) return limit;
  return std::min(limit, collision::distance(a, b));
}

// Of a simple polygon: counter-clockwise and never turning right.
bool is_convex(const geometry::Polygon& polygon) {
  const std::size_t n = polygon.size();
  if (n < 3 || !(geometry::signed_area(polygon) > 0.0)) return false;
  for (std::size_t i = 0; i < n; ++i) {
    const geometry::Vector2d a = polygon[(i + 1) % n] - polygon[i], b = polygon[(i + 2) % n] - polygon[(i + 1) % n];
    if (a.x() * b.y() - a.y() * b.x() < 0.0) return false;
  }
  return true;
}

double lowest(const Box& box) { return box.pose.translation().z() - box.pose.linear().row(2).cwiseAbs() * box.half; }

}  // namespace

Surroundings::Surroundings(const Model& model, const Skeleton& skeleton, std::span<const Prism> obstacles,
                           const Isometry3d& standing_at, Side standing)
    : model_(model), skeleton_(skeleton) {
  const Isometry3d seen = standing_at.inverse();
  for (const Prism& prism : obstacles) {
    if (!is_convex(prism.polygon) || !(prism.height > 0.0))
      judge::refuse("the obstacle '", prism.name, "' is no prism over a convex, counter-clockwise polygon");
    Obstacle out{prism.name, {}, {}, {}, 0.0, prism.height};
    std::vector<Vector3d> low, high;
    for (const geometry::Vector2d& corner : prism.polygon) {
      low.push_back(seen * Vector3d(corner.x(), corner.y(), 0.0));
      high.push_back(low.back() + prism.height * Vector3d::UnitZ());
      out.outline.emplace_back(low.back().x(), low.back().y());
      out.centre += 0.5 * (low.back() + high.back()) / static_cast<double>(prism.polygon.size());
    }
    for (std::size_t i = 0; i < low.size(); ++i) {
      const std::size_t next = (i + 1) % low.size();
      out.faces.push_back({low[i], low[next], high[next], high[i]});
      out.radius = std::max(out.radius, (high[i] - out.centre).norm());
    }
    out.faces.push_back(high);
    obstacles_.push_back(std::move(out));
  }
  for (std::size_t i = 0; i < skeleton.pairs().size(); ++i) items_.push_back({Item::Kind::kPair, 0, i});
  for (std::size_t body = 0; body < kBodies; ++body) {
    if (model.bodies[body].boxes.empty()) continue;
    for (std::size_t i = 0; i < obstacles_.size(); ++i) items_.push_back({Item::Kind::kObstacle, body, i});
    // Feet meet the ground, and an ankle's block stands on its foot's plate, which lies between it and the ground; the foot that
    // moves is judged by its sole.
    const auto of_foot = [&](Side side) { return body == leg_joint(side, 4) + 1 || body == leg_joint(side, 5) + 1; };
    if (!of_foot(standing) && !of_foot(other(standing))) items_.push_back({Item::Kind::kGround, body, 0});
  }
}

double Surroundings::to_obstacle(const Box& box, const Obstacle& obstacle, double limit) const {
  if (balls_apart(box, obstacle.centre, obstacle.radius, limit)) return limit;
  const Vector3d& middle = box.pose.translation();
  if (middle.z() < obstacle.height && geometry::contains(obstacle.outline, {middle.x(), middle.y()})) return 0.0;
  for (const auto& face : obstacle.faces)
    if (const collision::Patch patch{face}; collision::nearer(box, patch, limit))
      limit = std::min(limit, collision::distance(box, patch));
  return limit;
}

double Surroundings::distance(const Instant& instant, const Item& item, double limit) const {
  const auto boxes = [&](std::size_t body) {
    return std::span(instant.boxes).subspan(skeleton_.first_box(body), model_.bodies[body].boxes.size());
  };
  switch (item.kind) {
    case Item::Kind::kPair:
      for (const Box& a : boxes(skeleton_.pairs()[item.index].a))
        for (const Box& b : boxes(skeleton_.pairs()[item.index].b)) limit = between(a, b, limit);
      break;
    case Item::Kind::kObstacle:
      for (const Box& box : boxes(item.body)) limit = to_obstacle(box, obstacles_[item.index], limit);
      break;
    case Item::Kind::kGround:
      for (const Box& box : boxes(item.body)) limit = std::min(limit, lowest(box));
      break;
  }
  return limit;
}

double Surroundings::slope(const Item& item, const Joints& change, const Rates& rates) const {
  return item.kind == Item::Kind::kPair ? skeleton_.pairs()[item.index].slope(change) : rates.slope[item.body];
}

std::string Surroundings::names(const Item& item) const {
  if (item.kind == Item::Kind::kPair) {
    const Skeleton::Pair& pair = skeleton_.pairs()[item.index];
    return model_.bodies[pair.a].name + " and " + model_.bodies[pair.b].name;
  }
  return model_.bodies[item.body].name + " and " +
         (item.kind == Item::Kind::kGround ? std::string("the ground") : "the obstacle '" + obstacles_[item.index].name + "'");
}

}  // namespace foothold::bioloid::check
