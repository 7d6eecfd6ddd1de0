// One plane between two boxes, or between a box and another at two instants. Private to posture/.
#pragma once

#include "collision/distance.hpp"

namespace foothold::bioloid {

inline double least_along(const collision::Box& box, const Eigen::Vector3d& n) {
  return n.dot(box.pose.translation()) - (box.pose.linear().transpose() * n).cwiseAbs().dot(box.half);
}

// True if along one direction n, |n| = 1, there is a gap of `needed` between a and b at both instants. Tries the faces' normals and
// the edges' cross products of either instant: sufficient, and near to necessary where both instants are alike.
bool parted(const collision::Box& a0, const collision::Box& b0, const collision::Box& a1, const collision::Box& b1, double needed);

}  // namespace foothold::bioloid
