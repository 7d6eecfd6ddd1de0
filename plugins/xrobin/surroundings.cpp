// Interval halving on the edges of the ring, in the frame of the body that holds.
#include "surroundings.hpp"

#include <algorithm>
#include <limits>

#include "box.hpp"

namespace foothold::xrobin {
namespace {

using geometry::Circle;
using geometry::Vector2d;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kSamples = 32;  // postures of an edge from which its circle is made

Vector2d into_frame(const PlanarPose& frame, const Vector2d& point) {
  const double c = std::cos(frame.heading);
  const double s = std::sin(frame.heading);
  const Vector2d d(point.x() - frame.x, point.y() - frame.y);
  return {c * d.x() + s * d.y(), c * d.y() - s * d.x()};
}

geometry::Polygon into_frame(const PlanarPose& frame, std::span<const Vector2d> points) {
  const double c = std::cos(frame.heading);
  const double s = std::sin(frame.heading);
  geometry::Polygon out;
  out.reserve(points.size());
  for (const Vector2d& p : points) {
    const Vector2d d(p.x() - frame.x, p.y() - frame.y);
    out.emplace_back(c * d.x() + s * d.y(), c * d.y() - s * d.x());
  }
  return out;
}

double corner(const Block& block) { return std::hypot(block.half_x, block.half_y); }

}  // namespace

Surroundings::Surroundings(const Ring& ring, const Bodies& bodies, std::vector<geometry::Obstacle> obstacles, double clearance)
    : ring_(ring), bodies_(bodies), obstacles_(std::move(obstacles)), clearance_(clearance) {
  for (const geometry::Obstacle& obstacle : obstacles_) circles_.push_back(geometry::circle_round(obstacle.polygon));
  const Lengths& n = ring_.mechanism().lengths();
  for (const bool a_holds : {false, true})
    for (int from = 1; from <= kConfigurations; ++from) {
      const RingEdge& edge = ring_.edge(from);
      std::vector<Vector2d> centres;
      for (int k = 0; k <= kSamples; ++k) {
        const double phi = edge.phi_from + (edge.phi_to - edge.phi_from) * k / kSamples;
        const Moving moving = moving_at(a_holds, ring_.at(edge, phi));
        centres.emplace_back(moving.body.x, moving.body.y);
        for (const PistonAxis& axis : moving.pistons) centres.push_back(a_holds ? axis.on_b : axis.on_a);
      }
      Circle circle = geometry::circle_round(centres);
      // Round the samples the bodies themselves, what lies between two samples, and the pins that do not move.
      const double step = std::abs(edge.phi_to - edge.phi_from) / kSamples;
      const double speed =
          ring_.slope_bound(edge, edge.phi_from, edge.phi_to) + corner(bodies_.a) + corner(bodies_.b) + ring_.mechanism().travel();
      circle.radius += step * speed + std::max(corner(a_holds ? bodies_.b : bodies_.a), bodies_.piston_radius);
      circle.radius = std::max(circle.radius, circle.centre.norm() + (a_holds ? n.b : n.p) + bodies_.piston_radius);
      swept_[a_holds ? 1 : 0][static_cast<std::size_t>(from - 1)] = circle;
    }
}

Surroundings::Moving Surroundings::moving_at(bool a_holds, const SlotPosture& at) const {
  const PlanarPose b_in_a{0.0, at.y, at.phi};
  const BodyPoses poses = a_holds ? BodyPoses{{}, b_in_a} : BodyPoses{inverse(b_in_a), {}};
  return {a_holds ? poses.b : poses.a, piston_axes(ring_.mechanism().lengths(), poses)};
}

double Surroundings::distance_to(const Moving& moving, bool a_holds, std::span<const Vector2d> obstacle, double enough) const {
  const Block& block = a_holds ? bodies_.b : bodies_.a;
  double least = box_distance(block.half_x, block.half_y, into_frame(moving.body, obstacle));
  for (const PistonAxis& axis : moving.pistons) {
    if (least <= enough) return least;
    least = std::min(least, geometry::distance(obstacle, axis.on_a, axis.on_b) - bodies_.piston_radius);
  }
  return least;
}

bool Surroundings::interval_clear(bool a_holds, const RingEdge& edge, double from, double to,
                                  std::span<const Vector2d> obstacle) const {
  const double middle = 0.5 * (from + to);
  const SlotPosture at = ring_.at(edge, middle);
  const double distance = distance_to(moving_at(a_holds, at), a_holds, obstacle, clearance_);
  if (distance <= clearance_) return false;
  // A point q of B moves in A's frame by |y'| + |q| per radian at most, one of A in B's frame by |y'| + |q| + |y|; a piston by no
  // more than its pin on the moving body.
  const Lengths& n = ring_.mechanism().lengths();
  const double half = 0.5 * std::abs(to - from);
  const double slope = ring_.slope_bound(edge, from, to);
  const double arm = a_holds ? std::max(corner(bodies_.b), n.p) : std::max(corner(bodies_.a), n.b) + std::abs(at.y) + slope * half;
  const double drift = half * (slope + arm);
  if (distance - drift > clearance_) return true;
  if (drift < kResolution) return false;
  return interval_clear(a_holds, edge, from, middle, obstacle) && interval_clear(a_holds, edge, middle, to, obstacle);
}

bool Surroundings::edge_clear(bool a_holds, const PlanarPose& held, const RingEdge& edge) const {
  const Circle& swept = swept_[a_holds ? 1 : 0][static_cast<std::size_t>(edge.from - 1)];
  for (std::size_t k = 0; k < obstacles_.size(); ++k) {
    const Vector2d centre = into_frame(held, circles_[k].centre);
    if ((centre - swept.centre).norm() > swept.radius + circles_[k].radius + clearance_) continue;
    const geometry::Polygon seen = into_frame(held, obstacles_[k].polygon);
    if (geometry::distance(seen, swept.centre) > swept.radius + clearance_) continue;
    if (!interval_clear(a_holds, edge, edge.phi_from, edge.phi_to, seen)) return false;
  }
  return true;
}

Surroundings::Nearest Surroundings::nearest(const BodyPoses& poses) const {
  Nearest out{kInfinity, 0};
  const auto axes = piston_axes(ring_.mechanism().lengths(), poses);
  for (std::size_t k = 0; k < obstacles_.size(); ++k) {
    const geometry::Polygon& polygon = obstacles_[k].polygon;
    double distance = std::min(box_distance(bodies_.a.half_x, bodies_.a.half_y, into_frame(poses.a, polygon)),
                               box_distance(bodies_.b.half_x, bodies_.b.half_y, into_frame(poses.b, polygon)));
    for (const PistonAxis& axis : axes)
      distance = std::min(distance, geometry::distance(polygon, axis.on_a, axis.on_b) - bodies_.piston_radius);
    if (distance < out.distance) out = {distance, k};
  }
  return out;
}

bool Surroundings::room_for_a(double x, double y) const {
  const double inscribed = std::min(bodies_.a.half_x, bodies_.a.half_y);
  return std::all_of(obstacles_.begin(), obstacles_.end(), [&](const geometry::Obstacle& obstacle) {
    return geometry::distance(obstacle.polygon, Vector2d(x, y)) > inscribed + clearance_;
  });
}

}  // namespace foothold::xrobin
