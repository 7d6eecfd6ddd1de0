// One cycle of Xrobin as a module of the hyper-redundant arm that is equivalent to it (the paper's section 3).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "word.hpp"

namespace foothold::xrobin {

// What a cycle does: body A's pose after it in the frame before it.
struct Module {
  PlanarPose end;
  double cosine = 1.0;
  double sine = 0.0;
  std::vector<std::array<std::uint8_t, 2>> pairs;  // of configurations that do just this; the least numbers first
};

// All cycles with different ends: 55 with the printed lengths.
std::vector<Module> modules(const Mechanism& mechanism);

}  // namespace foothold::xrobin
