// The words: title and legend.
#pragma once

#include <string>
#include <vector>

#include "view.hpp"

namespace foothold::drawing {

// The headline (robot and state), then what the plan is and costs, what made it, and what went wrong.
std::vector<std::string> title_lines(const Drawing& drawing, const Plan& plan);

// Entries side by side in lines of `width` from (left, top) on, for what this plan shows. Returns the height; with no `svg` it only
// measures.
double draw_legend(Svg* svg, const Plan& plan, const Hues& hues, const std::vector<Crossing>& crossings, double left, double top,
                   double width);

}  // namespace foothold::drawing
