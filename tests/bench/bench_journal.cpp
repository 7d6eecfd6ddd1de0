// The journal alone: how long a commit holds up the loop, how many plans and steps per second it stores. bench_journal [--quick]
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "figures.hpp"
#include "journal/journal.hpp"

namespace {

using namespace foothold;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

msg::PlanRequest request() {
  msg::PlanRequest r;
  r.id(msg::random_id());
  r.client(msg::random_id());
  r.robot("xrobin");
  r.goal().base().resize(1);
  return r;
}

msg::PlanEvent ending(const msg::PlanRequest& r) {
  msg::PlanEvent e;
  e.request(r.id());
  e.summary().parameters().resize(5);
  return e;
}

// Plans of `steps` steps, `plans` of them side by side, each round of the loop one commit. Gives the seconds of each commit's
// round.
std::vector<double> run(server::SqliteJournal& journal, int rounds, int plans, std::uint32_t steps, const msg::Bytes& step) {
  std::vector<double> times;
  for (int round = 0; round < rounds; ++round) {
    std::vector<msg::PlanRequest> now;
    for (int i = 0; i < plans; ++i) now.push_back(request());
    const auto in_commit = [&](auto&& write) {
      const auto start = Clock::now();
      for (const auto& r : now) write(r);
      journal.commit();
      times.push_back(seconds_since(start));
    };
    in_commit([&](const auto& r) { journal.add_request(r, 0); });
    for (std::uint32_t k = 0; k < steps; ++k) in_commit([&](const auto& r) { journal.add_step(r.id(), k, step); });
    in_commit([&](const auto& r) { journal.set_final(r.id(), ending(r)); });
  }
  return times;
}

double sum(const std::vector<double>& values) {
  double total = 0;
  for (const double value : values) total += value;
  return total;
}

}  // namespace

int main(int count, char** words) {
  using namespace foothold::bench;
  const int scale = quick(count, words) ? 1 : 4;
  const auto folder = std::filesystem::temp_directory_path() / ("foothold-bench-" + msg::to_hex(msg::random_id()));
  std::filesystem::create_directory(folder);
  std::vector<Figure> figures;
  {
    server::SqliteJournal journal((folder / "journal.db").string());
    const msg::Bytes step(600);
    run(journal, 200, 1, 1, step);
    const auto single = run(journal, 1500 * scale, 1, 1, step);
    const double single_plans = 1500 * scale / sum(single);
    const auto batched = run(journal, 400 * scale, 16, 10, step);
    const double steps_per_s = 400 * scale * 16 * 10 / sum(batched);
    std::printf("alone:    commit p50 %.1f us, p99 %.1f us, worst %.1f us; %.0f plans/s\n", 1e6 * percentile(single, 0.5),
                1e6 * percentile(single, 0.99), 1e6 * percentile(single, 1.0), single_plans);
    std::printf("16 a time: commit p50 %.1f us, p99 %.1f us, worst %.1f us; %.0f steps/s\n", 1e6 * percentile(batched, 0.5),
                1e6 * percentile(batched, 0.99), 1e6 * percentile(batched, 1.0), steps_per_s);
    figures = {{"commit_p50", 1e6 * percentile(single, 0.5), "us", "less"},
               {"commit_p99", 1e6 * percentile(single, 0.99), "us", "less"},
               {"plans_per_s_alone", single_plans, "1/s", "more", 2000},
               {"steps_per_s", steps_per_s, "1/s", "more", 20000}};
  }
  std::filesystem::remove_all(folder);
  report("journal", figures);
}
