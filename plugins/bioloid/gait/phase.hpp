// Phases of a step: a path of the joints in one support, timed, sampled and certified line by line. What is certified is what is
// sent. Radians, seconds; any thread, each with its own Judge.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "bioloid/gait/timing.hpp"
#include "bioloid/posture/judge.hpp"

namespace foothold::bioloid {

struct Phase {
  const char* name = "";  // shift, lift, carry, lower, settle
  Support support;
  unsigned ground = 0;         // as Judge::motion, for the phase's ends
  std::vector<Joints> points;  // the lines between neighbours are certified
  std::vector<double> times;   // s from the phase's begin, one a point
  Fault fault = Fault::kNone;  // why it is none, if it is none; `points` ends where it fails
  bool sound() const { return fault == Fault::kNone; }
};

// Samples a path within `pace` and certifies it. Where a line between samples slips or cannot be shown to be sound, samples of the
// path are put in between, down to 1/16 of a period. A path with a gap: kLimit. `ground`: as Judge::motion, for the path's ends.
Phase make_phase(const char* name, const Model& model, Judge& judge, const Support& support, const JointPath& path,
                 const Pace& pace, unsigned ground);

// Certified again in another place or by another judge. Gives the first fault.
Fault certify(Judge& judge, const Phase& phase, const Support& support);
// Certified against the judge's obstacles alone, in another place, of what was certified without them.
bool clears(Judge& judge, const Phase& phase, const Support& support);

// The same way backwards in the same time.
Phase reversed(const Phase& phase);

double duration(std::span<const Phase> phases);  // s

}  // namespace foothold::bioloid
