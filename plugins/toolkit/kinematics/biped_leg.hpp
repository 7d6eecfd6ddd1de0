// A biped's leg of six joints in closed form: three axes that meet in the hip (yaw about Z, roll about X, pitch about Y), a knee
// about Y, two that meet in the ankle (pitch about Y, roll about X).
//
// Frames are parallel to the pelvis in the zero pose, X forward, Y left, Z up; angles by the right hand about these axes, the knee
// and the ankle's pitch too: who counts otherwise converts. Zero pose: the knee lies at `thigh` from the hip (x, z; y = 0), the
// ankle at `shin` from the knee. Metres and radians. Values; any thread.
#pragma once

#include <Eigen/Geometry>
#include <array>

namespace foothold::kinematics {

struct BipedLeg {
  using Angles = Eigen::Matrix<double, 6, 1>;  // hip yaw, roll, pitch, knee, ankle pitch, roll

  Eigen::Vector3d thigh = Eigen::Vector3d::Zero();  // hip to knee in the zero pose
  Eigen::Vector3d shin = Eigen::Vector3d::Zero();   // knee to ankle

  // Ankle frame seen from the hip frame.
  Eigen::Isometry3d forward(const Angles& angles) const;

  // All angles in (-pi, pi] that bring the ankle's frame to `ankle` (in the hip's frame): up to 8 (two bends of the knee, two turns
  // of the ankle, two of the hip). Numbered so that equal numbers are one branch: neighbouring poses have neighbouring angles on
  // the same branch, away from singularities. Empty if out of reach. On a singular pose (hip above ankle's roll axis, roll at 90
  // deg) a free angle is 0.
  struct Solutions {
    std::array<Angles, 8> angles{};
    std::array<int, 8> branch{};  // 0 to 7, ascending
    int count = 0;
  };
  Solutions inverse(const Eigen::Isometry3d& ankle) const;

  // Branch 0, that of a robot that walks: the knee beyond its stretched place by the right hand (the shin bends backwards), the hip
  // over the ankle's pitch axis as the ankle's roll leaves it (its roll is within 90 deg then if the hip is over the ankle), the
  // hip's roll within 90 deg. False if out of reach. What the planner calls some thousand times a plan: below 0.5 us.
  bool standing(const Eigen::Isometry3d& ankle, Angles& angles) const;
};

}  // namespace foothold::kinematics
