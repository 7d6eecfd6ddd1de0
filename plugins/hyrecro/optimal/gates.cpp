#include "hyrecro/optimal/gates.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foothold::hyrecro {
namespace {

constexpr std::size_t kMostGates = 6;
constexpr double kApart = 0.15, kTurned = 0.5;  // m, rad: gates that are nearer than both are one
constexpr int kDirections = 72;                 // of the hip plate
constexpr int kHeadings = 18;                   // in half a turn: soles are alike from both ends
constexpr int kLeans = 6;                       // to either side
constexpr double kMostLean = 1.5;               // rad
constexpr double kUpright = 1e-6;
constexpr double kStep = 0.03;                        // m, on other faces
constexpr std::size_t kMostAsked = 60, kPerFace = 2;  // of one other face

class Search {
 public:
  Search(Strides& strides, Legs& legs, const ReachFilter& filter, const Foothold& end, const Banned& banned,
         const std::stop_token& stop)
      : strides_(strides),
        legs_(legs),
        filter_(filter),
        model_(strides.model()),
        scene_(strides.scene()),
        end_(end),
        sole_(pose_of(scene_.truss, end)),
        banned_(banned),
        stop_(stop) {}

  std::vector<Stride> run() {
    own_face();
    const bool none = out_.empty();
    for (std::size_t face = 0; none && face < scene_.truss.faces.size() && !full(); ++face)
      if (static_cast<int>(face) != end_.face) look_at(static_cast<int>(face));
    return std::move(out_);
  }

 private:
  bool full() const { return out_.size() == kMostGates || stop_.stop_requested(); }
  double along(int face) {
    const Vector2d& line = legs_.strip(face).along;
    return std::atan2(line.y(), line.x());
  }
  // Worth a look: apart from the gates there are, on its face, not banned.
  bool fresh(const Foothold& there) const {
    const auto near = [&](const Stride& gate) {
      return gate.to.face == there.face && (gate.to.at - there.at).norm() < kApart &&
             std::fabs(std::remainder(gate.to.heading - there.heading, std::numbers::pi)) < kTurned;
    };
    return std::none_of(out_.begin(), out_.end(), near) && strides_.on_face(there) && !(banned_ && banned_(end_, there));
  }

  void own_face() {
    const double line = along(end_.face);
    const Eigen::Rotation2Dd turn(end_.heading);
    for (const LevelPostures::Level& level : strides_.level_postures().spread())
      for (const double own : level.shifts)
        for (int k = 0; k < kDirections && !full(); ++k) {
          const double tau = 2.0 * std::numbers::pi * k / kDirections;
          if (!own_half_free(own, level.height, tau)) continue;
          for (const double other : level.shifts)
            for (int h = 0; h < kHeadings && !full(); ++h) {
              const double heading = line + std::numbers::pi * h / kHeadings - end_.heading;
              const Vector2d place = Vector2d(own, 0.0) + model_.hip_distance * direction(tau) - other * direction(heading);
              const Foothold there{end_.face, end_.at + turn * place, end_.heading + heading};
              if (!fresh(there)) continue;
              const auto posture = strides_.level_postures().posture(own, other, level.height, tau, heading);
              if (posture && strides_.fits(*posture, sole_) && legs_.has_footing(there, false)) out_.push_back({there, *posture});
            }
        }
  }

  // The leg that stands here and the hip plate, wherever the other foot is.
  bool own_half_free(double shift, double height, double tau) const {
    const auto posture = strides_.level_postures().posture(shift, shift, height, tau, 0.0);
    if (!posture) return false;
    const Bodies bodies = bodies_at(model_, *posture, sole_);
    const double reach = 0.99 * scene_.clearance;  // fits() has the last word
    return std::isinf(scene_.obstacles.distance(bodies.hip, reach)) && std::isinf(scene_.obstacles.distance(bodies.leg[0], reach));
  }

  void look_at(int face) {
    const truss::Face& there = scene_.truss.faces[static_cast<std::size_t>(face)];
    const double reach = strides_.bounds().transition_reach();
    const Isometry3d back = pose_of(scene_.truss, {face, Vector2d::Zero(), 0.0}).inverse(Eigen::Isometry);
    const Vector3d from = back * sole_.translation();
    if (std::fabs(from.z()) > reach) return;
    Vector2d low = there.outline.front(), high = low;
    for (const Vector2d& vertex : there.outline) {
      low = low.cwiseMin(vertex);
      high = high.cwiseMax(vertex);
    }
    low = low.cwiseMax(from.head<2>() - Vector2d::Constant(reach));
    high = high.cwiseMin(from.head<2>() + Vector2d::Constant(reach));
    std::size_t asked = 0, taken = 0;
    double last = 1e9;
    for (int k = -kLeans; k <= kLeans; ++k) {
      // The hip plate's normal lies in the planes of both legs, so the lean of the leg that stands here tells where the other
      // heads.
      const double lean = kMostLean * k / kLeans;
      const Vector3d normal = back.linear() * sole_.linear() * Vector3d(-std::sin(lean), 0.0, std::cos(lean));
      if (normal.head<2>().norm() < kUpright) continue;
      const double heading = std::atan2(normal.y(), normal.x());
      if (std::fabs(std::remainder(heading - last, std::numbers::pi)) < kUpright) continue;
      last = heading;
      const Isometry3d turned = sole_.inverse(Eigen::Isometry) * pose_of(scene_.truss, {face, Vector2d::Zero(), heading});
      const ReachFilter::Turn turn = filter_.turn(turned.linear());
      if (turn.never()) continue;
      for (double x = low.x(); x <= high.x(); x += kStep)
        for (double y = low.y(); y <= high.y(); y += kStep) {
          if (full() || asked == kMostAsked || taken == kPerFace) return;
          const Foothold at{face, {x, y}, heading};
          const Vector3d seen = sole_.inverse(Eigen::Isometry) * pose_of(scene_.truss, at).translation();
          if (!filter_.may_reach(turn, seen) || !fresh(at)) continue;
          ++asked;
          const std::optional<Coordinates> posture = strides_.exact(end_, at);
          if (!posture || !legs_.has_footing(at, false)) continue;
          out_.push_back({at, *posture});
          ++taken;
        }
    }
  }

  Strides& strides_;
  Legs& legs_;
  const ReachFilter& filter_;
  const Model& model_;
  const PreparedTruss& scene_;
  const Foothold& end_;
  const Isometry3d sole_;
  const Banned& banned_;
  const std::stop_token& stop_;
  std::vector<Stride> out_;
};

}  // namespace

std::vector<Stride> gates(Strides& strides, Legs& legs, const ReachFilter& filter, const Foothold& end, const Banned& banned,
                          const std::stop_token& stop) {
  return Search(strides, legs, filter, end, banned, stop).run();
}

}  // namespace foothold::hyrecro
