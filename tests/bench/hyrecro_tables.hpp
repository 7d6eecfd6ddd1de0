// The paper's tables 1 and 2 and its figure 11, measured with `method: paper` and printed beside what the paper prints.
#pragma once

#include <vector>

#include "figures.hpp"

namespace foothold::bench {

// Prints to stdout; means of 100 repetitions as in the paper, of 5 if quick.
std::vector<Figure> hyrecro_tables(bool quick);

}  // namespace foothold::bench
