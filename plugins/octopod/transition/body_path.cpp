#include "octopod/transition/body_path.hpp"

namespace foothold::octopod {

BodyPath::BodyPath(const Pair& from, const Pair& to) : from_(from), to_(to) {
  for (std::size_t m = 0; m < 2; ++m) {
    const Eigen::AngleAxisd turn(Eigen::Matrix3d(from.turn[m].transpose() * to.turn[m]));
    axis_[m] = turn.axis();
    angle_[m] = turn.angle();
  }
}

Pair BodyPath::at(double part) const {
  if (part <= 0.0) return from_;
  if (part >= 1.0) return to_;
  Pair out;
  out.joint = from_.joint + part * (to_.joint - from_.joint);
  for (std::size_t m = 0; m < 2; ++m)
    out.turn[m] = from_.turn[m] * Eigen::AngleAxisd(part * angle_[m], axis_[m]).toRotationMatrix();
  return out;
}

}  // namespace foothold::octopod
