// Client processes that keep a server busy for a while and tell how long each plan took.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "daemon.hpp"
#include "peer.hpp"

namespace foothold::bench {

// What one client does: `at_once` plans of the planner `many` under way, each of `steps` steps; `pause` s after each plan.
struct Habit {
  std::uint32_t at_once = 1, steps = 5;
  double pause = 0.0;
};

struct Measured {
  double seconds = 0.0;
  std::vector<double> latencies;  // ms, from submit() until the final event and every step
  double rate() const { return static_cast<double>(latencies.size()) / seconds; }
};

// Clients of both vendors in turns. Thread rule: the main thread.
class Clients {
 public:
  // Waits until all have found the server. Throws std::runtime_error.
  Clients(std::uint32_t count, std::uint32_t domain, const std::string& robot, const Habit& habit);
  // All of them work for `seconds` at the same time. Throws std::runtime_error if a plan fails or a client does not answer.
  Measured work(double seconds);

 private:
  std::vector<std::unique_ptr<test::Peer>> peers_;
};

// main() of such a client: bench_service --client VENDOR DOMAIN ROBOT AT_ONCE STEPS PAUSE.
int client_main(int count, char** words);

// MiB of resident memory: of the server, and of its workers together.
struct Resident {
  double server = 0.0, workers = 0.0;
};
Resident resident(const test::Daemon& daemon);

}  // namespace foothold::bench
