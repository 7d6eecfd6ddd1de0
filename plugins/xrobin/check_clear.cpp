// Polygons of the bodies in the world, sample by sample.
#include "check_clear.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace foothold::xrobin {
namespace {

using geometry::Polygon;
using geometry::Vector2d;

constexpr double kRobotReach = 0.5;  // m: no part of the robot is farther from the body that holds

Vector2d in_world(const Isometry3d& frame, double x, double y) { return (frame * Vector3d(x, y, 0.0)).head<2>(); }

Polygon outline(const Block& block, const Isometry3d& frame) {
  return {in_world(frame, -block.half_x, -block.half_y), in_world(frame, block.half_x, -block.half_y),
          in_world(frame, block.half_x, block.half_y), in_world(frame, -block.half_x, block.half_y)};
}

// The robot at one sample.
struct Sample {
  Polygon a, b;
  std::array<std::array<Vector2d, 2>, 2> pistons;
};

Isometry3d as_frame(const Relative& r) {
  Isometry3d out = Isometry3d::Identity();
  out.translate(Vector3d(r.position.x(), r.position.y(), 0.0));
  out.rotate(Eigen::AngleAxisd(r.turn, Vector3d::UnitZ()));
  return out;
}

Sample sample(const Lengths& n, const Bodies& bodies, const Isometry3d& a, const Isometry3d& b) {
  return {outline(bodies.a, a),
          outline(bodies.b, b),
          {{{in_world(a, -n.b, 0.0), in_world(b, n.p, 0.0)}, {in_world(a, n.b, 0.0), in_world(b, -n.p, 0.0)}}}};
}

double farthest_move(const Sample& from, const Sample& to) {
  double most = 0.0;
  for (std::size_t k = 0; k < 4; ++k) most = std::max({most, (from.a[k] - to.a[k]).norm(), (from.b[k] - to.b[k]).norm()});
  return most;
}

}  // namespace

Clearance least_clearance(const Lengths& n, const Bodies& bodies, const std::vector<geometry::Obstacle>& obstacles,
                          const Step& step, const Posture& before) {
  const bool a_holds = step.placed.front().limb == "B";
  const Isometry3d held = body(limb(before, a_holds ? "A" : "B").frame);
  std::vector<const geometry::Obstacle*> near;
  for (const geometry::Obstacle& obstacle : obstacles)
    if (geometry::distance(obstacle.polygon, Vector2d(held.translation().head<2>())) < kRobotReach) near.push_back(&obstacle);
  Clearance out{std::numeric_limits<double>::infinity(), ""};
  if (near.empty()) return out;

  const auto robot = [&](const Relative& b_in_a) {
    const Isometry3d a = a_holds ? held : held * as_frame(b_in_a).inverse(Eigen::Isometry);
    const Isometry3d b = a_holds ? held * as_frame(b_in_a) : held;
    return sample(n, bodies, a, b);
  };
  const auto judge = [&](const Sample& s) {
    for (const geometry::Obstacle* obstacle : near) {
      double distance = std::min(geometry::distance(s.a, obstacle->polygon), geometry::distance(s.b, obstacle->polygon));
      for (const auto& [from, to] : s.pistons)
        distance = std::min(distance, geometry::distance(obstacle->polygon, from, to) - bodies.piston_radius);
      if (distance < out.least) out = {distance, obstacle->name};
    }
  };

  Relative now = relative(body(limb(before, "A").frame), body(limb(before, "B").frame));
  std::vector<double> joints = before.joints;
  Sample last = robot(now);
  judge(last);
  for (const MotionPoint& point : step.motion) {
    // Halved until the samples are dense enough: the lengths between two motion points are taken to change evenly.
    const Relative begin = now;
    for (std::size_t parts = 1;; parts *= 2) {
      std::vector<Sample> samples{last};
      double leap = 0.0;
      now = begin;
      for (std::size_t k = 1; k <= parts; ++k) {
        const double part = static_cast<double>(k) / static_cast<double>(parts);
        now = follow(n, now, joints[0] + part * (point.joints[0] - joints[0]), joints[1] + part * (point.joints[1] - joints[1]));
        samples.push_back(robot(now));
        leap = std::max(leap, farthest_move(samples[k - 1], samples[k]));
      }
      if (leap > kSampleStep) continue;
      for (std::size_t k = 1; k <= parts; ++k) judge(samples[k]);
      last = samples.back();
      break;
    }
    joints = point.joints;
  }
  return out;
}

}  // namespace foothold::xrobin
