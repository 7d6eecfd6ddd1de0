// Postures in the middle of intervals, and bounds on what the rest of the interval can do.
#include "sweep.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace foothold::xrobin {
namespace {

using geometry::Vector2d;

constexpr std::size_t kKept = 64;    // intervals: five halvings
constexpr std::size_t kCircle = 32;  // from here on, kCircle intervals of equal length make up the edge

double corner(const Block& block) { return std::hypot(block.half_x, block.half_y); }

}  // namespace

Sweep::Sweep(const Ring& ring, const Bodies& bodies, bool a_holds, const RingEdge& edge)
    : ring_(&ring), bodies_(bodies), a_holds_(a_holds), edge_(edge) {
  kept_.resize(kKept);
  for (std::size_t k = 1; k < kKept; ++k) kept_[k] = make(k);
  std::vector<Vector2d> ends;
  double drift = 0.0;
  for (std::size_t k = kCircle; k < 2 * kCircle; ++k) {
    for (const Box& box : kept_[k].boxes)
      for (const double sx : {-box.half_x, box.half_x})
        for (const double sy : {-box.half_y, box.half_y})
          ends.emplace_back(box.x + box.cosine * sx - box.sine * sy, box.y + box.sine * sx + box.cosine * sy);
    drift = std::max(drift, kept_[k].drift);
  }
  circle_ = geometry::circle_round(ends);
  circle_.radius += drift + std::max(0.0, bodies.piston_radius);
}

SweepInterval Sweep::interval(std::size_t k) const { return k < kKept ? kept_[k] : make(k); }

SweepInterval Sweep::make(std::size_t k) const {
  const int level = static_cast<int>(std::bit_width(k)) - 1;
  const double parts = std::ldexp(1.0, level);
  const double length = (edge_.phi_to - edge_.phi_from) / parts;
  const double from = edge_.phi_from + length * static_cast<double>(k - (std::size_t{1} << level));
  const SlotPosture at = ring_->at(edge_, from + 0.5 * length);
  const PlanarPose b_in_a{0.0, at.y, at.phi};
  const BodyPoses poses = a_holds_ ? BodyPoses{{}, b_in_a} : BodyPoses{inverse(b_in_a), {}};
  const Lengths& n = ring_->mechanism().lengths();
  const Block& block = a_holds_ ? bodies_.b : bodies_.a;
  const auto axes = piston_axes(n, poses);
  SweepInterval out{{box_at(a_holds_ ? poses.b : poses.a, block.half_x, block.half_y),
                     box_between(axes[0].on_a, axes[0].on_b, bodies_.piston_radius),
                     box_between(axes[1].on_a, axes[1].on_b, bodies_.piston_radius)},
                    0.0};
  // A point q of B moves in A's frame by |y'| + |q| per radian at most, one of A in B's frame by |y'| + |q| + |y|; a piston by no
  // more than its pin on the moving body.
  const double half = 0.5 * std::abs(length);
  const double slope = ring_->slope_bound(edge_, from, from + length);
  const double arm = a_holds_ ? std::max(corner(bodies_.b), n.p) : std::max(corner(bodies_.a), n.b) + std::abs(at.y) + slope * half;
  out.drift = half * (slope + arm);
  return out;
}

}  // namespace foothold::xrobin
