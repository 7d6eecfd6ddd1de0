// What DDS Security costs: bench_security [--quick]. For each of the four vendor pairs, a server and a client with security on
// beside the same without, in one run:
//   join          from the client's construction until both ways to its server are open
//   first step    from submit() until the thread that waits has the first step, one request after the other
//   end           the same until the final event
//   plans/s       plans of one step, 64 under way
//   steps/s       plans of 2000 steps, 4 under way
// The planner returns at once. Latencies are measured in rounds that take the pairs, on and off, in turns.
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "credentials.hpp"
#include "daemon.hpp"
#include "figures.hpp"
#include "load.hpp"
#include "vendor_pairs.hpp"

namespace {

using namespace foothold;
using namespace foothold::bench;
using Clock = std::chrono::steady_clock;

struct Size {
  int joins, rounds, in_a_round;
  Load plans, steps;
};

constexpr Size kFull{20, 20, 100, {4000, 1, 64}, {40, 2000, 4}};
constexpr Size kQuick{3, 4, 40, {500, 1, 64}, {6, 2000, 4}};

double microseconds(Clock::time_point since) { return std::chrono::duration<double, std::micro>(Clock::now() - since).count(); }

struct Server {
  std::string vendor, client_credentials;
  std::uint32_t domain;
  std::unique_ptr<test::Daemon> daemon;
};

// One client of one server, and what was measured with it.
class Way {
 public:
  Way(const Server& server, const std::string& vendor) : server_(server), vendor_(vendor) {}

  // Comes, is served and goes again.
  void join() {
    const auto begin = Clock::now();
    connect();
    joins.push_back(microseconds(begin));
    client_.reset();
  }

  void connect() {
    client_ = std::make_unique<client::Client>(
        transport::BusOptions{.vendor = vendor_, .domain = server_.domain, .security = server_.client_credentials});
    if (!client_->wait_for_server(20.0) || !client_->wait_for_robot("many", 20.0))
      throw std::runtime_error("no server: " + server_.daemon->log());
  }

  void plan(int count) {
    for (int i = 0; i < count; ++i) {
      const auto begin = Clock::now();
      client::Plan plan = client_->submit(many_request(1));
      const bool stepped = plan.next(20.0) != nullptr;
      first_steps.push_back(microseconds(begin));
      const auto end = plan.wait(20.0);
      ends.push_back(microseconds(begin));
      if (!stepped || !end || end->state() != msg::SUCCEEDED) throw std::runtime_error("a plan did not succeed");
    }
  }

  void load(const Size& size) {
    plans_per_s = size.plans.plans / run_load(*client_, size.plans);
    steps_per_s = size.steps.plans * size.steps.steps / run_load(*client_, size.steps);
    client_.reset();
  }

  std::vector<double> joins, first_steps, ends;  // us
  double plans_per_s = 0, steps_per_s = 0;

 private:
  const Server& server_;
  std::string vendor_;
  std::unique_ptr<client::Client> client_;
};

struct Pair {
  std::string name;
  std::unique_ptr<Way> off, on;
};

void print(const std::string& name, const char* security, const Way& way) {
  std::printf("%-20s %-4s %9.1f %9.1f %9.1f %9.1f %9.1f %9.0f %9.0f\n", name.c_str(), security, percentile(way.joins, 0.5) / 1e3,
              percentile(way.first_steps, 0.5), percentile(way.first_steps, 0.99), percentile(way.ends, 0.5),
              percentile(way.ends, 0.99), way.plans_per_s, way.steps_per_s);
}

void add(const Pair& pair, std::vector<Figure>& figures) {
  const auto one = [&](const std::string& name, const char* unit, const char* better, double on, double off) {
    figures.push_back({name + "_" + pair.name, on, unit, better, {}, off, "security off"});
  };
  const Way &on = *pair.on, &off = *pair.off;
  one("join_p50", "us", "less", percentile(on.joins, 0.5), percentile(off.joins, 0.5));
  one("first_step_p50", "us", "less", percentile(on.first_steps, 0.5), percentile(off.first_steps, 0.5));
  one("first_step_p99", "us", "less", percentile(on.first_steps, 0.99), percentile(off.first_steps, 0.99));
  one("end_p50", "us", "less", percentile(on.ends, 0.5), percentile(off.ends, 0.5));
  one("plans_per_s", "1/s", "more", on.plans_per_s, off.plans_per_s);
  one("steps_per_s", "1/s", "more", on.steps_per_s, off.steps_per_s);
}

void run(const Size& size) {
  const test::Fleet fleet;
  const std::string server_credentials = fleet.issue("server", security::Role::kServer);
  const std::string client_credentials = fleet.issue("client", security::Role::kClient);
  // A domain each: clients of every pair and both ways live in this process, where Cyclone takes one secured bus per domain.
  std::vector<Server> servers;
  std::uint32_t domain = 30;
  for (const auto& vendors : test::kVendorPairs) {
    for (const bool secured : {false, true}) {
      test::DaemonOptions options{.vendor = vendors.server, .domain = ++domain, .robots = {{"many", "many", 2, {}}}};
      options.log_level = "error";
      if (secured) options.security = server_credentials;
      servers.push_back({vendors.server, secured ? client_credentials : "", domain, std::make_unique<test::Daemon>(options)});
    }
  }
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < test::kVendorPairs.size(); ++i) {
    const test::VendorPair& vendors = test::kVendorPairs[i];
    pairs.push_back({std::string(vendors.server) + "_" + vendors.client, std::make_unique<Way>(servers[2 * i], vendors.client),
                     std::make_unique<Way>(servers[2 * i + 1], vendors.client)});
  }
  for (int i = 0; i < size.joins; ++i)
    for (const Pair& pair : pairs)
      for (Way* way : {pair.off.get(), pair.on.get()}) way->join();
  for (const Pair& pair : pairs)
    for (Way* way : {pair.off.get(), pair.on.get()}) {
      way->connect();
      way->plan(20);
      way->first_steps.clear();
      way->ends.clear();
    }
  for (int round = 0; round < size.rounds; ++round)
    for (const Pair& pair : pairs)
      for (Way* way : {pair.off.get(), pair.on.get()}) way->plan(size.in_a_round);
  for (const Pair& pair : pairs)
    for (Way* way : {pair.off.get(), pair.on.get()}) way->load(size);

  std::vector<Figure> figures;
  std::printf("%-20s %-4s %9s %9s %9s %9s %9s %9s %9s\n", "server_client", "sec.", "join ms", "first p50", "p99", "end p50",
              "p99 us", "plans/s", "steps/s");
  for (const Pair& pair : pairs) {
    print(pair.name, "off", *pair.off);
    print("", "on", *pair.on);
    add(pair, figures);
  }
  report("security", figures);
}

}  // namespace

int main(int count, char** words) try { run(quick(count, words) ? kQuick : kFull); } catch (const std::exception& fault) {
  std::fprintf(stderr, "bench_security: %s\n", fault.what());
  return EXIT_FAILURE;
}
