// One stride's motion, with a bound of the effort: what plan_motion() and plan_motions() share.
#pragma once

#include "hyrecro/motion/clear_way.hpp"
#include "hyrecro/motion/motion.hpp"

namespace foothold::hyrecro {

struct Effort {
  bool whole_begin = true, whole_end = true;  // the whole robot may move to lift the foot, see rise()
  bool search = true;                         // RRTConnect may be used
};

// See plan_motion().
MotionResult move(const Surroundings& around, const Coordinates& from, const Coordinates& to, bool free_lifts,
                  const MotionOptions& options, const Effort& effort, std::mt19937_64& random);

}  // namespace foothold::hyrecro
