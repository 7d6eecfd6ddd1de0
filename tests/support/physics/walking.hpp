// The independent judge of walks: a walker of rigid bodies and position servos plays a motion in MuJoCo, its base free, on a floor.
// Does it end standing, and where?
//
// The engine knows bodies, masses, boxes, axes and the servos' stiffness and torque; it knows nothing of soles, supports and
// margins. Contacts as in frozen.hpp; bodies that are not excluded from each other touch each other too. Metres, radians,
// kilograms, newtons. Any thread.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <utility>
#include <vector>

namespace foothold::physics {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using Eigen::VectorXd;

struct WalkerBox {
  Vector3d centre = Vector3d::Zero();  // in the link's frame; axes parallel to it
  Vector3d half = Vector3d::Zero();
};

// Frames are parallel in the zero pose; a link's origin lies on its joint.
struct WalkerLink {
  std::string name;
  int parent = -1;                     // index of an earlier link; the first is the free base and has none
  Vector3d origin = Vector3d::Zero();  // in the parent's frame
  Vector3d axis = Vector3d::UnitZ();   // unit; the joint turns about it by the right hand
  double mass = 0.0;
  Vector3d centre_of_mass = Vector3d::Zero();
  std::vector<WalkerBox> boxes;  // inertia is that of a solid one like the first; a link without is a ball of 10 mm
};

struct Walker {
  std::vector<WalkerLink> links;              // joint k moves links[k + 1]
  std::vector<std::pair<int, int>> excluded;  // links that never touch each other
};

// What a servo does: torque = stiffness (target - angle) - damping speed, cut off at `torque`.
struct Servo {
  double stiffness = 60.0;  // N m/rad: 0.5 N m, a knee's in a crouch, gives way by half a degree
  double damping = 1.2;     // N m s/rad: near critical with the armature
  double torque = 1.5;      // N m, stall of an AX-12 at 12 V (maker's data)
  double armature = 0.006;  // kg m^2, the gear's and motor's inertia seen from the joint (assumed)
};

struct WalkOptions {
  Servo servo;
  double friction = 0.8;    // of soles on the floor, and of bodies on each other (assumed)
  double speed = 0.7;       // rad/s of the fastest joint between two postures: quasi-static
  double settling = 0.5;    // s before the motion begins
  double rest = 1.0;        // s after it has ended
  double timestep = 0.001;  // s
};

// Joint angles one after the other; straight in the joints between them.
using JointPath = std::vector<VectorXd>;
struct TimedPosture {
  double time = 0.0;  // s, of the motion; ascending
  VectorXd joints;
};

struct Walked {
  Isometry3d base = Isometry3d::Identity();  // at the end, world
  std::vector<Isometry3d> links;             // at the end, world
  double time = 0.0;                         // s of motion
  double greatest_tilt = 0.0;                // rad, of the base's Z axis against the vertical, at any time
  double speed = 0.0;                        // m/s, of the base at the end
  double torque = 0.0;                       // N m, greatest of any servo
  double touch = 0.0;                        // m, deepest that two links went into each other
  std::string touching;                      // those two
  bool floor = false;                        // something else than the feet touched the floor

  // Has turned over, or is on its way.
  bool fell() const { return greatest_tilt > 0.8 || speed > 0.02 || floor; }
};

// Is at rest on its feet at the end, its base no farther than `distance` (m) and no more turned than `angle` (rad) from `goal`.
bool stands_at(const Walked& walked, const Isometry3d& goal, double distance, double angle);

// Begins with the base at `base` and the first posture, plays the motion, rests. `feet`: links that may touch the floor, which is
// the plane z = 0.
// Throws std::runtime_error for a walker that MuJoCo refuses, or postures of another number of joints.
Walked walk(const Walker& walker, const std::vector<int>& feet, const Isometry3d& base, const JointPath& path,
            const WalkOptions& options = {});
Walked walk(const Walker& walker, const std::vector<int>& feet, const Isometry3d& base, const std::vector<TimedPosture>& motion,
            const WalkOptions& options = {});

}  // namespace foothold::physics
