// From what plan() says of itself to what the daemon is told. A report that contradicts itself is not passed on: its request ends
// FAILED / WORKER_PROTOCOL with a sentence that holds the values.
#pragma once

#include <optional>
#include <string>

#include "foothold/planner.hpp"
#include "worker.h"

namespace foothold::server {

// A sentence, or nothing if the report is one that a planner may give (planner.hpp, PlanReport). `ended`: it was told to stop, by
// the stop token or by emit().
std::optional<std::string> contradiction(const PlanReport& report, bool ended);

// State, error, and the part of the summary that the planner knows.
frame::Report to_report(const PlanReport& report, bool ended);

// FAILED with this error and nothing else.
frame::Report failed(msg::Error error);

}  // namespace foothold::server
