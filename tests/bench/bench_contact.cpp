// Static equilibrium against CLP and the octopod paper's Newton method, on the same stances in turn. bench_contact [--quick]
//
// Each method judges each stance once a pass; a stance's time is the median over the passes, so that what else the machine does is
// not counted; figures are over the stances. The clock's own reading, some 25 ns, is in every time. What a method judges is read
// once before its time is taken, as a planner has just made it: otherwise the first method of a stance waits for memory in place of
// the others. CLP keeps its model and starts from its slack basis; making its columns is not in its time.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <string>

#include "contact/critical_friction.hpp"
#include "contact/newton.hpp"
#include "contact/projection.hpp"
#include "contact/robustness.hpp"
#include "figures.hpp"
#include "oracles.hpp"
#include "stances.hpp"

namespace {

using namespace foothold::contact;
using foothold::bench::Figure;
using foothold::bench::percentile;
using Clock = std::chrono::steady_clock;

constexpr int kEdges = 10, kContacts = 8;
constexpr std::size_t kBlock = 100;
constexpr double kApart = 0.005;  // of neighbouring stances, m and rad

struct Case {
  Stance here, next;
  Generators columns;
};

std::vector<Case> cases(int count) {
  std::mt19937_64 random(88);
  std::vector<Case> out;
  for (int i = 0; i < count; ++i) {
    Case c;
    c.here = random_stance(random, kContacts);
    c.next = neighbour(random, c.here, kApart);
    c.columns = generators(c.here, kEdges);
    out.push_back(std::move(c));
  }
  return out;
}

double sum_of(const Stance& s) {
  double sum = s.com.sum() + s.mu;
  for (const Contact& c : s.contacts) sum += c.point.sum() + c.normal.sum();
  return sum;
}

// One method: what it does before its time is taken, and its verdict.
struct Method {
  std::string name;
  std::function<void(const Case&)> before;
  std::function<bool(const Case&)> judge;
  std::vector<std::vector<double>> us;  // by stance, of each pass
  std::vector<char> verdicts;
  volatile double read = 0.0;

  void time(const Case& c, std::size_t index) {
    read = sum_of(c.here) + sum_of(c.next) + c.columns.sum();
    if (before) before(c);
    const auto start = Clock::now();
    const bool verdict = judge(c);
    us[index].push_back(std::chrono::duration<double, std::micro>(Clock::now() - start).count());
    verdicts[index] = verdict ? 1 : 0;
  }

  // Over the stances whose verdict by `other` is as wanted; all of them without one.
  [[nodiscard]] std::vector<double> medians(const Method* other = nullptr, bool wanted = true) const {
    std::vector<double> out;
    for (std::size_t i = 0; i < us.size(); ++i)
      if (other == nullptr || (other->verdicts[i] != 0) == wanted) out.push_back(percentile(us[i], 0.5));
    return out;
  }
};

int differing(const Method& a, const Method& b) {
  int out = 0;
  for (std::size_t i = 0; i < a.verdicts.size(); ++i) out += a.verdicts[i] != b.verdicts[i] ? 1 : 0;
  return out;
}

void print(const Method& m) {
  const std::vector<double> all = m.medians();
  double sum = 0.0;
  for (const double value : all) sum += value;
  std::printf("%-34s %9.3f %9.3f %9.3f %9.3f\n", m.name.c_str(), percentile(all, 0.5), sum / static_cast<double>(all.size()),
              percentile(all, 0.99), percentile(all, 1.0));
}

}  // namespace

int main(int count, char** words) {
  const bool quick = foothold::bench::quick(count, words);
  const std::vector<Case> all = cases(quick ? 500 : 4000);
  const int passes = quick ? 5 : 9;

  Equilibrium pyramid(FrictionCone::pyramid(kEdges)), circle(FrictionCone::circular()), fine(FrictionCone::pyramid(64));
  NewtonEquilibrium newton({.edges = kEdges});
  Clp primal, dual;
  std::mt19937_64 random(89);
  const auto judged = [](Equilibrium& e, const Stance& s) { return e.judge(s.contacts, s.com, s.mu).stable; };
  const auto cold = [&](Equilibrium& e) {
    return Method{"", [&e](const Case&) { e.forget(); }, [&](const Case& c) { return judged(e, c.here); }};
  };
  const auto warm = [&](Equilibrium& e) {
    return Method{"", [&](const Case& c) { judged(e, c.here); }, [&](const Case& c) { return judged(e, c.next); }};
  };
  std::vector<Method> methods{
      cold(pyramid),
      warm(pyramid),
      cold(circle),
      warm(circle),
      cold(fine),
      {"", nullptr, [&](const Case& c) { return primal.holds(c.columns, Wrench::Unit(2)); }},
      {"", nullptr, [&](const Case& c) { return dual.holds_by_dual(c.columns, Wrench::Unit(2)); }},
      {"", nullptr, [&](const Case& c) { return newton.stable(c.here.contacts, c.here.com, c.here.mu, random); }},
      {"", nullptr,
       [&](const Case& c) { return judge_by_projection(c.here.contacts, c.here.com, c.here.mu, pyramid.cone()).stable; }},
      {"", nullptr, [&](const Case& c) { return critical_friction(circle, c.here.contacts, c.here.com).mu <= c.here.mu; }},
      {"", nullptr, [&](const Case& c) { return support_margin(pyramid, c.here.contacts, c.here.com, c.here.mu).value > 0.0; }},
  };
  const char* names[] = {"ours, 10 edges, cold",  "ours, 10 edges, warm", "ours, circular, cold",    "ours, circular, warm",
                         "ours, 64 edges, cold",  "CLP primal, 10 edges", "CLP dual, 10 edges",      "paper's Newton, 10 edges",
                         "nearest wrench (NNLS)", "critical friction",    "support margin, 10 edges"};
  for (std::size_t m = 0; m < methods.size(); ++m) {
    methods[m].name = names[m];
    methods[m].us.resize(all.size());
    methods[m].verdicts.resize(all.size());
  }
  for (int pass = 0; pass < passes; ++pass)
    for (std::size_t block = 0; block < all.size(); block += kBlock)
      for (Method& m : methods)
        for (std::size_t i = block; i < std::min(all.size(), block + kBlock); ++i) m.time(all[i], i);

  std::printf("%zu stances of %d contacts, %d passes, us\n%-34s %9s %9s %9s %9s\n", all.size(), kContacts, passes, "", "median",
              "mean", "p99", "worst");
  for (const Method& m : methods) print(m);
  const auto median = [&](std::size_t m) { return percentile(methods[m].medians(), 0.5); };
  const auto p99 = [&](std::size_t m) { return percentile(methods[m].medians(), 0.99); };
  const Method &ours = methods[0], &paper = methods[7];
  int missed = 0, stable = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    stable += ours.verdicts[i] != 0 ? 1 : 0;
    missed += ours.verdicts[i] != 0 && paper.verdicts[i] == 0 ? 1 : 0;
  }
  std::printf("stable: %d; the paper's Newton calls %d of them unstable; CLP differs from ours on %d\n", stable, missed,
              differing(ours, methods[5]));

  const double clp = std::min(median(5), median(6));
  std::vector<Figure> figures;
  const auto add = [&](const char* name, double value, const char* unit, const char* better, std::optional<double> goal,
                       std::optional<double> baseline = {}, const char* baseline_name = "") {
    figures.push_back({name, value, unit, better, goal, baseline, baseline_name});
  };
  add("cold_median", median(0), "us", "less", 1.0, clp, "CLP");
  add("warm_median", median(1), "us", "less", 0.25, median(0), "cold");
  add("cold_p99", p99(0), "us", "less", 4.0, std::min(p99(5), p99(6)), "CLP");
  add("warm_p99", p99(1), "us", "less", {});
  add("clp_over_ours", clp / median(0), "1", "more", 80.0);
  add("clp_dual_over_ours", median(6) / median(0), "1", "more", {});
  add("newton_over_ours", median(7) / median(0), "1", "more", 15.0);
  add("newton_over_ours_stable", percentile(paper.medians(&ours, true), 0.5) / percentile(ours.medians(&ours, true), 0.5), "1",
      "more", {});
  add("newton_over_ours_unstable", percentile(paper.medians(&ours, false), 0.5) / percentile(ours.medians(&ours, false), 0.5), "1",
      "more", {});
  add("newton_median", median(7), "us", "less", {});
  add("newton_missed", missed, "1", "less", {});
  add("circular_cold_median", median(2), "us", "less", {}, 4.1, "active set, measured earlier");
  add("circular_cold_p99", p99(2), "us", "less", {});
  add("circular_warm_median", median(3), "us", "less", {});
  add("edges_64_cold_median", median(4), "us", "less", {});
  add("nearest_wrench_median", median(8), "us", "less", {});
  add("critical_friction_median", median(9), "us", "less", {});
  add("support_margin_median", median(10), "us", "less", {});
  add("clp_median", median(5), "us", "less", {});
  add("clp_disagreements", differing(ours, methods[5]), "1", "less", 0.0);
  foothold::bench::report("contact", figures);
}
