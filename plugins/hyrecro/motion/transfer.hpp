// From one lifted posture to another, free of collisions: straight, by way of postures in closed form, else by RRTConnect.
#pragma once

#include <optional>
#include <random>
#include <string>
#include <vector>

#include "hyrecro/motion/clear_way.hpp"

namespace foothold::hyrecro {

struct Transfer {
  std::vector<Actuators> points;  // first is `a`, last is `b` or `b` with a whole turn more or less in the hips
  bool searched = false;          // RRTConnect was needed
};

// `b`'s hips may be reached in either direction. RRTConnect is used if `search` and no way in closed form is free. Empty, with a
// sentence in `reason`, if none was found.
std::optional<Transfer> transfer(const Surroundings& around, const Actuators& a, const Actuators& b, bool search,
                                 std::mt19937_64& random, std::string& reason);

// OMPL's RRTConnect in the ten actuators (measured by the time that they take), edges proved by judge_way(). Draws from `random`
// alone, so it repeats itself. Gives up after `most_judged` postures. Thread rule of Surroundings.
std::optional<std::vector<Actuators>> connect(const Surroundings& around, const Actuators& a, const std::vector<Actuators>& goals,
                                              long most_judged, std::mt19937_64& random);

// The same way with corners cut off wherever that is free and takes less time. `tries`: how often two places are drawn.
void shorten(const Surroundings& around, int tries, std::mt19937_64& random, std::vector<Actuators>& way);

}  // namespace foothold::hyrecro
