// A client process of its own, for tests that kill or halt it: submits one request of a paced plan, says how many steps it has
// after each step, and ends with the state's number as its exit code.
//
// lone_client VENDOR DOMAIN ID ROBOT STEPS PAUSE
#include <string>

#include "foothold/client/client.hpp"
#include "planners.hpp"

int main(int argc, char** argv) {
  if (argc != 7) return 64;
  namespace msg = foothold::msg;
  foothold::client::Client client({argv[1], static_cast<std::uint32_t>(std::stoul(argv[2])), {}});
  if (!client.wait_for_robot(argv[4], 20.0)) return 65;
  msg::PlanRequest request =
      foothold::test::paced_request(argv[4], static_cast<std::uint32_t>(std::stoul(argv[5])), std::stod(argv[6]));
  request.id(msg::id_from_hex(argv[3]).value());
  foothold::client::Plan plan = client.submit(request);
  std::uint32_t expected = 0;
  for (const msg::Step& step : plan)
    if (step.index() != expected++) return 66;
  return static_cast<int>(plan.wait()->state());
}
