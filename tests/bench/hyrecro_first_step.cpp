// See hyrecro_first_step.hpp.
#include "hyrecro_first_step.hpp"

#include <chrono>
#include <stdexcept>

#include "daemon.hpp"
#include "foothold/client/client.hpp"
#include "foothold/client/request_file.hpp"

namespace foothold::bench {

std::vector<double> first_steps(const std::string& vendor, bool motion, int count) {
  constexpr std::uint32_t kDomain = 41;
  test::Daemon daemon({.vendor = vendor,
                       .domain = kDomain,
                       .robots = {{.name = "hyrecro", .file = FOOTHOLD_CONFIG_DIR "/robots/hyrecro.yaml"}},
                       .log_level = "warn",
                       .more = "scenes: {preload: [" FOOTHOLD_CONFIG_DIR "/scenes]}\n",
                       .plugin_dir = FOOTHOLD_PLUGINS});
  client::Client client({.vendor = vendor, .domain = kDomain, .network_config = {}});
  if (!client.wait_for_robot("hyrecro", 20.0) || !client.wait_for_server(20.0))
    throw std::runtime_error("no server: " + daemon.log());
  msg::PlanRequest request = client::read_request_file(FOOTHOLD_CONFIG_DIR "/requests/hyrecro-crossed-beams.yaml").request;
  request.shapes(false);
  std::erase_if(request.parameters(), [](const msg::Parameter& parameter) { return parameter.name() == "motion"; });
  msg::Parameter with_motion;
  with_motion.name("motion");
  with_motion.value(motion ? "true" : "false");
  request.parameters().push_back(with_motion);

  std::vector<double> out;
  for (int k = -3; k < count; ++k) {
    const auto begin = std::chrono::steady_clock::now();
    client::Plan plan = client.submit(request);
    const bool stepped = plan.next(20.0) != nullptr;
    const double ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    const auto end = plan.wait(20.0);
    if (!stepped || !end || end->state() != msg::SUCCEEDED) throw std::runtime_error("a plan did not succeed");
    if (k >= 0) out.push_back(ms);
  }
  return out;
}

}  // namespace foothold::bench
