// From a stance to the posture with the free foot lifted, free of collisions.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hyrecro/motion/clear_way.hpp"
#include "hyrecro/motion/motion.hpp"

namespace foothold::hyrecro {

// The foot is lifted by a tenth more than asked for, so that who samples a motion sees it leave the line above the height asked
// for.
inline constexpr double kLiftFactor = 1.1;

// Straight between the postures; first is the stance, last has the free sole kLiftFactor `options.lift` above its place. By leg 1
// alone, see lift(); where that has no room or something is in the way, and if `whole`, by the whole robot, see slide(): to the
// nearest posture above for which the way is free. Empty, with a sentence in `reason`, if there is none.
std::optional<std::vector<Coordinates>> rise(const Surroundings& around, const Coordinates& stance, const MotionOptions& options,
                                             bool whole, std::string& reason);

}  // namespace foothold::hyrecro
