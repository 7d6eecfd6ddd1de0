// Poses with the answer of exact reachability, asked from either foot: what the perceptrons learn from and are measured against.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "hyrecro/reach/accuracy.hpp"
#include "hyrecro/reach/poses.hpp"

namespace foothold::hyrecro {

struct LabelOptions {
  PoseKind kind = PoseKind::kFace;
  double clearance = 0.005;  // m, between the robot's bodies
  double radius = 0.0;       // m, of the ball or disc of poses, see random_pose()
  std::size_t count = 0;
  std::uint64_t seed = 1;
  unsigned threads = 1;
};

// The same poses and labels for any number of threads. `done` is called from time to time with how many are labelled; by one thread
// at a time. Blocks until all are done.
std::vector<Sample> labelled(const Model& model, const LabelOptions& options, const std::function<void(std::size_t)>& done = {});

}  // namespace foothold::hyrecro
