// What a plan of Hex-piderix says of its quality, or why there is none.
#pragma once

#include "hexpiderix/adapt/adapt.hpp"
#include "hexpiderix/request.hpp"

namespace foothold::hexpiderix {

// `time`: ms of the search. Any thread.
PlanReport found_report(const Model& model, const Adaption& found, const Start& from, const Options& options, double time);
PlanReport failed_report(const Adaption& found);
// Of a walk; the cost is the thorax' way, the bound the straight line. Any thread.
PlanReport walked_report(const Model& model, const Walk& found, const Stand& from, const Station& goal, const Options& options,
                         double time);
PlanReport blocked_report(const Walk& found);

}  // namespace foothold::hexpiderix
