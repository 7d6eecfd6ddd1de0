// Xrobin among obstacles: whether a posture, or the whole way from one configuration to the next, keeps clear of them.
//
// The way is judged without gaps: at each posture looked at, the distance to an obstacle is compared with how far any point of the
// moving body can be from where it is there on the rest of the interval; if that leaves no doubt the interval is clear, else it is
// halved.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "body.hpp"
#include "geometry/plane_scene.hpp"
#include "ring.hpp"

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
  // False if body A cannot stand with its centre here in any heading.
  bool room_for_a(double x, double y) const;

  const std::vector<geometry::Obstacle>& obstacles() const { return obstacles_; }
  double clearance() const { return clearance_; }
  const Ring& ring() const { return ring_; }
  const Bodies& bodies() const { return bodies_; }

 private:
  // What moves, at one posture: the body, and the pistons' pins, in the frame of the body that holds.
  struct Moving {
    PlanarPose body;
    std::array<PistonAxis, 2> pistons;
  };
  Moving moving_at(bool a_holds, const SlotPosture& at) const;
  double distance_to(const Moving& moving, bool a_holds, std::span<const geometry::Vector2d> obstacle, double enough) const;
  bool interval_clear(bool a_holds, const RingEdge& edge, double from, double to,
                      std::span<const geometry::Vector2d> obstacle) const;

  Ring ring_;
  Bodies bodies_;
  std::vector<geometry::Obstacle> obstacles_;
  std::vector<geometry::Circle> circles_;  // round the obstacles
  double clearance_;
  std::array<std::array<geometry::Circle, kConfigurations>, 2> swept_;  // [a holds][edge], in the frame of the body that holds
};

}  // namespace foothold::xrobin
