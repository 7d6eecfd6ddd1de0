// The robot as the check sees it: from a sole that stands, by screws whose lines lie where the zero pose has them (paper, eq. 16),
// with bounds on how fast and how crooked its points move along a straight line in the joints. Metres, radians; per unit of the
// line.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "bioloid/model/model.hpp"
#include "collision/distance.hpp"

namespace foothold::bioloid::check {

using Eigen::Matrix3d;

// One instant, in the frame of the sole that stands.
struct Instant {
  std::array<Isometry3d, kBodies> moved;  // from where the zero pose has a body's points to where they are
  std::vector<collision::Box> boxes;      // those of body b from first_box(b)
  Vector3d centre_of_mass = Vector3d::Zero();
};

// How everything moves at an instant.
struct Velocities {
  std::array<Vector3d, kBodies> turn, slide;  // of body b: a point p moves by turn x p + slide
  Vector3d centre_of_mass = Vector3d::Zero();
  Vector3d of(std::size_t body, const Vector3d& point) const { return turn[body].cross(point) + slide[body]; }
};

// Bounds that hold for the whole line.
struct Rates {
  std::array<double, kBodies> slope{}, bend{};  // of a body's farthest point: first and second derivative
  double centre_bend = 0.0;                     // of the centre of mass
  std::array<double, kBodies> turn_bend{};      // of a body's angular velocity
};

class Skeleton {
 public:
  Skeleton(const Model& model, Side standing);

  Instant at(const Joints& joints) const;
  Velocities velocities(const Instant& instant, const Joints& change) const;
  Rates rates(const Joints& change) const;

  // Bodies that have to keep clear of each other, and how fast a point of one can move as seen from the other.
  struct Pair {
    std::size_t a = 0, b = 0;
    std::vector<std::pair<int, double>> levers;  // joint, m
    double slope(const Joints& change) const;
  };
  const std::vector<Pair>& pairs() const { return pairs_; }

  std::size_t first_box(std::size_t body) const { return first_box_[body]; }
  // Of a foot: its sole, and its sole's corners, where the zero pose has them.
  Vector3d sole(Side side) const;
  std::array<Vector3d, 4> sole_corners(Side side) const;
  Vector3d torso() const { return places_[0]; }  // the torso's origin in the zero pose

 private:
  struct Link {
    std::size_t body = 0, carrier = 0;
    int joint = 0;
    double sign = 1.0;  // -1: seen from beyond the joint
    kinematics::Screw line;
  };
  struct Reach {
    int joint = 0;
    double farthest = 0.0, centre = 0.0;  // of the joint's line from the body's farthest point and its centre of mass
  };

  void find_reach(std::size_t body);
  void find_pair(std::size_t a, std::size_t b);

  const Model& model_;
  double mass_ = 0.0;
  std::array<Vector3d, kBodies> places_;           // bodies' origins in the zero pose, from the sole that stands
  std::vector<Link> links_;                        // carriers first; the standing foot is none
  std::array<std::vector<Reach>, kBodies> reach_;  // from the standing foot outwards
  std::array<std::size_t, kBodies + 1> first_box_{};
  std::vector<Pair> pairs_;
};

}  // namespace foothold::bioloid::check
