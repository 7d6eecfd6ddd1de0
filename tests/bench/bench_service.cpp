// A server with many clients: bench_service [--quick] [--soak SECONDS] [--vendor cyclone|fastdds] [--part clients|queue|soak].
//
//   clients       1 to 50 clients of both vendors, each with one plan of five steps under way: throughput, p50, p99, memory
//   queue         requests that wait for another robot's worker, 0 to 10,000, beside five clients: the same
//   soak          20 clients at a steady pace (default 30 minutes): resident memory of the server and its workers, by time
// Each is asked of a server of either vendor, unless one part or one vendor is named. Memory is resident, in MiB. In the soak the
// journal keeps ends for a minute, so that what it holds does not grow for seven days; memory is flat if the second half's mean is
// within 2 % of the first half's, both behind a warm-up of a fifth of the time; that is a goal of soaks of ten minutes and more.
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <numeric>
#include <stdexcept>

#include "figures.hpp"
#include "planners.hpp"
#include "service_load.hpp"
#include "wire.hpp"

namespace {

using namespace foothold;
using namespace foothold::bench;

struct Size {
  std::vector<std::uint32_t> clients, queues;
  double spell;  // s, of each measurement
  double soak;   // s, of each vendor
};

const Size kFull{{1, 2, 5, 10, 20, 35, 50}, {0, 100, 1000, 10000}, 4.0, 1800.0};
const Size kQuick{{1, 5, 20}, {0, 1000}, 0.7, 2.5};

constexpr double kFlat = 2.0;      // %
constexpr double kJudged = 600.0;  // s: histories and caches fill before

class Server {
 public:
  Server(const std::string& vendor, std::uint32_t domain, const std::string& more = {})
      : domain_(domain),
        daemon_({.vendor = vendor,
                 .domain = domain,
                 .robots = {{.name = "many", .plugin = "many", .slots = 2}, {.name = "busy", .plugin = "many"}},
                 .log_level = "warn",
                 .more = "metrics: {port: 0}\nqueue_limit: 20000\nadmission: {queued_per_client: 20000}\n" + more}) {}
  std::uint32_t domain() const { return domain_; }
  const test::Daemon& daemon() const { return daemon_; }

 private:
  std::uint32_t domain_;
  test::Daemon daemon_;
};

void print_head(const char* what) {
  std::printf("\n%-10s %-10s %10s %9s %9s %12s %12s\n", "server", what, "plans/s", "p50 ms", "p99 ms", "server MiB", "workers MiB");
}

void print_row(const std::string& vendor, const std::string& what, const Measured& measured, const Resident& memory) {
  std::printf("%-10s %-10s %10.0f %9.2f %9.2f %12.1f %12.1f\n", vendor.c_str(), what.c_str(), measured.rate(),
              percentile(measured.latencies, 0.5), percentile(measured.latencies, 0.99), memory.server, memory.workers);
  std::fflush(stdout);
}

void add_figures(const std::string& name, const Measured& measured, const Resident& memory, std::vector<Figure>& figures) {
  figures.push_back({name + "_plans_per_s", measured.rate(), "1/s", "more", {}, {}, {}});
  figures.push_back({name + "_p50", percentile(measured.latencies, 0.5), "ms", "less", {}, {}, {}});
  figures.push_back({name + "_p99", percentile(measured.latencies, 0.99), "ms", "less", {}, {}, {}});
  figures.push_back({name + "_server_memory", memory.server, "MiB", "less", {}, {}, {}});
}

void measure_clients(const std::string& vendor, std::uint32_t domain, const Size& size, std::vector<Figure>& figures) {
  const Server server(vendor, domain);
  for (const std::uint32_t count : size.clients) {
    Clients clients(count, domain, "many", {});
    clients.work(0.3);
    const Measured measured = clients.work(size.spell);
    const Resident memory = resident(server.daemon());
    print_row(vendor, std::to_string(count), measured, memory);
    add_figures(vendor + "_clients_" + std::to_string(count), measured, memory, figures);
  }
}

void measure_queues(const std::string& vendor, std::uint32_t domain, const Size& size, std::vector<Figure>& figures) {
  const Server server(vendor, domain);
  test::Wire wire(vendor, domain);
  if (!wire.connect("busy")) throw std::runtime_error("no server");
  std::uint32_t waiting = 0;
  for (const std::uint32_t queue : size.queues) {
    // One runs for ever, the others wait for its end.
    for (; waiting < queue + (queue > 0 ? 1 : 0); ++waiting) {
      msg::PlanRequest request = test::paced_request("busy", 1000000, 1.0);
      request.budget(3000.0);
      wire.submit(request);
    }
    const auto queued = [&] { return wire.server() && wire.server()->queued() >= queue; };
    if (!wire.wait_until(60.0, queued)) throw std::runtime_error("the queue does not fill");
    Clients clients(5, domain, "many", {});
    clients.work(0.3);
    const Measured measured = clients.work(size.spell);
    const Resident memory = resident(server.daemon());
    print_row(vendor, std::to_string(queue), measured, memory);
    add_figures(vendor + "_queue_" + std::to_string(queue), measured, memory, figures);
  }
}

double mean(const std::vector<double>& values, std::size_t begin, std::size_t end) {
  return std::accumulate(values.begin() + static_cast<std::ptrdiff_t>(begin), values.begin() + static_cast<std::ptrdiff_t>(end),
                         0.0) /
         static_cast<double>(end - begin);
}

// % by which the mean of the second half exceeds that of the first, behind the warm-up.
double growth(const std::vector<double>& values) {
  const std::size_t warm = values.size() / 5, half = warm + (values.size() - warm) / 2;
  const double first = mean(values, warm, half);
  return 100.0 * (mean(values, half, values.size()) - first) / first;
}

void soak(const std::string& vendor, std::uint32_t domain, double seconds, std::vector<Figure>& figures) {
  constexpr int kSpells = 50;
  const Server server(vendor, domain, "retention: 1 min\n");
  Clients clients(20, domain, "many", {.at_once = 1, .steps = 5, .pause = 0.1});
  std::vector<double> of_server, of_workers;
  Measured all;
  for (int spell = 0; spell < kSpells; ++spell) {
    const Measured measured = clients.work(seconds / kSpells);
    all.seconds += measured.seconds;
    all.latencies.insert(all.latencies.end(), measured.latencies.begin(), measured.latencies.end());
    const Resident memory = resident(server.daemon());
    of_server.push_back(memory.server);
    of_workers.push_back(memory.workers);
    if (spell % 5 == 4) print_row(vendor, std::to_string(static_cast<int>(all.seconds)) + " s", measured, memory);
  }
  figures.push_back({vendor + "_soak_seconds", all.seconds, "s", "more", {}, {}, {}});
  figures.push_back({vendor + "_soak_plans", static_cast<double>(all.latencies.size()), "1", "more", {}, {}, {}});
  figures.push_back({vendor + "_soak_p99", percentile(all.latencies, 0.99), "ms", "less", {}, {}, {}});
  const std::optional<double> goal = seconds >= kJudged ? std::optional(kFlat) : std::nullopt;
  figures.push_back({vendor + "_soak_server_growth", growth(of_server), "%", "less", goal, {}, {}});
  figures.push_back({vendor + "_soak_workers_growth", growth(of_workers), "%", "less", goal, {}, {}});
}

// A choice that is not made is for all.
std::vector<std::string> chosen(const char* option, const std::vector<std::string>& all, int count, char** words) {
  const auto word = word_of(option, count, words);
  if (!word) return all;
  if (std::ranges::find(all, *word) == all.end()) throw std::runtime_error(std::string(option) + ": '" + *word + "' is not known");
  return {*word};
}

}  // namespace

int main(int count, char** words) {
  try {
    if (count > 1 && std::strcmp(words[1], "--client") == 0) return client_main(count, words);
    const bool is_quick = quick(count, words, {"--soak SECONDS", "--vendor cyclone|fastdds", "--part clients|queue|soak"});
    const Size& size = is_quick ? kQuick : kFull;
    const auto soaking = word_of("--soak", count, words);
    const auto vendors = chosen("--vendor", {"cyclone", "fastdds"}, count, words);
    std::vector<Figure> figures;
    std::uint32_t domain = 120;
    for (const std::string& part : chosen("--part", {"clients", "queue", "soak"}, count, words)) {
      print_head(part.c_str());
      for (const std::string& vendor : vendors) {
        ++domain;
        if (part == "clients") measure_clients(vendor, domain, size, figures);
        if (part == "queue") measure_queues(vendor, domain, size, figures);
        if (part == "soak") soak(vendor, domain, soaking ? std::stod(*soaking) : size.soak, figures);
      }
    }
    report("service", figures);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_service: %s\n", error.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
