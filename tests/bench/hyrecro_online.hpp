// HyReCRo's plans as a host asks for them, timed: from the request to the last step handed over.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "hyrecro/planner.hpp"

namespace foothold::bench {

// The defaults of the schema with some values set as text.
Parameters hyrecro_parameters(const std::map<std::string, std::string>& set = {});

// One foot on `start`, the other in the air, to `goal`.
Request hyrecro_request(const Isometry3d& start, const Isometry3d& goal);

// On the paper's crossed beams: from the long beam's top over the short beam's side that stands in the way to the side round its
// corner, so two transitions and three faces. Starts, goals and headings vary with a fixed seed; footholds lie on the 0.01 m
// lattice.
std::vector<Request> crossed_beams_requests(int count);

struct Timed {
  double ms = 0.0;
  PlanReport report;
  std::size_t steps = 0;
};

// Plans once, for request.budget at most; the steps are counted and dropped. Used by one thread.
Timed timed_plan(hyrecro::HyrecroPlanner& planner, const Request& request, const Parameters& parameters,
                 const PreparedScene& scene);

// Resident memory of this process, MB.
double resident_mb();

}  // namespace foothold::bench
