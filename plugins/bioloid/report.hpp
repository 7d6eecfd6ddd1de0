// What a plan of Bioloid says of its quality, or why there is none.
#pragma once

#include "bioloid/request.hpp"

namespace foothold::bioloid {

// `time`: ms of the search. `stand`: how the robot began. Any thread.
PlanReport walked_report(const Model& model, const Walk& walk, const Stand& stand, const Options& options,
                         const PaperFigures& paper, double time);
PlanReport failed_report(const Walk& walk, const Options& options);

}  // namespace foothold::bioloid
