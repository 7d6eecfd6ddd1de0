// One cycle of Xrobin as a module of the hyper-redundant arm that is equivalent to it (the paper's section 3).
#pragma once

#include <cstdint>
#include <vector>

#include "word.hpp"

namespace foothold::xrobin {

// What a cycle does: body A's pose after it in the frame before it. `words` of the 64 pairs of configurations do just this;
// `first` and `second` are the pair with the least numbers.
struct Module {
  PlanarPose end;
  double cosine = 1.0;
  double sine = 0.0;
  double words = 1.0;
  std::uint8_t first = 1;
  std::uint8_t second = 1;
};

// All cycles with different ends: 55 with the printed lengths.
std::vector<Module> modules(const Mechanism& mechanism);

}  // namespace foothold::xrobin
