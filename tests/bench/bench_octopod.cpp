// The octopod's searches on the paper's terrain and on large ones: bench_octopod [--quick]
//
//   pa, pb   from P_O to P_A and P_B with stability: cold (postures and verdicts forgotten, terrain prepared) and kept; careless is
//            without stability
//   paper    `method: paper` with the paper's Newton postures, centroid tree and Newton equilibrium, in turns with ours; postures
//            are kept within its run, which the paper's times do not look like: the ratio is on the safe side
//   rrt, transitions, triangles from 1e3 to 1e5, boulders of 100,000 triangles over 14 m
//
// Times are of this thread's processor, ms, so that other work on the machine does not count.
#include <ctime>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>

#include "figures.hpp"
#include "foothold/robot_file.hpp"
#include "octopod/search/route.hpp"
#include "octopod/steps.hpp"
#include "terrain/generate.hpp"

namespace {

using namespace foothold::octopod;
using foothold::Vector3d;
using foothold::bench::Figure;
using foothold::bench::percentile;

const Vector3d kO(0.0, 0.0, -0.5), kA(0.0, 0.75, -0.2), kB(-1.0, -0.4, 0.2);
// The paper's, MATLAB 2015a on an i7-8750H: with and without stability.
constexpr double kPaperA = 544e3, kPaperB = 6240e3, kPaperCarelessA = 135e3, kPaperCarelessB = 290e3;

double now_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

template <class F>
double time_ms(F work) {
  const double begin = now_ms();
  work();
  return now_ms() - begin;
}

std::unique_ptr<Ground> ground_of(foothold::terrain::Terrain terrain, const GroundOptions& options) {
  static const Model model = Model::from_model(foothold::load_robot_model(FOOTHOLD_CONFIG_DIR "/robots/octopod.yaml"));
  struct Land {
    explicit Land(foothold::terrain::Terrain of) : terrain(std::move(of)), surface(terrain) {}
    foothold::terrain::Terrain terrain;
    foothold::terrain::Surface surface;
  };
  const auto land = std::make_shared<Land>(std::move(terrain));
  return std::make_unique<Ground>(model, std::shared_ptr<const foothold::terrain::Surface>(land, &land->surface), options);
}

State stable_at(const Ground& ground, const Vector3d& point) {
  const int node = ground.nearest_node(point);
  for (State state = kOrientations * node; state < kOrientations * (node + 1); ++state)
    if (ground.stable(state)) return state;
  return kOrientations * node;
}

struct Timed {
  Route route;
  std::vector<double> cold, kept;
};

Timed timed(const Ground& ground, const Vector3d& goal, const RouteOptions& options, int rounds) {
  Timed out;
  const State from = stable_at(ground, kO);
  const int node = ground.nearest_node(goal);
  for (int k = 0; k < rounds; ++k) {
    ground.forget();
    out.cold.push_back(time_ms([&] { out.route = optimal_route(ground, from, node, options, {}, {}); }));
    out.kept.push_back(time_ms([&] { optimal_route(ground, from, node, options, {}, {}); }));
  }
  return out;
}

// A line like those of the paper's figures 6 and 8.
void print_route(const char* name, const Ground& ground, const Route& route, double ms) {
  double length = 0.0, steepest = 0.0;
  int unstable = 0;
  for (std::size_t k = 0; k < route.states.size(); ++k) {
    if (k > 0) length += (ground.place(node_of(route.states[k])) - ground.place(node_of(route.states[k - 1]))).norm();
    steepest = std::max(steepest, ground.slope(node_of(route.states[k])));
    if (!ground.stable(route.states[k])) ++unstable;
  }
  const char* ends[] = {"found", "no path", "stopped", "exhausted"};
  std::printf("%-24s %-9s %9.4f %9.3f %6zu %8d %10.1f %11.3f\n", name, ends[static_cast<int>(route.end)], route.cost, length,
              route.states.size(), unstable, steepest * 180.0 / std::numbers::pi, ms);
}

struct Printed {
  std::vector<double> ours, port, search;  // ms; search: the paper's A* over our postures
  Route route, searched;
};

Printed as_printed(const Ground& ground, int rounds) {
  GroundOptions options;
  options.as_printed = true;
  const auto printed = ground_of(foothold::terrain::ramps(), options);
  const int node = ground.nearest_node(kA);
  Printed out;
  for (int k = 0; k < rounds; ++k) {
    const State from = stable_at(ground, kO);
    ground.forget();
    out.ours.push_back(time_ms([&] { optimal_route(ground, from, node, {}, {}, {}); }));
    ground.forget();
    out.search.push_back(time_ms([&] { out.searched = paper_route(ground, from, node, {}, {}); }));
    printed->forget();
    out.port.push_back(time_ms([&] { out.route = paper_route(*printed, from, node, {}, {}); }));
  }
  return out;
}

struct Walked {
  Route route;
  double ms = 0.0;
  long asked = 0;
};

// With transitions, for `budget` ms at most.
Walked walked(const Ground& ground, const Vector3d& goal, double budget) {
  Walked out;
  std::stop_source stop;
  const State from = stable_at(ground, kO);
  ground.forget();
  const double begin = now_ms();
  const Edge edge = [&](State a, State b) {
    ++out.asked;
    if (now_ms() - begin > budget) stop.request_stop();
    return has_transitions(ground, ground.standing(a).standing, ground.standing(b).standing, 0.04);
  };
  out.ms = time_ms([&] { out.route = optimal_route(ground, from, ground.nearest_node(goal), {}, edge, stop.get_token()); });
  return out;
}

void sizes(bool quick, std::vector<Figure>& figures) {
  std::printf("\nthe paper's terrain cut finer, P_A and P_B cold\n%10s %12s %12s %12s\n", "nodes", "prepare, ms", "P_A, ms",
              "P_B, ms");
  for (const double resolution : {0.2, 0.1, 0.05, 0.025}) {
    if (quick && resolution < 0.05) break;
    GroundOptions options;
    options.resolution = resolution;
    std::unique_ptr<Ground> ground;
    const double prepare = time_ms([&] { ground = ground_of(foothold::terrain::ramps(), options); });
    const double a = timed(*ground, kA, {}, 1).cold.front(), b = timed(*ground, kB, {}, 1).cold.front();
    std::printf("%10d %12.2f %12.2f %12.2f\n", ground->nodes(), prepare, a, b);
    const std::string nodes = std::to_string(ground->nodes());
    figures.push_back({"prepare_" + nodes, prepare, "ms", "less", {}, {}, ""});
    figures.push_back({"pa_cold_" + nodes, a, "ms", "less", {}, {}, ""});
    figures.push_back({"pb_cold_" + nodes, b, "ms", "less", {}, {}, ""});
  }
}

void boulders(std::vector<Figure>& figures) {
  foothold::terrain::Options terrain;
  terrain.size = 20.0;
  terrain.grid = 0.09;
  GroundOptions options;
  options.resolution = 10.0;  // as they are
  std::unique_ptr<Ground> ground;
  const double prepare =
      time_ms([&] { ground = ground_of(foothold::terrain::generate(foothold::terrain::Family::kBoulders, terrain), options); });
  const State from = stable_at(*ground, {-5.0, -5.0, 0.0});
  const int goal = ground->nearest_node({5.0, 5.0, 0.0});
  ground->forget();
  Route route;
  const double ms = time_ms([&] { route = optimal_route(*ground, from, goal, {}, {}, {}); });
  std::printf("\nboulders, %d triangles, prepared in %.1f ms\n", ground->nodes(), prepare);
  print_route("over 14 m", *ground, route, ms);
  figures.push_back({"boulders_100k", ms, "ms", "less", 2000.0, {}, ""});
  figures.push_back({"boulders_100k_prepare", prepare, "ms", "less", {}, {}, ""});
}

}  // namespace

int main(int count, char** words) {
  const bool quick = foothold::bench::quick(count, words);
  const int rounds = quick ? 15 : 101;
  std::vector<Figure> figures;
  const auto add = [&](const std::string& name, double value, const char* unit, std::optional<double> goal,
                       std::optional<double> paper, const char* better = "less") {
    figures.push_back({name, value, unit, better, goal, paper, paper ? "paper, MATLAB" : ""});
  };
  std::unique_ptr<Ground> ground;
  std::vector<double> prepare;
  for (int k = 0; k < rounds; ++k) prepare.push_back(time_ms([&] { ground = ground_of(foothold::terrain::ramps(), {}); }));

  std::printf("%-24s %-9s %9s %9s %6s %8s %10s %11s\n", "", "", "cost, m", "length, m", "nodes", "unstable", "slope, deg",
              "cold, ms");
  RouteOptions careless;
  careless.stability = false;
  RouteOptions gentle;  // over no steeper nodes than friction holds on a plane: round the steep faces
  gentle.steepest = steepest_held(0.4, 10);
  const struct {
    const char* name;
    Vector3d point;
    double cold_goal, paper, paper_careless;
  } points[] = {{"pa", kA, 10.0, kPaperA, kPaperCarelessA}, {"pb", kB, 30.0, kPaperB, kPaperCarelessB}};
  for (const auto& p : points) {
    const std::string name = p.name;
    const Timed stable = timed(*ground, p.point, {}, rounds), steep = timed(*ground, p.point, careless, rounds),
                round = timed(*ground, p.point, gentle, rounds);
    print_route(p.name, *ground, stable.route, percentile(stable.cold, 0.5));
    print_route((name + " gentle nodes").c_str(), *ground, round.route, percentile(round.cold, 0.5));
    print_route((name + " careless").c_str(), *ground, steep.route, percentile(steep.cold, 0.5));
    add(name + "_cold", percentile(stable.cold, 0.5), "ms", p.cold_goal, p.paper);
    add(name + "_cold_p99", percentile(stable.cold, 0.99), "ms", {}, {});
    add(name + "_kept", percentile(stable.kept, 0.5), "ms", p.point == kA ? std::optional(1.0) : std::nullopt, {});
    add(name + "_gentle_cold", percentile(round.cold, 0.5), "ms", {}, {});
    add(name + "_gentle_kept", percentile(round.kept, 0.5), "ms", {}, {});
    add(name + "_careless_cold", percentile(steep.cold, 0.5), "ms", {}, p.paper_careless);
    add(name + "_postures", static_cast<double>(stable.route.postures), "1", {}, {});
    for (const bool stability : {true, false}) {
      RouteOptions options;
      options.stability = stability;
      Route route;
      ground->forget();
      const double ms =
          time_ms([&] { route = paper_route(*ground, stable_at(*ground, kO), ground->nearest_node(p.point), options, {}); });
      print_route((name + (stability ? " paper's A*" : " careless, paper's A*")).c_str(), *ground, route, ms);
      if (stability) add(name + "_paper_cost_over_ours", route.cost / stable.route.cost, "1", {}, {}, "more");
    }
    std::mt19937_64 random(1);
    Route tree;
    ground->forget();
    const double ms =
        time_ms([&] { tree = rrt_route(*ground, stable_at(*ground, kO), ground->nearest_node(p.point), {}, random, {}); });
    print_route((name + " rrt").c_str(), *ground, tree, ms);
    add(name + "_rrt", ms, "ms", {}, {});
    if (tree.end == Route::End::kFound) add(name + "_rrt_cost_over_ours", tree.cost / stable.route.cost, "1", {}, {});
    const Walked way = walked(*ground, p.point, quick ? 2e3 : 60e3);
    print_route((name + " transitions").c_str(), *ground, way.route, way.ms);
    std::printf("  %ld edges asked, proved at least %.4f m%s%s\n", way.asked, way.route.bound,
                way.route.blocked.empty() ? "" : ": ", way.route.blocked.c_str());
    add(name + "_transitions", way.ms, "ms", {}, {});
    add(name + "_transitions_found", way.route.end == Route::End::kFound ? 1.0 : 0.0, "1", {}, {}, "more");
  }

  const Printed printed = as_printed(*ground, quick ? 3 : 9);
  std::printf(
      "\nthe paper's method with its own postures and equilibrium, P_A, ms: %.1f; its A* over our postures %.2f; ours %.2f\n",
      percentile(printed.port, 0.5), percentile(printed.search, 0.5), percentile(printed.ours, 0.5));
  add("paper_port_over_ours", percentile(printed.port, 0.5) / percentile(printed.ours, 0.5), "1", 50.0, {}, "more");
  add("paper_port", percentile(printed.port, 0.5), "ms", {}, kPaperA);
  add("paper_search_over_ours", percentile(printed.search, 0.5) / percentile(printed.ours, 0.5), "1", {}, {}, "more");
  add("prepare", percentile(prepare, 0.5), "ms", {}, {});
  sizes(quick, figures);
  boulders(figures);
  foothold::bench::report("octopod", figures);
}
