// Paths of a single support in the nine free joints (and the swing sole's heading, where the robot turns): a polyline from lift-off
// to touch-down. Straight lines between key postures where they are free; else a bidirectional search (RRT-Connect: Kuffner and
// LaValle, 2000) and shortening. Radians; any thread, each with its own Judge.
#pragma once

#include <random>
#include <span>
#include <stop_token>
#include <vector>

#include "bioloid/gait/timing.hpp"
#include "bioloid/posture/judge.hpp"
#include "bioloid/posture/nine.hpp"

namespace foothold::bioloid {

// The nine free joints and the swing sole's heading against the supporting one.
using Free = Eigen::Matrix<double, 10, 1>;

Free to_free(const Model& model, Side support, const Joints& joints);
bool from_free(const Model& model, Side support, const Free& free, Joints& joints);

// The line from a to b in the free joints, all joints by coupling.
JointPath swing_line(const Model& model, Side support, const Free& a, const Free& b);

// True if the line can be followed: sampled so that no joint moves more than `grain` (rad) between samples, every line between
// samples certified. `ground`: as Judge::motion, for a and b.
bool free_line(const Model& model, Judge& judge, const Support& support, const Free& a, const Free& b, unsigned ground,
               double grain = 0.05);

struct SearchOptions {
  int most_nodes = 4000;  // of both trees
  int most_tries = 8000;  // to make them grow
  double reach = 0.3;     // rad, of one extension at most
  int shortening = 60;    // random shortcuts tried
};

// Free joints from a to b, both included; empty if none was found. Both ends are in the air. Deterministic for a state of `random`.
std::vector<Free> connect(const Model& model, Judge& judge, const Support& support, const Free& a, const Free& b,
                          const SearchOptions& options, std::mt19937_64& random, std::stop_token stop);

// Sum over the joints of the ways that they turn, rad.
double travel(std::span<const Joints> points);

}  // namespace foothold::bioloid
