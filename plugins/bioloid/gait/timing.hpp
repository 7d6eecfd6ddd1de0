// Time along a path of joints: at rest at both ends, within a share of the servos' speed, sampled for the servo bus. Seconds and
// radians. Any thread.
#pragma once

#include <functional>

#include "bioloid/model/model.hpp"

namespace foothold::bioloid {

// A path of all joints over [0, 1]; false where there is no posture.
using JointPath = std::function<bool(double, Joints&)>;

struct Pace {
  double share = 0.2;    // of each servo's speed without load, at most
  double period = 0.02;  // s, between samples, at most
};

// The path's parameter at a share of its duration: 3 u^2 - 2 u^3, at rest at both ends.
inline double eased(double u) { return u * u * (3.0 - 2.0 * u); }

// The shortest duration, a whole number of periods, in which no joint is faster than its share along the sampled lines. Negative if
// the path has a gap.
double duration(const Model& model, const JointPath& path, const Pace& pace);

// The longest time that a joint needs for the line between two postures.
double least_time(const Model& model, const Joints& a, const Joints& b, double share);

}  // namespace foothold::bioloid
