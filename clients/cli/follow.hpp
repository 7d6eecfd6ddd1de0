// Follows a plan to its end on the terminal, and cancels it on Ctrl-C.
#pragma once

#include "connection.hpp"

namespace foothold::cli {

struct Following {
  bool verbose = false;
  bool show_steps = true;
  double patience = 0.0;  // s after which a plan that has not ended is given up
};

// Prints each step as it arrives (with --json: one line of JSON each) and what happens on the way. Throws Complaint when the server
// is lost for longer than --timeout, or when the plan is given up; it may then still be running.
msg::PlanEvent follow(client::Plan& plan, const Common& common, const Following& following);

}  // namespace foothold::cli
