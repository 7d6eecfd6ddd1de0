// How soon a request goes on when its server is killed: bench_failover [--quick] [--fleet ONE_TWO_CLIENT].
//
// Two servers of four workers each in one domain, a client with `kAtOnce` short plans under way at any time, shared between them.
// In the middle of that one server is killed with SIGKILL. For every request that it had then (recovery times, from the kill):
//   heard   until the client hears of it from the other server
//   ended   until its final event and all of its steps, planned anew
// The killed server is started again and the next kill waits until it serves. By fleets of both vendors and mixed.
#include <array>
#include <chrono>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "daemon.hpp"
#include "eventually.hpp"
#include "figures.hpp"
#include "load.hpp"

namespace {

using namespace foothold;
using namespace foothold::bench;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kAtOnce = 16;
constexpr std::uint32_t kSteps = 10;
constexpr std::uint32_t kPause = 10000;  // us before each step

struct Fleet {
  const char *one, *two, *client;
};
constexpr std::array kFleets{Fleet{"cyclone", "cyclone", "cyclone"}, Fleet{"fastdds", "fastdds", "fastdds"},
                             Fleet{"cyclone", "fastdds", "cyclone"}, Fleet{"cyclone", "fastdds", "fastdds"}};

struct Recovery {
  std::vector<double> heard, ended;  // s, of each request that the killed server had
  std::size_t requests = 0;
};

struct Under {
  client::Plan plan;
  msg::Id server{};         // at the kill
  Clock::time_point heard;  // the other server's first word
};

class Rig {
 public:
  Rig(const Fleet& fleet, std::uint32_t domain)
      : one_(options("one", fleet.one, domain)),
        two_(options("two", fleet.two, domain)),
        client_({.vendor = fleet.client, .domain = domain, .network_config = {}}) {
    wait_for_both();
  }

  void kill_one(int round, Recovery& found) {
    test::Daemon& victim = round % 2 == 0 ? one_ : two_;
    const char* name = round % 2 == 0 ? "one" : "two";
    msg::Id id{};
    for (const auto& server : client_.servers())
      if (server.info.name() == name) id = server.info.key();
    std::vector<Under> under;
    // Some load first, so that both are warm and the kill meets plans in every state.
    for (std::size_t i = 0; i < 3 * kAtOnce; ++i) {
      under.push_back({client_.submit(request()), {}, {}});
      if (under.size() > kAtOnce) {
        finish(under.front(), found);
        under.erase(under.begin());
      }
    }
    for (Under& each : under) each.server = each.plan.ended() ? msg::kNoId : each.plan.server();
    const auto killed = Clock::now();
    victim.kill();
    std::size_t open = under.size();
    std::vector<bool> done(under.size());
    while (open > 0) {
      if (Clock::now() - killed > std::chrono::seconds(30)) throw std::runtime_error("a request did not end");
      for (std::size_t i = 0; i < under.size(); ++i) {
        Under& each = under[i];
        if (done[i]) continue;
        if (each.heard == Clock::time_point{} && each.plan.traffic().moves > 0 && each.plan.state() != msg::UNKNOWN)
          each.heard = Clock::now();
        if (!each.plan.ended()) continue;
        done[i] = true;
        --open;
        finish(each, found);
        if (each.server != id || each.plan.traffic().moves == 0) continue;
        found.heard.push_back(std::chrono::duration<double>(each.heard - killed).count());
        found.ended.push_back(std::chrono::duration<double>(each.plan.times().ended - killed).count());
      }
      std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    victim.start();
    wait_for_both();
  }

 private:
  static test::DaemonOptions options(const char* name, const char* vendor, std::uint32_t domain) {
    return {.name = name,
            .vendor = vendor,
            .domain = domain,
            .robots = {{"many", "many", 4, {}}},
            .log_level = "error",
            .more = "metrics: {enabled: false}\n"};
  }

  static msg::PlanRequest request() {
    msg::PlanRequest request = many_request(kSteps);
    msg::Parameter pause;
    pause.name("pause_us");
    pause.value(std::to_string(kPause));
    request.parameters().push_back(pause);
    return request;
  }

  void wait_for_both() {
    const auto alive = [&] {
      const auto servers = client_.servers();
      return servers.size() == 2 && servers[0].alive && servers[1].alive && client_.robots().size() == 2;
    };
    if (!test::eventually(alive)) throw std::runtime_error("two servers do not serve: " + one_.log() + two_.log());
    for (const auto& server : client_.servers())
      if (!client_.wait_for_server(20.0, server.info.key())) throw std::runtime_error("a server is not reached");
  }

  static void finish(const Under& each, Recovery& found) {
    const auto end = each.plan.wait(30.0);
    if (!end || end->state() != msg::SUCCEEDED || each.plan.steps_ready() != kSteps)
      throw std::runtime_error("a request did not succeed with all of its steps");
    ++found.requests;
  }

  test::Daemon one_, two_;
  client::Client client_;
};

}  // namespace

int main(int count, char** words) try {
  const int kills = quick(count, words, {"--fleet ONE_TWO_CLIENT"}) ? 2 : 12;
  const auto wanted = word_of("--fleet", count, words);
  std::vector<Figure> figures;
  Recovery all;
  std::printf("%-28s %8s %8s %10s %10s %10s %10s\n", "servers, client", "requests", "affected", "heard p50", "p99 s", "ended p50",
              "p99 s");
  std::uint32_t domain = 60;
  for (const Fleet& fleet : kFleets) {
    const std::string name = std::string(fleet.one) + "_" + fleet.two + "_" + fleet.client;
    if (wanted && *wanted != name) continue;
    Rig rig(fleet, ++domain);
    Recovery found;
    for (int kill = 0; kill < kills; ++kill) rig.kill_one(kill, found);
    if (found.ended.empty()) throw std::runtime_error("no kill met a request");
    std::printf("%-28s %8zu %8zu %10.3f %10.3f %10.3f %10.3f\n", name.c_str(), found.requests, found.ended.size(),
                percentile(found.heard, 0.5), percentile(found.heard, 0.99), percentile(found.ended, 0.5),
                percentile(found.ended, 0.99));
    std::fflush(stdout);
    figures.push_back({"recovery_p99_" + name, percentile(found.ended, 0.99), "s", "less", {}, {}, {}});
    all.heard.insert(all.heard.end(), found.heard.begin(), found.heard.end());
    all.ended.insert(all.ended.end(), found.ended.begin(), found.ended.end());
    all.requests += found.requests;
  }
  if (all.ended.empty()) throw std::runtime_error("--fleet: '" + *wanted + "' is none, such as cyclone_fastdds_cyclone");
  figures.insert(figures.begin(), {{"recovery_p99", percentile(all.ended, 0.99), "s", "less", 2.0, {}, {}},
                                   {"recovery_p50", percentile(all.ended, 0.5), "s", "less", {}, {}, {}},
                                   {"heard_p99", percentile(all.heard, 0.99), "s", "less", {}, {}, {}},
                                   {"affected", static_cast<double>(all.ended.size()), "1", "more", {}, {}, {}},
                                   {"requests", static_cast<double>(all.requests), "1", "more", {}, {}, {}}});
  report("failover", figures);
} catch (const std::exception& fault) {
  std::fprintf(stderr, "bench_failover: %s\n", fault.what());
  return EXIT_FAILURE;
}
