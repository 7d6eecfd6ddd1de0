// Xrobin among obstacles: whether a posture, or the whole way from one configuration to the next, keeps clear of them.
//
// The way is judged without gaps: at each posture looked at, the distance to an obstacle is compared with how far any point of
// what moves can be from where it is there on the rest of the interval (sweep.hpp); if that leaves no doubt the interval is
// clear, else it is halved.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "geometry/plane_scene.hpp"
#include "sweep.hpp"

namespace foothold::xrobin {

// Immutable; any thread.
class Surroundings {
 public:
  // Postures nearer than this beyond the clearance may be called blocked (m): the halving ends somewhere.
  static constexpr double kResolution = 1e-5;

  // `clearance` in m: bodies and pistons stay at least so far away from every obstacle.
  Surroundings(const Ring& ring, const Bodies& bodies, std::vector<geometry::Obstacle> obstacles, double clearance);

  // Whether the body that moves and both pistons stay clear on the whole edge while the other body holds at `held`.
  bool edge_clear(bool a_holds, const PlanarPose& held, const RingEdge& edge) const;
  // The least distance of the robot at rest to an obstacle, and its index; infinite without obstacles.
  struct Nearest {
    double distance;
    std::size_t obstacle;
  };
  Nearest nearest(const BodyPoses& poses) const;
  // Whether bodies and pistons keep their clearance in a posture.
  bool clear_at_rest(const BodyPoses& poses) const;
  // False if body A cannot stand with its centre here in any heading.
  bool room_for_a(double x, double y) const;

  const std::vector<geometry::Obstacle>& obstacles() const { return obstacles_; }
  double clearance() const { return clearance_; }
  const Ring& ring() const { return *ring_; }
  const Bodies& bodies() const { return bodies_; }

 private:
  bool interval_clear(const Sweep& sweep, std::size_t interval, std::span<const geometry::Vector2d> obstacle) const;
  std::array<Box, 4> boxes(const BodyPoses& poses) const;

  std::shared_ptr<const Ring> ring_;  // the sweeps point into it
  Bodies bodies_;
  std::vector<geometry::Obstacle> obstacles_;
  std::vector<geometry::Circle> circles_;  // round the obstacles
  double clearance_;
  std::array<std::vector<Sweep>, 2> sweeps_;  // [a holds][edge]
};

}  // namespace foothold::xrobin
