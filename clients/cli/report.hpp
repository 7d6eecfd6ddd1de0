// A plan for people: one line a step, then how it ended and how good it is.
#pragma once

#include <string>

#include "foothold/client/plan_record.hpp"

namespace foothold::cli {

// "   3   12.4 ms  label  left at (0.1000, 0.0500, 0.0000) m, 45 deg". `seconds`: since the request was sent; below 0: not shown.
// With `verbose` contacts, joints, attributes and margins follow on lines of their own. `label_width` is the widest label so far:
// what follows a label stands in a column.
void print_step(const msg::Step& step, double seconds, bool verbose, std::size_t& label_width);

// The state, the times, the cost with its bound, the planner's figures, the error. `again`: the command that gives the plan again,
// or empty.
void print_end(const msg::PlanEvent& event, const std::string& again = {});

// "(0.100, 0.050, 0.000) m, 45 deg": a pose that stands upright is told by its heading, any other by roll, pitch and yaw.
std::string describe(const msg::Pose& pose);

// A word as a shell takes it.
std::string quoted(const std::string& word);

}  // namespace foothold::cli
