// The usual leg of a walking robot: a yaw at the shoulder, then two parallel pitches, closed both ways.
//
// Frame of the shoulder: origin on the yaw's axis, X outwards at yaw 0, Z up along the axis. The yaw turns about Z; the femur's and
// the tibia's angles lift what follows them (positive: up), the tibia's counted from the stretched leg. Metres and radians.
// Values; any thread.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

namespace foothold::kinematics {

struct YawLeg {
  double coxa = 0.0;   // m, from the yaw's axis outwards to the femur's axis
  double drop = 0.0;   // m, by which the femur's axis lies below the shoulder's origin
  double femur = 0.0;  // m, > 0
  double tibia = 0.0;  // m, > 0

  // Femur's axis, knee and foot, for joints (yaw, femur, tibia).
  struct Points {
    Eigen::Vector3d hip, knee, foot;
  };
  Points forward(const Eigen::Vector3d& joints) const;

  // All joints in (-pi, pi] that bring the foot to `foot`: first those with the leg in front of its axis (it looks at the foot),
  // knee up, then knee down, then those that reach backwards over the axis. A foot on the yaw's axis leaves the yaw free: it is
  // `yaw_on_axis` then. Empty if the foot is out of reach; up to `slack` (m) beyond it the stretched or folded leg is given.
  struct Solutions {
    std::array<Eigen::Vector3d, 4> joints{};
    int count = 0;
    const Eigen::Vector3d* begin() const { return joints.data(); }
    const Eigen::Vector3d* end() const { return joints.data() + count; }
  };
  Solutions inverse(const Eigen::Vector3d& foot, double yaw_on_axis = 0.0, double slack = 1e-12) const;
  // Of those the one that stands by itself: yaw within 90 deg, knee up (tibia's angle not above 0). A foot on the axis: yaw 0.
  std::optional<Eigen::Vector3d> standing(const Eigen::Vector3d& foot, double slack = 1e-12) const;

 private:
  std::optional<double> bend(double distance, double slack) const;
  Eigen::Vector3d joints(double yaw, double out, double down, double tibia_angle) const;
};

}  // namespace foothold::kinematics
