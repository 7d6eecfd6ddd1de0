// The motion of a step, judged over its whole course.
//
// Between two points of the motion the base turns about a fixed axis and moves straight, and the joints are linear. All that is
// judged there is bounded from the two ends, and the piece is halved where that does not do:
// - A foot that is on its contact at both ends carries the robot. It is off by no more than its bulge (Ways), 1 mm at most. The
// foot comes
//   from outside, and does not cut other ground: both change by no more than the way of the foot.
// - A foot in the air keeps off the ground, by its distances at the ends less its way. Where it leaves or meets its contact it
// rises
//   faster than it can bulge.
// - Bodies and legs keep the clearance from the ground and from each other: by their distances at the ends less their ways.
// - The feet that carry hold the robot at each instant: its centre of mass stays within the bulge of the straight line between the
// ends,
//   and the places where given contacts can hold it are convex, so the corners of two squares decide.
#pragma once

#include "octopod/check/setting.hpp"

namespace foothold::octopod {

inline constexpr double kSlip = 1e-3;  // m, bound of what a carrying foot may be off between two points

struct Course {
  double clearance = 0.0;  // m, least at the points
  double apart = 0.0;      // m, between parts of the robot, least at the points
  double slip = 0.0;       // m, greatest bound
};

// From the posture `before`, whose feet stand at `from`, to that of `step`, whose feet stand at `to`. Refuses with the time.
Course judge_course(const Setting& setting, const Step& step, const Posture& before, const Feet& from, const Feet& to);

// Bodies and legs of one posture, feet but for their soles too: no nearer to the ground than the clearance. Returns the least
// distance.
double judge_clear(const Setting& setting, const Skeleton& at, const std::string& where);

}  // namespace foothold::octopod
