// Masses, lengths and axes as published, in grams and millimetres.
#include "kdl_robot.hpp"

#include <kdl/tree.hpp>
#include <string>

namespace foothold::bioloid::testing {
namespace {

struct Link {
  int servo;       // of the right side; the left one's is one more
  int carrier;     // servo that carries it; 0: the torso
  double at[3];    // from the carrier's joint, right side, X forward, Y left, Z up, mm
  double axis[3];  // of the servo
  double mass;     // g
  double centre[3];
};

constexpr Link kLinks[] = {
    {1, 0, {0, -47, 89.5}, {0, 1, 0}, 11.9, {0, -14.5 / 2, 0}},
    {3, 1, {0, -14.5, 0}, {1, 0, 0}, 76.5, {0, -(25 + 67.5) / 2, 0}},
    {5, 3, {0, -(25 + 67.5), 0}, {1, 0, 0}, 76.7, {0, -74.5 / 2, 0}},
    {7, 0, {0, -38.5, -31}, {0, 0, 1}, 15.1, {-17.59, 0, -8}},
    {9, 7, {0, 0, 0}, {1, 0, 0}, 137, {-16.04, 0, 15.03}},
    {11, 9, {0, 0, 0}, {0, 1, 0}, 31.2, {-1.22, 0, -44.37}},
    {13, 11, {-14.5, 0, -75}, {0, -1, 0}, 86.7, {15.24, 0, -11.09}},
    {15, 13, {14.5, 0, -75}, {0, -1, 0}, 137, {-16.04, 0, -15.03}},
    {17, 15, {0, 0, 0}, {1, 0, 0}, 37.4, {-11.17, -5.66, -27.09}},
};

KDL::Vector millimetres(const double (&v)[3], bool left) { return {1e-3 * v[0], (left ? -1e-3 : 1e-3) * v[1], 1e-3 * v[2]}; }

std::string named(int servo) { return servo == 0 ? "torso" : "s" + std::to_string(servo); }

Eigen::Isometry3d eigen(const KDL::Frame& frame) {
  Eigen::Isometry3d out = Eigen::Isometry3d::Identity();
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 3; ++c) out.linear()(r, c) = frame.M(r, c);
    out.translation()[r] = frame.p(r);
  }
  return out;
}

}  // namespace

struct KdlRobot::Tree {
  KDL::Tree tree{"torso"};
};

KdlRobot::KdlRobot() : tree_(new Tree) {
  for (const Link& link : kLinks)
    for (const bool left : {false, true}) {
      const int servo = link.servo + left;
      const KDL::Vector at = millimetres(link.at, left);
      const KDL::Joint joint(named(servo), at, KDL::Vector(link.axis[0], link.axis[1], link.axis[2]), KDL::Joint::RotAxis);
      const KDL::RigidBodyInertia inertia(1e-3 * link.mass, millimetres(link.centre, left));
      tree_->tree.addSegment(KDL::Segment(named(servo), joint, KDL::Frame(at), inertia),
                             named(link.carrier == 0 ? 0 : link.carrier + left));
    }
}

KdlRobot::~KdlRobot() { delete tree_; }

KdlRobot::State KdlRobot::state(const std::vector<double>& servos) const {
  State out;
  out.frames[0].setIdentity();
  out.mass = 0.6954;
  Eigen::Vector3d moment = out.mass * Eigen::Vector3d(-0.01827, -0.00171, 0.06655);
  for (const Link& link : kLinks)
    for (const bool left : {false, true}) {
      const auto servo = static_cast<std::size_t>(link.servo + left);
      const auto carrier = static_cast<std::size_t>(link.carrier == 0 ? 0 : link.carrier + left);
      const KDL::Segment& segment = tree_->tree.getSegment(named(static_cast<int>(servo)))->second.segment;
      out.frames[servo] = out.frames[carrier] * eigen(segment.pose(servos[servo - 1]));
      const KDL::RigidBodyInertia& inertia = segment.getInertia();
      const KDL::Vector centre = inertia.getCOG();
      moment += inertia.getMass() * (out.frames[servo] * Eigen::Vector3d(centre.x(), centre.y(), centre.z()));
      out.mass += inertia.getMass();
    }
  out.centre_of_mass = moment / out.mass;
  return out;
}

}  // namespace foothold::bioloid::testing
