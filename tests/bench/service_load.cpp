// See service_load.hpp.
#include "service_load.hpp"

#include <unistd.h>

#include <chrono>
#include <cstring>
#include <fstream>
#include <mutex>
#include <semaphore>
#include <stdexcept>
#include <thread>

#include "foothold/client/client.hpp"
#include "load.hpp"

namespace foothold::bench {
namespace {

using Clock = std::chrono::steady_clock;
constexpr double kPatience = 30.0;  // s

double seconds_between(Clock::time_point from, Clock::time_point to) { return std::chrono::duration<double>(to - from).count(); }

// One spell of work of a client process.
std::vector<double> work(client::Client& client, const std::string& robot, const Habit& habit, double seconds) {
  std::mutex mutex;  // of both
  std::vector<double> latencies;
  std::size_t failed = 0;
  std::counting_semaphore<> room(habit.at_once);
  const auto take_room = [&] {
    if (!room.try_acquire_for(std::chrono::duration<double>(kPatience))) throw std::runtime_error("no plan ended for 30 s");
  };
  msg::PlanRequest request = many_request(habit.steps);
  request.robot(robot);
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  while (Clock::now() < end) {
    take_room();
    const auto begin = Clock::now();
    client.submit(request, {.on_event = [&, begin](const msg::PlanEvent& event) {
                    if (event.state() == msg::QUEUED || event.state() == msg::RUNNING) return;
                    {
                      const std::lock_guard lock(mutex);
                      latencies.push_back(1e3 * seconds_between(begin, Clock::now()));
                      failed += event.state() == msg::SUCCEEDED ? 0 : 1;
                    }
                    room.release();
                  }});
    if (habit.pause > 0.0) std::this_thread::sleep_for(std::chrono::duration<double>(habit.pause));
  }
  for (std::uint32_t i = 0; i < habit.at_once; ++i) take_room();
  // The last callback may still hold the lock or the semaphore.
  std::this_thread::sleep_for(std::chrono::milliseconds(10));
  const std::lock_guard lock(mutex);
  if (failed > 0) throw std::runtime_error(std::to_string(failed) + " plans did not succeed");
  return latencies;
}

double status_mib(pid_t pid, const std::string& key) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/status");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with(key)) return std::stod(line.substr(key.size())) / 1024.0;
  return 0.0;
}

}  // namespace

Clients::Clients(std::uint32_t count, std::uint32_t domain, const std::string& robot, const Habit& habit) {
  for (std::uint32_t i = 0; i < count; ++i)
    peers_.push_back(std::make_unique<test::Peer>(
        std::vector<std::string>{"bench_service", "--client", i % 2 == 0 ? "cyclone" : "fastdds", std::to_string(domain), robot,
                                 std::to_string(habit.at_once), std::to_string(habit.steps), std::to_string(habit.pause)}));
  for (const auto& peer : peers_)
    if (!peer->wait_number(test::Kind::kMatched, 1, 60.0)) throw std::runtime_error("a client process found no server");
}

Measured Clients::work(double seconds) {
  std::vector<std::size_t> had;
  for (const auto& peer : peers_) had.push_back(peer->messages().size());
  std::vector<std::byte> order(sizeof seconds);
  std::memcpy(order.data(), &seconds, sizeof seconds);
  const auto begin = Clock::now();
  for (const auto& peer : peers_) peer->send(order);
  Measured out;
  for (std::size_t i = 0; i < peers_.size(); ++i) {
    if (!peers_[i]->wait_messages(had[i] + 1, seconds + 2 * kPatience))
      throw std::runtime_error("a client process gave no figures");
    const std::vector<std::byte> octets = peers_[i]->messages().back();
    std::vector<double> latencies(octets.size() / sizeof(double));
    std::memcpy(latencies.data(), octets.data(), latencies.size() * sizeof(double));
    out.latencies.insert(out.latencies.end(), latencies.begin(), latencies.end());
  }
  out.seconds = seconds_between(begin, Clock::now());
  if (out.latencies.empty()) throw std::runtime_error("no plan was made");
  return out;
}

int client_main(int count, char** words) {
  if (count != 8) return EXIT_FAILURE;
  const std::string robot = words[4];
  const Habit habit{static_cast<std::uint32_t>(std::stoul(words[5])), static_cast<std::uint32_t>(std::stoul(words[6])),
                    std::stod(words[7])};
  client::Client client({.vendor = words[2], .domain = static_cast<std::uint32_t>(std::stoul(words[3])), .network_config = {}});
  if (!client.wait_for_robot(robot, 60.0) || !client.wait_for_server(60.0)) return EXIT_FAILURE;
  test::put_number(STDOUT_FILENO, test::Kind::kMatched, 1);
  while (const auto order = test::get_frame(STDIN_FILENO)) {
    double seconds = 0.0;
    if (order->octets.size() != sizeof seconds) return EXIT_FAILURE;
    std::memcpy(&seconds, order->octets.data(), sizeof seconds);
    const std::vector<double> latencies = work(client, robot, habit, seconds);
    std::vector<std::byte> octets(latencies.size() * sizeof(double));
    std::memcpy(octets.data(), latencies.data(), octets.size());
    test::put_frame(STDOUT_FILENO, test::Kind::kMessage, octets);
  }
  return EXIT_SUCCESS;
}

Resident resident(const test::Daemon& daemon) {
  Resident out{status_mib(daemon.pid(), "VmRSS:"), 0.0};
  for (const pid_t worker : daemon.workers()) out.workers += status_mib(worker, "VmRSS:");
  return out;
}

}  // namespace foothold::bench
