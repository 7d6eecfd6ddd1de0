// Xrobin's searches against the paper's: the printed targets, random targets, brute force. bench_xrobin [--quick]
#include <chrono>
#include <cmath>
#include <cstdio>
#include <numeric>
#include <random>

#include "figures.hpp"
#include "foothold/robot_file.hpp"
#include "obstacle_solver.hpp"
#include "scenery.hpp"

namespace {

using namespace foothold::xrobin;
using foothold::bench::Figure;
using foothold::bench::percentile;
using Clock = std::chrono::steady_clock;

constexpr double kPaperMs = 1500.0;  // the paper's mean time, MATLAB R2018a on an i7-8750H
constexpr int kCycles = 7;
constexpr int kGridCells = 201;

double ms_since(Clock::time_point start) { return std::chrono::duration<double, std::milli>(Clock::now() - start).count(); }

template <class F>
double time_ms(F work) {
  const auto start = Clock::now();
  work();
  return ms_since(start);
}

double error_mm(const Mechanism& mechanism, const Word& word, const Target& goal) {
  const PlanarPose end = forward(mechanism, word);
  return 1e3 * std::hypot(end.x - goal.x, end.y - goal.y);
}

Target at(double x, double y) { return {x, y, std::nullopt, 0.0}; }

// Evenly over the disc, or ends of random words, up to 5 mm beside.
std::vector<Target> targets_in_disc(std::mt19937_64& random, int count, double radius) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  std::vector<Target> out;
  while (static_cast<int>(out.size()) < count) {
    const double angle = 2.0 * std::numbers::pi * unit(random);
    const double r = radius * std::sqrt(unit(random));
    out.push_back(at(r * std::cos(angle), r * std::sin(angle)));
  }
  return out;
}

std::vector<Target> targets_of_words(const Mechanism& mechanism, std::mt19937_64& random, int count) {
  std::vector<Target> out;
  for (const Target& beside : targets_in_disc(random, count, 0.005)) {
    Word word(2 * kCycles);
    for (auto& configuration : word) configuration = static_cast<std::uint8_t>(1 + random() % 8);
    const PlanarPose end = forward(mechanism, word);
    out.push_back(at(end.x + beside.x, end.y + beside.y));
  }
  return out;
}

void print_paper_targets(const Solver& solver, const Limits& limits, std::vector<Figure>& figures) {
  struct Printed {
    Target goal;
    Word word;
    const char* name;
  };
  const std::vector<int> s1[] = {{2, 1, 1, 1, 1, 1, 8}, {2, 1, 1, 7, 1, 1, 1}, {1, 1, 2, 1, 1, 1, 1}};
  const std::vector<int> s2[] = {{5, 5, 5, 5, 5, 6, 4}, {5, 5, 5, 2, 1, 1, 1}, {5, 5, 5, 5, 5, 5, 5}};
  const Printed printed[] = {{at(0.4, 0.4), from_paper(s1[0], s2[0]), "400"},
                             {at(0.2, 0.2), from_paper(s1[1], s2[1]), "200"},
                             {at(1.0, 1.0), from_paper(s1[2], s2[2]), "1000"}};
  std::printf("%-12s | %-34s | %-14s | %-10s | %s\n", "target, mm", "printed word: end, mm; error, mm", "greedy, mm", "optimal, mm",
              "proved at least, mm");
  for (const Printed& p : printed) {
    const PlanarPose end = forward(solver.mechanism(), p.word);
    const Solution greedy = solver.solve(Method::kGreedy, p.goal, limits, {});
    const Solution best = solver.solve(Method::kOptimal, p.goal, limits, {});
    std::printf("(%4.0f, %4.0f) | (%8.3f, %8.3f)  %10.4f   | %14.4f | %10.5f | %.9f\n", 1e3 * p.goal.x, 1e3 * p.goal.y, 1e3 * end.x,
                1e3 * end.y, error_mm(solver.mechanism(), p.word, p.goal), 1e3 * greedy.distance, 1e3 * best.distance,
                1e3 * best.least_distance);
    const double paper = error_mm(solver.mechanism(), p.word, p.goal);
    Figure figure{std::string("optimal_error_") + p.name, 1e3 * best.distance, "mm", "less", {}, paper, "paper's word"};
    if (p.goal.x == 0.4) figure.goal = 0.275;
    if (p.goal.x == 0.2) figure.goal = 0.0291;
    figures.push_back(figure);
    figures.push_back({std::string("greedy_error_") + p.name, 1e3 * greedy.distance, "mm", "less", {}, paper, "paper's word"});
    if (p.goal.x == 0.4) figures.back().goal = 1.21;
    if (p.goal.x == 0.2) figures.back().goal = 0.61;
  }
}

struct Sample {
  std::vector<double> greedy_us, optimal_ms, fewest_ms, greedy_mm, optimal_mm;
  int worse = 0;
};

// All methods on each target in turn.
Sample run(const Solver& solver, const std::vector<Target>& targets, const Limits& limits) {
  Sample out;
  const Mechanism& m = solver.mechanism();
  Limits half_millimetre = limits;
  half_millimetre.tolerance = 0.5e-3;
  for (const Target& goal : targets) {
    Word word;
    Solution best, fewest;
    out.greedy_us.push_back(1e3 * time_ms([&] { word = solver.greedy().word(goal.x, goal.y, limits.cycles); }));
    out.optimal_ms.push_back(time_ms([&] { best = solver.solve(Method::kOptimal, goal, limits, {}); }));
    out.fewest_ms.push_back(time_ms([&] { fewest = solver.solve(Method::kFewest, goal, half_millimetre, {}); }));
    out.greedy_mm.push_back(error_mm(m, word, goal));
    out.optimal_mm.push_back(error_mm(m, best.word, goal));
    if (out.optimal_mm.back() > out.greedy_mm.back() + 1e-9) ++out.worse;
  }
  return out;
}

void print_sample(const char* name, const Sample& s) {
  std::printf("\n%s (%zu targets)\n%-22s %10s %10s %10s\n", name, s.optimal_mm.size(), "", "median", "p99", "worst");
  const auto row = [](const char* what, const std::vector<double>& v) {
    std::printf("%-22s %10.4f %10.4f %10.4f\n", what, percentile(v, 0.5), percentile(v, 0.99), percentile(v, 1.0));
  };
  row("greedy, us", s.greedy_us);
  row("optimal, ms", s.optimal_ms);
  row("fewest 0.5 mm, ms", s.fewest_ms);
  row("greedy error, mm", s.greedy_mm);
  row("optimal error, mm", s.optimal_mm);
}

// How many targets brute force and `optimal` disagree on, over 1 to 3 cycles.
int disagreements(Solver& solver, std::mt19937_64& random, int count) {
  int out = 0;
  for (int cycles = 1; cycles <= 3; ++cycles) {
    solver.prepare(Method::kOptimal, cycles, 0, false, {});
    const Limits limits{.cycles = cycles, .max_cycles = cycles, .tolerance = 1e-9};
    for (const Target& goal : targets_in_disc(random, count, cycles * solver.mechanism().longest_cycle())) {
      const double best = best_of_all_words(solver.mechanism(), cycles, goal, {})->distance;
      if (std::abs(solver.solve(Method::kOptimal, goal, limits, {}).distance - best) > 1e-11) ++out;
    }
  }
  return out;
}

struct Hindered {
  std::vector<double> ms;
  int reached = 0;
  int proved = 0;
};

// Goals among ten obstacles of 50 mm, thrown round the start: within reach of the cycles if nothing were in the way.
Hindered among_obstacles(Solver& solver, const foothold::RobotModel& model, Method method, int count) {
  solver.prepare(method, kCycles, 0, true, {});
  const Mechanism& m = solver.mechanism();
  const Ring ring(m);
  const Bodies bodies = Bodies::from_model(model, m);
  const Limits limits{.cycles = kCycles, .max_cycles = 70, .tolerance = 1e-3};
  std::mt19937_64 random(50);
  Hindered out;
  while (static_cast<int>(out.ms.size()) < count) {
    const Surroundings surroundings(ring, bodies, random_obstacles(random, 10, 0.13, 0.6, 0.05), 0.001);
    const Target goal = targets_in_disc(random, 1, 0.4).front();
    if (surroundings.nearest({{}, m.b_in_a(1)}).distance <= 0.001 || !surroundings.room_for_a(goal.x, goal.y)) continue;
    Solution solution;
    out.ms.push_back(time_ms([&] {
      Passage passage(surroundings, {});
      solution = ObstacleSolver(solver, passage, {{}, 1}, goal, limits, {}, {}).solve(method);
    }));
    if (solution.distance <= limits.tolerance) ++out.reached;
    const auto cycles = static_cast<int>(solution.word.size() / 2);
    if (method == Method::kFewest ? cycles <= solution.least_cycles : solution.distance - solution.least_distance < 1e-9)
      ++out.proved;
  }
  return out;
}

}  // namespace

int main(int count, char** words) {
  const bool quick = foothold::bench::quick(count, words);
  const auto model = foothold::load_robot_model(FOOTHOLD_CONFIG_DIR "/robots/xrobin.yaml");
  const Mechanism mechanism = Mechanism::from_model(model);
  const Limits limits{.cycles = kCycles, .max_cycles = kCycles, .tolerance = 1e-9};
  std::vector<Figure> figures;
  Solver solver(mechanism);
  const double grids = time_ms([&] { solver.prepare(Method::kGreedy, kCycles, kGridCells, false, {}); });
  const double tables = time_ms([&] { solver.prepare(Method::kOptimal, kCycles, 0, false, {}); });
  print_paper_targets(solver, limits, figures);

  std::mt19937_64 random(2022);
  const int targets = quick ? 1000 : 10000;
  const Sample disc = run(solver, targets_in_disc(random, targets, 0.5), limits);
  print_sample("evenly over a disc of 500 mm", disc);
  const Sample ends = run(solver, targets_of_words(mechanism, random, targets), limits);
  print_sample("beside the ends of random words", ends);

  Solver exact{Mechanism(with_exact_turns(mechanism.lengths().retracted, mechanism.lengths().extended))};
  const double exact_tables = time_ms([&] { exact.prepare(Method::kOptimal, kCycles, 0, false, {}); });
  exact.prepare(Method::kGreedy, kCycles, kGridCells, false, {});
  const Sample turns = run(exact, targets_in_disc(random, targets / 4, 0.5), limits);
  print_sample("turns of exactly 45 deg, evenly over a disc of 500 mm", turns);

  const int differ = disagreements(solver, random, quick ? 200 : 1000);
  std::optional<BestWord> four;
  const double brute_3 = time_ms([&] { four = best_of_all_words(mechanism, 3, at(0.2, 0.1), {}); });
  const double brute_4 = time_ms([&] { four = best_of_all_words(mechanism, 4, at(0.2, 0.1), {}); });

  const int scenes = quick ? 40 : 400;
  const Hindered optimal_among = among_obstacles(solver, model, Method::kOptimal, scenes);
  const Hindered fewest_among = among_obstacles(solver, model, Method::kFewest, scenes);
  std::printf("\namong ten obstacles (%d scenes), ms\n%-10s %10s %10s %10s %10s %10s\n", scenes, "", "median", "p99", "worst",
              "reached", "proved");
  for (const auto& [name, h] : {std::pair{"optimal", &optimal_among}, {"fewest", &fewest_among}})
    std::printf("%-10s %10.2f %10.2f %10.2f %9.1f%% %9.1f%%\n", name, percentile(h->ms, 0.5), percentile(h->ms, 0.99),
                percentile(h->ms, 1.0), 100.0 * h->reached / scenes, 100.0 * h->proved / scenes);

  const auto add = [&](const char* name, double value, const char* unit, std::optional<double> goal, std::optional<double> paper) {
    figures.push_back({name, value, unit, "less", goal, paper, paper ? "paper, MATLAB" : ""});
  };
  add("greedy_median", percentile(disc.greedy_us, 0.5), "us", 60.0, 1e3 * kPaperMs);
  add("optimal_median", percentile(disc.optimal_ms, 0.5), "ms", 20.0, kPaperMs);
  add("optimal_p99", percentile(disc.optimal_ms, 0.99), "ms", 60.0, kPaperMs);
  add("fewest_0p5mm", percentile(disc.fewest_ms, 0.5), "ms", 5.0, kPaperMs);
  add("fewest_0p5mm_p99", percentile(disc.fewest_ms, 0.99), "ms", {}, kPaperMs);
  add("optimal_over_greedy_error", percentile(disc.optimal_mm, 0.5) / percentile(disc.greedy_mm, 0.5), "1", 0.1, {});
  add("optimal_error_median", percentile(disc.optimal_mm, 0.5), "mm", {}, {});
  add("greedy_error_median", percentile(disc.greedy_mm, 0.5), "mm", {}, {});
  add("optimal_worse_than_greedy", disc.worse + ends.worse + turns.worse, "1", 0.0, {});
  add("words_greedy_median", percentile(ends.greedy_us, 0.5), "us", 60.0, 1e3 * kPaperMs);
  add("words_optimal_median", percentile(ends.optimal_ms, 0.5), "ms", 20.0, kPaperMs);
  add("words_optimal_p99", percentile(ends.optimal_ms, 0.99), "ms", 60.0, kPaperMs);
  add("words_fewest_0p5mm", percentile(ends.fewest_ms, 0.5), "ms", 5.0, kPaperMs);
  add("words_optimal_over_greedy_error", percentile(ends.optimal_mm, 0.5) / percentile(ends.greedy_mm, 0.5), "1", 0.1, {});
  add("exact_turns_optimal_median", percentile(turns.optimal_ms, 0.5), "ms", 20.0, kPaperMs);
  add("exact_turns_optimal_p99", percentile(turns.optimal_ms, 0.99), "ms", 60.0, kPaperMs);
  add("exact_turns_tables", exact_tables, "ms", {}, {});
  add("grids", grids, "ms", 150.0, {});
  add("tables", tables, "ms", {}, {});
  add("brute_force_disagreements", differ, "1", 0.0, {});
  add("brute_force_3_cycles", brute_3, "ms", {}, 5432.0);
  add("brute_force_4_cycles", brute_4, "ms", {}, 352634.0);
  add("obstacles_optimal_median", percentile(optimal_among.ms, 0.5), "ms", {}, kPaperMs);
  add("obstacles_optimal_p99", percentile(optimal_among.ms, 0.99), "ms", {}, kPaperMs);
  add("obstacles_fewest_median", percentile(fewest_among.ms, 0.5), "ms", {}, kPaperMs);
  add("obstacles_unreached", 100.0 - 100.0 * optimal_among.reached / scenes, "%", {}, {});
  add("obstacles_fewest_unproved", 100.0 - 100.0 * fewest_among.proved / scenes, "%", {}, {});
  foothold::bench::report("xrobin", figures);
}
