// The way of a request through the whole system, with a planner that returns at once: bench_wire [--quick].
//
// footholdd, its workers, the echo and (for the rates) the clients are processes of their own. For each of the four vendor pairs:
//   echo          round trip of the raw bus between two processes, the same pair in the same run (echo.hpp)
//   first step    from submit() until the thread that waits has the first step, one request after the other
//   end           the same until the final event
//   plans/s       plans of one step, `at once` requests under way, by one client and by several
//   steps/s       plans of many steps
// The latencies are measured in rounds that take the pairs and the echo in turns, so that what else the machine does meets all.
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "daemon.hpp"
#include "echo.hpp"
#include "figures.hpp"
#include "load.hpp"
#include "vendor_pairs.hpp"

namespace {

using namespace foothold;
using namespace foothold::bench;
using Clock = std::chrono::steady_clock;

struct Size {
  int rounds, in_a_round;
  Load plans, steps;
  std::uint32_t clients;
};

constexpr Size kFull{20, 100, {6000, 1, 64}, {40, 2000, 4}, 4};
constexpr Size kQuick{5, 60, {1500, 1, 64}, {10, 2000, 4}, 4};

// Microseconds.
struct Latencies {
  std::vector<double> echo, first_step, end;
};

struct Rates {
  double plans = 0, plans_of_several = 0, steps = 0;
};

struct Server {
  std::unique_ptr<test::Daemon> daemon;
  std::uint32_t domain;
};

Server start_server(const std::string& vendor, std::uint32_t domain) {
  test::DaemonOptions options{.vendor = vendor, .domain = domain, .robots = {{"many", "many", 2, {}}}};
  options.log_level = "warn";
  return {std::make_unique<test::Daemon>(options), domain};
}

// A client of one pair, beside the raw echo of the same pair.
class Pair {
 public:
  Pair(const test::VendorPair& vendors, const Server& server, std::uint32_t echo_domain)
      : client_({.vendor = vendors.client, .domain = server.domain, .network_config = {}}),
        echo_({.client = vendors.client, .server = vendors.server, .domain = echo_domain}) {
    if (!client_.wait_for_robot("many", 20.0) || !client_.wait_for_server(20.0))
      throw std::runtime_error("no server: " + server.daemon->log());
    measure(50);
    times_ = {};
  }

  void measure(int count) {
    for (int i = 0; i < count; ++i) times_.echo.push_back(echo_.round_trip() * 1e6);
    for (int i = 0; i < count; ++i) plan();
  }

  const Latencies& times() const { return times_; }
  client::Client& client() { return client_; }

 private:
  void plan() {
    const auto begin = Clock::now();
    client::Plan plan = client_.submit(many_request(1));
    const bool stepped = plan.next(20.0) != nullptr;
    const auto first = Clock::now();
    const auto end = plan.wait(20.0);
    const auto ended = Clock::now();
    if (!stepped || !end || end->state() != msg::SUCCEEDED) throw std::runtime_error("a plan did not succeed");
    times_.first_step.push_back(std::chrono::duration<double, std::micro>(first - begin).count());
    times_.end.push_back(std::chrono::duration<double, std::micro>(ended - begin).count());
  }

  client::Client client_;
  RawEcho echo_;
  Latencies times_;
};

Rates measure_rates(client::Client& client, const test::VendorPair& vendors, const Server& server, const Size& size) {
  Rates rates;
  rates.plans = size.plans.plans / run_load(client, size.plans);
  Load shared = size.plans;
  shared.plans /= size.clients;
  shared.at_once /= size.clients;
  rates.plans_of_several = shared.plans * size.clients / run_load(vendors.client, server.domain, shared, size.clients);
  rates.steps = size.steps.plans * size.steps.steps / run_load(client, size.steps);
  return rates;
}

void add_figures(const std::string& suffix, const Latencies& times, const Rates& rates, std::vector<Figure>& figures) {
  const auto add = [&](const std::string& name, double value, const char* unit, const char* better) {
    figures.push_back({name + "_" + suffix, value, unit, better, {}, {}, {}});
  };
  for (const auto& [name, values] : {std::pair{"echo", &times.echo}, {"first_step", &times.first_step}, {"end", &times.end}})
    for (const auto& [part, word] : {std::pair{0.5, "_p50"}, {0.99, "_p99"}})
      add(std::string(name) + word, percentile(*values, part), "us", "less");
  add("first_step_over_echo_p50", percentile(times.first_step, 0.5) / percentile(times.echo, 0.5), "1", "less");
  add("plans_per_s", rates.plans, "1/s", "more");
  add("plans_per_s_of_several_clients", rates.plans_of_several, "1/s", "more");
  add("steps_per_s", rates.steps, "1/s", "more");
}

void run(const Size& size) {
  std::vector<Server> servers;
  std::vector<std::unique_ptr<Pair>> pairs;
  std::uint32_t domain = 20;
  for (const char* vendor : {"cyclone", "fastdds"}) servers.push_back(start_server(vendor, ++domain));
  for (const auto& vendors : test::kVendorPairs)
    pairs.push_back(std::make_unique<Pair>(vendors, servers[vendors.server == std::string("cyclone") ? 0 : 1], ++domain));
  for (int round = 0; round < size.rounds; ++round)
    for (const auto& pair : pairs) pair->measure(size.in_a_round);

  std::vector<Figure> figures;
  double worst_ratio = 0, worst_plans = 1e12, worst_steps = 1e12;
  Rates by_default;
  std::printf("%-20s %9s %9s %9s %9s %9s %9s %6s %9s %9s %9s\n", "server, client", "echo p50", "p99", "first p50", "p99", "end p50",
              "p99 us", "ratio", "plans/s", "several", "steps/s");
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const test::VendorPair& vendors = test::kVendorPairs[i];
    const Latencies times = pairs[i]->times();
    const Rates rates = measure_rates(pairs[i]->client(), vendors, servers[vendors.server == std::string("cyclone") ? 0 : 1], size);
    const double ratio = percentile(times.first_step, 0.5) / percentile(times.echo, 0.5);
    const std::string name = std::string(vendors.server) + ", " + vendors.client;
    std::printf("%-20s %9.1f %9.1f %9.1f %9.1f %9.1f %9.1f %6.2f %9.0f %9.0f %9.0f\n", name.c_str(), percentile(times.echo, 0.5),
                percentile(times.echo, 0.99), percentile(times.first_step, 0.5), percentile(times.first_step, 0.99),
                percentile(times.end, 0.5), percentile(times.end, 0.99), ratio, rates.plans, rates.plans_of_several, rates.steps);
    std::fflush(stdout);
    add_figures(std::string(vendors.server) + "_" + vendors.client, times, rates, figures);
    worst_ratio = std::max(worst_ratio, ratio);
    worst_plans = std::min(worst_plans, rates.plans);
    worst_steps = std::min(worst_steps, rates.steps);
    if (i == 0) by_default = rates;
  }
  // The named figures: the worst pair's ratio, and the rates of the pair that a server is shipped with (cyclone, cyclone).
  figures.insert(figures.begin(), {{"first_step_over_echo_p50", worst_ratio, "1", "less", 2.5, {}, {}},
                                   {"plans_per_s", by_default.plans, "1/s", "more", 2000.0, {}, {}},
                                   {"steps_per_s", by_default.steps, "1/s", "more", 20000.0, {}, {}},
                                   {"plans_per_s_worst_pair", worst_plans, "1/s", "more", {}, {}, {}},
                                   {"steps_per_s_worst_pair", worst_steps, "1/s", "more", {}, {}, {}}});
  report("wire", figures);
}

}  // namespace

int main(int count, char** words) try {
  if (count > 1 && std::strcmp(words[1], "--load") == 0) return load_main(count, words);
  run(quick(count, words) ? kQuick : kFull);
} catch (const std::exception& fault) {
  std::fprintf(stderr, "bench_wire: %s\n", fault.what());
  return EXIT_FAILURE;
}
