// A whole client: asks for a plan, prints each foothold as it arrives, and says how good the plan is.
// Usage: plan_and_print [DOMAIN [cyclone|fastdds]]
#include <cstdio>
#include <cstdlib>

#include "foothold/client/client.hpp"

namespace msg = foothold::msg;

int main(int argc, char** argv) {
  const unsigned domain = argc > 1 ? static_cast<unsigned>(std::atoi(argv[1])) : 0;
  foothold::client::Client client({.vendor = argc > 2 ? argv[2] : "cyclone", .domain = domain, .network_config = ""});
  if (!client.wait_for_robot("xrobin", 10.0)) {
    std::fprintf(stderr, "no server plans for xrobin in domain %u\n", domain);
    return 1;
  }

  msg::Pose goal;
  goal.position().x(0.2);
  goal.position().y(0.2);
  goal.orientation().w(1.0);

  msg::PlanRequest request;
  request.robot("xrobin");
  request.goal().base({goal});
  request.goal().any_orientation(true);
  request.budget(20.0);  // s, of which a planner's first request takes some to make its tables

  foothold::client::Plan plan = client.submit(request);
  for (const msg::Step& step : plan) {  // each as soon as it is there, in order, without gaps
    const msg::Contact& foothold = step.placed().front();
    std::printf("%2u  %s at (%.4f, %.4f) m  %s\n", step.index(), foothold.limb().c_str(), foothold.frame().position().x(),
                foothold.frame().position().y(), step.label().c_str());
  }
  const msg::PlanEvent end = *plan.wait();
  std::printf("%s, cost %g %s, %s\n", end.state() == msg::SUCCEEDED ? "goal reached" : end.error().message().c_str(),
              end.summary().cost(), end.summary().cost_unit().c_str(),
              end.summary().optimal() ? "proved least" : "not proved least");
  return end.state() == msg::SUCCEEDED ? 0 : 1;
}
