// The posture of greatest NESM on given footholds: branch and bound over a grid of thorax poses, with a proof, then polished.
//
// Metres, radians, world frame. Values; any thread.
#pragma once

#include <limits>
#include <stop_token>

#include "hexpiderix/strategies/strategies.hpp"

namespace foothold::hexpiderix {

// Poses are counted from the standing pose over the supports: origin over their mean, Z along the ground's normal, X the heading.
// Each range is [low, high] in `step`s from low on.
struct PoseGrid {
  struct Range {
    double low, high, step;
    int count() const;  // of grid values, at least 1
    double at(int index) const { return low + index * step; }
  };
  Range along{-0.06, 0.06, 0.02}, across{-0.06, 0.06, 0.02}, height{0.02, 0.16, 0.02};  // m; of the coxa axes over the ground
  Range roll{-0.6, 0.6, 0.2}, pitch{-0.6, 0.6, 0.2}, yaw{0.0, 0.0, 0.1};                // rad
};

struct BestOptions {
  PoseGrid grid;
  double friction = std::numeric_limits<double>::infinity();  // postures that need more are none
  long most_boxes = 10'000'000;
};

struct BestPosture {
  enum class End { kProved, kNone, kExhausted, kStopped };
  End end = End::kNone;  // kNone: no pose of the grid is a posture
  Evaluation on_grid;    // greatest NESM of all poses of the grid, proved if kProved
  Evaluation polished;   // from there uphill between the grid's poses
  long boxes = 0, evaluated = 0;
};

// `from`: ground, footholds and clearance; its thorax gives the heading. Swing legs are raised where the ground demands it.
BestPosture best_posture(const Model& model, const Situation& from, const BestOptions& options, const std::stop_token& stop);

// Is there a posture with a positive NESM at all, anywhere within the grid's ranges, on the grid or between?
struct Existence {
  enum class Answer { kFound, kProvedNone, kUnknown };
  Answer answer = Answer::kUnknown;
  Evaluation found;
  long boxes = 0;
};
Existence stable_posture(const Model& model, const Situation& from, const BestOptions& options, const std::stop_token& stop);

}  // namespace foothold::hexpiderix
