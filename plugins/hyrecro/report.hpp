// What a plan of HyReCRo says of its quality, or why there is none.
#pragma once

#include "hyrecro/request.hpp"

namespace foothold::hyrecro {

// Milliseconds of a plan's parts.
struct PlanTimes {
  double search = 0.0, motion = 0.0;
};

// Of a route that was found and sent, `strides` long in all. Any thread.
PlanReport report_of(const Found& found, const Options& options, const truss::Truss& truss, const PlanTimes& times);
// Why there is none. Any thread.
PlanReport failed_report(const Failure& failure);

}  // namespace foothold::hyrecro
