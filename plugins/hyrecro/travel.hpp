// From where the robot stands to its goal: footholds that a search finds, and the motions between them; where a stride has no
// motion the search goes round it.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "hyrecro/motion/motion.hpp"
#include "hyrecro/planner.hpp"
#include "hyrecro/report.hpp"

namespace foothold::hyrecro {

// The search of a method from one grip to the goal.
using Search = std::function<Found(const Options& options, const Grip& from)>;

struct Travel {
  bool stopped = false;
  std::optional<Found> found;   // empty: `failure` says why, unless stopped
  Beginning beginning;          // which foot stays first
  std::vector<Motion> motions;  // one for each stride, if asked for
  Failure failure;
  PlanTimes times;
};

// Searches from every beginning and takes the cheapest. With motions: a stride without one is banned and the search done again, a
// bounded number of times (optimal only). What was proved without bans stays the lower bound. Threads as the search's.
Travel plan_travel(const Model& model, const PreparedTruss& scene, const Options& options, const std::vector<Beginning>& from,
                   const Search& search, PlanContext& context);

// Cost of the plan up to and with each stride. Any thread.
std::vector<double> costs_of(const Found& found, const Options& options, const truss::Truss& truss);

}  // namespace foothold::hyrecro
