// The robot once more, as a tree of Orocos KDL, from the published numbers and not from the shipped file.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

namespace foothold::bioloid::testing {

class KdlRobot {
 public:
  KdlRobot();
  ~KdlRobot();
  KdlRobot(const KdlRobot&) = delete;

  struct State {
    std::array<Eigen::Isometry3d, 19> frames;  // torso's, then those of the bodies behind servos 1 to 18
    Eigen::Vector3d centre_of_mass;            // in the torso's frame
    double mass = 0.0;
  };
  State state(const std::vector<double>& servos) const;

 private:
  struct Tree;
  Tree* tree_;
};

}  // namespace foothold::bioloid::testing
