// Interval halving on the edges of the ring, in the frame of the body that holds.
#include "surroundings.hpp"

#include <algorithm>
#include <limits>

namespace foothold::xrobin {
namespace {

using geometry::Vector2d;

// A pose with its cosine and sine at hand.
struct Frame {
  explicit Frame(const PlanarPose& pose) : x(pose.x), y(pose.y), c(std::cos(pose.heading)), s(std::sin(pose.heading)) {}
  Vector2d seen(const Vector2d& p) const {
    const double dx = p.x() - x;
    const double dy = p.y() - y;
    return {c * dx + s * dy, c * dy - s * dx};
  }
  double x, y, c, s;
};

}  // namespace

Surroundings::Surroundings(const Ring& ring, const Bodies& bodies, std::vector<geometry::Obstacle> obstacles, double clearance)
    : ring_(std::make_shared<const Ring>(ring)), bodies_(bodies), obstacles_(std::move(obstacles)), clearance_(clearance) {
  for (const geometry::Obstacle& obstacle : obstacles_) circles_.push_back(geometry::circle_round(obstacle.polygon));
  if (obstacles_.empty()) return;
  for (const bool a_holds : {false, true})
    for (int from = 1; from <= kConfigurations; ++from)
      sweeps_[a_holds ? 1 : 0].emplace_back(*ring_, bodies_, a_holds, ring_->edge(from));
}

bool Surroundings::interval_clear(const Sweep& sweep, std::size_t interval, std::span<const Vector2d> obstacle) const {
  const SweepInterval at = sweep.interval(interval);
  const double enough = clearance_ + at.drift;
  bool in_doubt = false;
  for (const Box& box : at.boxes) {
    const double distance = box_distance(box, obstacle, enough);
    if (distance <= clearance_) return false;
    in_doubt = in_doubt || distance <= enough;
  }
  if (!in_doubt) return true;
  if (at.drift < kResolution) return false;
  return interval_clear(sweep, 2 * interval, obstacle) && interval_clear(sweep, 2 * interval + 1, obstacle);
}

bool Surroundings::edge_clear(bool a_holds, const PlanarPose& held, const RingEdge& edge) const {
  if (obstacles_.empty()) return true;
  const Sweep& sweep = sweeps_[a_holds ? 1 : 0][static_cast<std::size_t>(edge.from - 1)];
  const Frame frame(held);
  geometry::Polygon seen;
  for (std::size_t k = 0; k < obstacles_.size(); ++k) {
    const Vector2d apart = frame.seen(circles_[k].centre) - sweep.circle().centre;
    const double least = sweep.circle().radius + circles_[k].radius + clearance_;
    if (apart.squaredNorm() > least * least) continue;
    seen.clear();
    for (const Vector2d& v : obstacles_[k].polygon) seen.push_back(frame.seen(v));
    if (!interval_clear(sweep, 1, seen)) return false;
  }
  return true;
}

std::array<Box, 4> Surroundings::boxes(const BodyPoses& poses) const {
  const auto axes = piston_axes(ring_->mechanism().lengths(), poses);
  return {box_at(poses.a, bodies_.a.half_x, bodies_.a.half_y), box_at(poses.b, bodies_.b.half_x, bodies_.b.half_y),
          box_between(axes[0].on_a, axes[0].on_b, bodies_.piston_radius),
          box_between(axes[1].on_a, axes[1].on_b, bodies_.piston_radius)};
}

Surroundings::Nearest Surroundings::nearest(const BodyPoses& poses) const {
  Nearest out{std::numeric_limits<double>::infinity(), 0};
  for (const Box& box : boxes(poses))
    for (std::size_t k = 0; k < obstacles_.size(); ++k)
      if (const double distance = box_distance(box, obstacles_[k].polygon); distance < out.distance) out = {distance, k};
  return out;
}

bool Surroundings::clear_at_rest(const BodyPoses& poses) const {
  const std::array<Box, 4> robot = boxes(poses);
  for (const geometry::Obstacle& obstacle : obstacles_)
    for (const Box& box : robot)
      if (box_distance(box, obstacle.polygon, clearance_) <= clearance_) return false;
  return true;
}

bool Surroundings::room_for_a(double x, double y) const {
  const double inscribed = std::min(bodies_.a.half_x, bodies_.a.half_y);
  const Vector2d at(x, y);
  for (std::size_t k = 0; k < obstacles_.size(); ++k) {
    const double least = circles_[k].radius + inscribed + clearance_;
    if ((circles_[k].centre - at).squaredNorm() > least * least) continue;
    if (geometry::distance(obstacles_[k].polygon, at) <= inscribed + clearance_) return false;
  }
  return true;
}

}  // namespace foothold::xrobin
