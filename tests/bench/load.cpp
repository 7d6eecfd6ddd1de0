// See load.hpp.
#include "load.hpp"

#include <unistd.h>

#include <atomic>
#include <chrono>
#include <memory>
#include <semaphore>
#include <stdexcept>
#include <vector>

#include "peer.hpp"

namespace foothold::bench {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double kPatience = 20.0;  // s

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

}  // namespace

msg::PlanRequest many_request(std::uint32_t steps) {
  msg::PlanRequest request;
  request.robot("many");
  request.budget(60.0);
  msg::Parameter parameter;
  parameter.name("steps");
  parameter.value(std::to_string(steps));
  request.parameters().push_back(parameter);
  return request;
}

double run_load(client::Client& client, const Load& load) {
  std::counting_semaphore<> room(load.at_once);
  std::atomic<std::uint64_t> steps = 0;
  std::atomic<std::uint32_t> succeeded = 0;
  const auto take_room = [&] {
    if (!room.try_acquire_for(std::chrono::duration<double>(kPatience))) throw std::runtime_error("no plan ended for 20 s");
  };
  const client::PlanCallbacks callbacks{.on_step = [&](const msg::Step&) { ++steps; },
                                        .on_event =
                                            [&](const msg::PlanEvent& event) {
                                              if (event.state() == msg::RUNNING || event.state() == msg::QUEUED) return;
                                              if (event.state() == msg::SUCCEEDED) ++succeeded;
                                              room.release();
                                            }};
  const msg::PlanRequest request = many_request(load.steps);
  const auto begin = Clock::now();
  for (std::uint32_t plan = 0; plan < load.plans; ++plan) {
    take_room();
    client.submit(request, callbacks);
  }
  for (std::uint32_t plan = 0; plan < load.at_once; ++plan) take_room();
  const double seconds = seconds_since(begin);
  if (succeeded != load.plans || steps != std::uint64_t{load.plans} * load.steps)
    throw std::runtime_error("of " + std::to_string(load.plans) + " plans " + std::to_string(succeeded) + " succeeded, with " +
                             std::to_string(steps) + " steps");
  return seconds;
}

double run_load(const std::string& vendor, std::uint32_t domain, const Load& load, std::uint32_t clients) {
  std::vector<std::unique_ptr<test::Peer>> peers;
  for (std::uint32_t i = 0; i < clients; ++i)
    peers.push_back(std::make_unique<test::Peer>(std::vector<std::string>{"bench_wire", "--load", vendor, std::to_string(domain),
                                                                          std::to_string(load.plans), std::to_string(load.steps),
                                                                          std::to_string(load.at_once)}));
  for (const auto& peer : peers)
    if (!peer->wait_number(test::Kind::kMatched, 1)) throw std::runtime_error("a client process found no server");
  const auto begin = Clock::now();
  for (const auto& peer : peers) peer->send({});
  for (const auto& peer : peers)
    if (!peer->wait_number(test::Kind::kMatched, 2, 60.0)) throw std::runtime_error("a client process did not come to its end");
  return seconds_since(begin);
}

int load_main(int count, char** words) {
  if (count != 7) return EXIT_FAILURE;
  const auto number = [&](int word) { return static_cast<std::uint32_t>(std::stoul(words[word])); };
  client::Client client({.vendor = words[2], .domain = number(3), .network_config = {}});
  if (!client.wait_for_robot("many", kPatience) || !client.wait_for_server(kPatience)) return EXIT_FAILURE;
  test::put_number(STDOUT_FILENO, test::Kind::kMatched, 1);
  test::get_frame(STDIN_FILENO);
  run_load(client, {number(4), number(5), number(6)});
  test::put_number(STDOUT_FILENO, test::Kind::kMatched, 2);
  return EXIT_SUCCESS;
}

}  // namespace foothold::bench
