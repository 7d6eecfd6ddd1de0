// A client that keeps footholdd busy: many plans at once, each checked for its steps and its end.
#pragma once

#include <cstdint>
#include <string>

#include "foothold/client/client.hpp"

namespace foothold::bench {

struct Load {
  std::uint32_t plans = 0;    // in all
  std::uint32_t steps = 1;    // of each
  std::uint32_t at_once = 1;  // requests that are not answered yet
};

// A request to the test planner `many`, which returns at once with that many steps.
msg::PlanRequest many_request(std::uint32_t steps);

// Sends all plans and waits for all of their steps and ends; gives the seconds. Throws std::runtime_error if a plan does not
// succeed with all of its steps, or nothing arrives for 20 s.
double run_load(client::Client& client, const Load& load);

// The same by `clients` processes of this vendor at the same time; this process only starts and stops the watch.
double run_load(const std::string& vendor, std::uint32_t domain, const Load& load, std::uint32_t clients);

// main() of such a process: bench_wire --load VENDOR DOMAIN PLANS STEPS AT_ONCE.
int load_main(int count, char** words);

}  // namespace foothold::bench
