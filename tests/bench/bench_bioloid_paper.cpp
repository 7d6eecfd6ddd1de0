// The Bioloid paper's two methods beside each other over 100 trials of its cases: bench_bioloid_paper [--quick]
//
//   plane, space   round the obstacle (the paper's Figures 9, 10 and 12)
//   joints         three joints within 25 degrees (Figures 6 and 7)
//   carry          nine joints, a single support of the paper's step with the sole lifted, steps of one count of its servos
//   swing          the same from the ground to the ground, steps of 1 degree
//
// The fully random method does not end in nine joints within any time that a bench has: it is capped, and the table says how many
// trials ended. Times are of the calling thread's processor. The paper's, beside: in space 300 movements to 94 and about an hour to
// 2 s; nine joints 470 movements to 190 and 16 h to 3 s.
#include <cstdio>
#include <ctime>
#include <optional>

#include "bioloid/paper/cases.hpp"
#include "figures.hpp"
#include "nine_cases.hpp"

namespace {

using namespace foothold;
using namespace foothold::bench;
using namespace foothold::bioloid;
using namespace foothold::bioloid::paper;

double processor_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

struct Row {
  std::size_t trials = 0, ended = 0;
  double iterations = 0.0;              // mean of all trials
  double found = 0.0, movements = 0.0;  // means of those that ended, before and after what is useless was removed
  double error = 0.0, deviation = 0.0;  // m, of those that ended
  double ms = 0.0;                      // mean of all trials
};

Row hundred(const Case& shown, const Options& options, std::size_t trials_wanted, const Error& error) {
  std::mt19937_64 random(2018);
  const double begin = processor_ms();
  const std::vector<Trial> all = trials(shown.space, shown.start, shown.goal, options, trials_wanted, error, random);
  const double ms = processor_ms() - begin;
  Row out{.trials = all.size(), .ms = ms / static_cast<double>(all.size())};
  for (const Trial& trial : all) {
    out.iterations += static_cast<double>(trial.plan.iterations) / static_cast<double>(all.size());
    if (trial.plan.ending != Ending::kReached) continue;
    ++out.ended;
    out.found += static_cast<double>(trial.plan.found_movements);
    out.movements += static_cast<double>(trial.plan.movements());
    out.error += trial.mean_error;
    out.deviation += std::sqrt(trial.error_variance);
  }
  for (double* const sum : {&out.found, &out.movements, &out.error, &out.deviation})
    *sum /= static_cast<double>(std::max<std::size_t>(1, out.ended));
  return out;
}

void print(const char* name, const char* method, const Row& row) {
  std::printf("%-8s %-16s %4zu of %-4zu %12.1f ", name, method, row.ended, row.trials, row.iterations);
  if (row.ended > 0)
    std::printf("%10.1f %10.1f %12.3f %8.2f %8.2f\n", row.found, row.movements, row.ms, 1e3 * row.error, 1e3 * row.deviation);
  else
    std::printf("%10s %10s %12.3f %8s %8s\n", "-", "-", row.ms, "-", "-");
}

// What the paper says of a case: movements and time, fully random and stochastic. On a Core i7 of 2.8 GHz, in Matlab or Octave.
struct Printed {
  double random_movements = 0.0, movements = 0.0, random_ms = 0.0, ms = 0.0;
};
constexpr Printed kPaperSpace{300.0, 94.0, 3.6e6, 2e3}, kPaperNine{470.0, 190.0, 5.76e7, 3e3};

// Both methods on a case; the fully random one with and without the removal of useless sections.
void compare(
    const char* name, const Case& shown, std::size_t trials_wanted, std::size_t cap, std::vector<Figure>& figures,
    const std::optional<Printed>& paper = {}, const Error& error = [](const Point&) { return 0.0; }) {
  const Row as_found =
      hundred(shown, {.method = Method::kRandom, .clean = false, .trim = false, .iterations = cap}, trials_wanted, error);
  print(name, "random", as_found);
  Row random = as_found;
  if (as_found.ended > 0) {
    random = hundred(shown, {.method = Method::kRandom, .iterations = cap}, trials_wanted, error);
    print(name, "random, cleaned", random);
  }
  const Row ours = hundred(shown, {.iterations = 200'000}, trials_wanted, error);
  print(name, "stochastic", ours);
  const auto add = [&](const char* what, double value, const char* unit, const char* better = "less",
                       double Printed::*printed = nullptr) {
    const std::optional<double> baseline = paper && printed != nullptr ? std::optional((*paper).*printed) : std::nullopt;
    figures.push_back({std::string(name) + "_" + what, value, unit, better, {}, baseline, baseline ? "paper" : ""});
  };
  const auto count = static_cast<double>(trials_wanted);
  add("random_ended", static_cast<double>(as_found.ended) / count, "1", "more");
  add("stochastic_ended", static_cast<double>(ours.ended) / count, "1", "more");
  add("random_iterations", as_found.iterations, "1");
  add("stochastic_iterations", ours.iterations, "1");
  add("stochastic_movements", ours.movements, "1", "less", &Printed::movements);
  add("random_time", as_found.ms, "ms", "less", as_found.ended > 0 ? &Printed::random_ms : nullptr);
  add("stochastic_time", ours.ms, "ms", "less", &Printed::ms);
  if (as_found.ended == 0) return;
  add("random_movements", as_found.movements, "1", "less", &Printed::random_movements);
  add("random_cleaned_movements", random.movements, "1");
  add("iterations_random_over_stochastic", as_found.iterations / ours.iterations, "1", "more");
  add("movements_random_over_stochastic", as_found.movements / ours.movements, "1", "more");
  add("time_random_over_stochastic", as_found.ms / ours.ms, "1", "more");
}

void compare_nine(const char* name, double lift, double step, std::size_t trials_wanted, std::size_t cap,
                  std::vector<Figure>& figures) {
  const Model& model = bioloid::testing::shipped_model();
  const bioloid::testing::NineCase shown = bioloid::testing::nine_case(lift);
  Judge judge(model, {});
  const Space space = nine_space(model, judge, shown.support, shown.from, shown.to, {.step = step});
  const auto at = [&](const Joints& joints) { return nine_point(model, shown.support.foot, joints, space.dimension()); };
  compare(name, {space, at(shown.from), at(shown.to)}, trials_wanted, cap, figures, kPaperNine,
          balance_error(model, judge, shown.support, 0.0));
}

}  // namespace

int main(int count, char** words) {
  const bool quick = foothold::bench::quick(count, words);
  std::vector<Figure> figures;
  std::printf("%-8s %-16s %-12s %12s %10s %10s %12s %8s %8s\n", "case", "method", "ended", "iterations", "found", "movements", "ms",
              "error mm", "dev. mm");
  compare("plane", plane_case(), 100, 1'000'000, figures);
  compare("space", space_case(), 100, 1'000'000, figures, kPaperSpace);
  compare("joints", joints_case(), quick ? 10 : 100, 5'000'000, figures);
  compare_nine("carry", bioloid::testing::kCarried, NineOptions{}.step, quick ? 10 : 100, quick ? 10'000 : 50'000, figures);
  compare_nine("swing", bioloid::testing::kOffGround, bioloid::testing::kDegree, quick ? 10 : 100, quick ? 10'000 : 50'000,
               figures);
  std::printf(
      "paper: space 300 movements to 94, 1 h to 2 s; nine joints 470 movements to 190, 16 h to 3 s (Octave or Matlab, Core i7 2.8 "
      "GHz)\n");
  report("bioloid_paper", figures);
}
