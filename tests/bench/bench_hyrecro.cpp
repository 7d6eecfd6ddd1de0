// HyReCRo's planner against the paper's method and against its own goals: bench_hyrecro [--quick]
//
//   online      plans on the paper's crossed beams (its Figure 10) without motions, over many starts and goals, scene prepared;
//   ours
//               and the faithful port of the paper's method in turns, on the same requests
//   prepare     what a scene costs before the first plan; the planar workspace, which depends on the robot alone, is kept
//   truss_200   plans on generated trusses of 200 beams; and time and memory from 2 to 2,000 beams
//   first_step  from submit() to the client's first step, over DDS
//   tables      the paper's tables 1 and 2 and its Figure 11 (hyrecro_tables.hpp); its networks (hyrecro_network.hpp)
#include <chrono>
#include <cstdio>
#include <numeric>
#include <random>

#include "figures.hpp"
#include "foothold/robot_file.hpp"
#include "geometry/polygon_path.hpp"
#include "hyrecro/scene/random_foothold.hpp"
#include "hyrecro_first_step.hpp"
#include "hyrecro_network.hpp"
#include "hyrecro_online.hpp"
#include "hyrecro_tables.hpp"
#include "truss/generate.hpp"

namespace {

using namespace foothold;
using namespace foothold::bench;
using namespace foothold::hyrecro;
using Clock = std::chrono::steady_clock;
using Reached = PlanReport::Outcome;

// The paper's, on a Ryzen 7 5800U in Python: the whole online part on its Figure 10, preprocessing, one PPIC of 12 vertices.
constexpr double kPaperOnlineMs = 700.7, kPaperPrepareMs = 137.0, kPaperPpicUs = 944.0, kPaperSteps = 11.0;

double ms_since(Clock::time_point begin) { return std::chrono::duration<double, std::milli>(Clock::now() - begin).count(); }

Scene crossed_beams() { return {"", "", "yaml", FOOTHOLD_CONFIG_DIR "/scenes/truss-crossed-beams.yaml"}; }

struct Online {
  std::vector<double> ours, port;  // ms
  std::vector<double> steps_ours, steps_port, prepare;
  double first = 0.0;  // ms, the first plan on a scene
  int unsolved = 0, port_unsolved = 0, worse = 0;
};

// Ours and the port on each request in turn, `rounds` times.
Online online(HyrecroPlanner& planner, const std::vector<Request>& requests, int rounds) {
  const Parameters ours = hyrecro_parameters({{"motion", "false"}});
  const Parameters port = hyrecro_parameters({{"motion", "false"}, {"method", "paper"}, {"reachability", "network"}});
  Online out;
  std::shared_ptr<const PreparedScene> scene;
  for (int k = 0; k < 20 * rounds; ++k) {
    const auto begin = Clock::now();
    scene = planner.prepare(crossed_beams(), ours);
    out.prepare.push_back(ms_since(begin));
  }
  const auto ports_scene = planner.prepare(crossed_beams(), port);
  out.first = timed_plan(planner, requests.front(), ours, *scene).ms;
  timed_plan(planner, requests.front(), port, *ports_scene);
  for (int round = 0; round < rounds; ++round)
    for (const Request& request : requests) {
      const Timed a = timed_plan(planner, request, ours, *scene);
      const Timed b = timed_plan(planner, request, port, *ports_scene);
      out.ours.push_back(a.ms);
      out.port.push_back(b.ms);
      if (a.report.outcome != Reached::kReached) ++out.unsolved;
      if (b.report.outcome != Reached::kReached) ++out.port_unsolved;
      if (a.report.outcome != Reached::kReached || b.report.outcome != Reached::kReached) continue;
      out.steps_ours.push_back(static_cast<double>(a.steps));
      out.steps_port.push_back(static_cast<double>(b.steps));
      if (a.steps > b.steps) ++out.worse;
    }
  return out;
}

std::vector<double> with_motion(HyrecroPlanner& planner, const std::vector<Request>& requests, int& unsolved) {
  const Parameters values = hyrecro_parameters({{"motion", "true"}});
  const auto scene = planner.prepare(crossed_beams(), values);
  timed_plan(planner, requests.front(), values, *scene);
  std::vector<double> out;
  for (const Request& request : requests) {
    const Timed timed = timed_plan(planner, request, values, *scene);
    out.push_back(timed.ms);
    if (timed.report.outcome != Reached::kReached) ++unsolved;
  }
  return out;
}

double mean(const std::vector<double>& values) {
  return values.empty() ? 0.0 : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

// A star of twelve vertices, every second one reflex, and ways between points of it that do not see each other for the most part.
double ppic_us(int queries) {
  geometry::Polygon star;
  for (int k = 0; k < 12; ++k) {
    const double angle = k * std::numbers::pi / 6.0, radius = k % 2 == 0 ? 1.0 : 0.45;
    star.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  const geometry::PolygonPaths paths(star);
  std::mt19937_64 random(12);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  std::vector<Eigen::Vector2d> points;
  while (points.size() < 1000)
    if (const Eigen::Vector2d p(unit(random), unit(random)); paths.holds(p)) points.push_back(p);
  std::vector<double> batches;
  double sum = 0.0;
  for (int batch = 0; batch < queries / 1000; ++batch) {
    const auto begin = Clock::now();
    for (std::size_t k = 0; k < points.size(); ++k) sum += paths.length(points[k], points[(k + 7) % points.size()]);
    batches.push_back(ms_since(begin));
  }
  if (!std::isfinite(sum)) std::printf("a way of no length\n");
  return percentile(batches, 0.5);  // ms for a thousand is us for one
}

struct Size {
  int beams = 0, faces = 0;
  std::vector<double> prepare, first, again;  // ms
  double memory = 0.0;                        // MB
  int reached = 0, asked = 0;
};

// Plans between random footholds on generated trusses of `beams` beams: on a fresh scene, and once more; each for `budget` (s) at
// most.
Size on_trusses(HyrecroPlanner& planner, const Model& model, int beams, int trusses, int requests, double budget) {
  const Parameters values = hyrecro_parameters({{"motion", "false"}});
  Size out{.beams = beams};
  for (int t = 0; t < trusses; ++t) {
    const auto seed = static_cast<std::uint64_t>(beams + t);
    const truss::Truss truss = truss::build(truss::generate(static_cast<truss::Family>(t % 3), seed, beams));
    out.faces = static_cast<int>(truss.faces.size());
    const double before = resident_mb();
    const auto begin = Clock::now();
    const PreparedTruss scene(model, truss, SamplingOptions{}, values.real("clearance"));
    out.prepare.push_back(ms_since(begin));
    std::mt19937_64 random(seed);
    for (int k = 0; k < requests; ++k) {
      const auto start = random_foothold(model, truss, random), goal = random_foothold(model, truss, random);
      if (!start || !goal) continue;
      Request request = hyrecro_request(pose_of(truss, *start), pose_of(truss, *goal));
      request.budget = budget;
      try {
        const Timed first = timed_plan(planner, request, values, scene);
        out.first.push_back(first.ms);
        ++out.asked;
        if (first.report.outcome != Reached::kReached) continue;
        ++out.reached;
        out.again.push_back(timed_plan(planner, request, values, scene).ms);
      } catch (const InvalidRequest&) {
        continue;  // no room for the robot there
      }
    }
    out.memory = std::max(out.memory, resident_mb() - before);
  }
  return out;
}

// 0 where nothing could be measured.
double part_of(const std::vector<double>& values, double part) { return values.empty() ? 0.0 : percentile(values, part); }

void print_sizes(const std::vector<Size>& sizes) {
  std::printf("\nbeams   faces  prepare ms  plan ms, fresh: median      p99  again: median  memory MB  reached\n");
  for (const Size& s : sizes)
    std::printf("%5d  %6d  %10.2f  %22.2f %8.2f %14.2f %10.1f  %d of %d\n", s.beams, s.faces, part_of(s.prepare, 0.5),
                part_of(s.first, 0.5), part_of(s.first, 0.99), part_of(s.again, 0.5), s.memory, s.reached, s.asked);
}

}  // namespace

int main(int count, char** words) {
  const bool quick = foothold::bench::quick(count, words);
  const RobotModel numbers = load_robot_model(FOOTHOLD_CONFIG_DIR "/robots/hyrecro.yaml");
  const Model model = Model::from_model(numbers);
  HyrecroPlanner planner(numbers);
  std::vector<Figure> figures;
  const auto add = [&](const char* name, double value, const char* unit, std::optional<double> goal, std::optional<double> paper) {
    figures.push_back({name, value, unit, "less", goal, paper, paper ? "paper, Python" : ""});
  };

  const std::vector<Request> requests = crossed_beams_requests(quick ? 20 : 100);
  const Online o = online(planner, requests, quick ? 2 : 10);
  std::printf(
      "crossed beams, %zu plans: ours median %.3f, p99 %.3f ms, first %.2f ms; the paper's method median %.3f, p99 %.3f ms\n",
      o.ours.size(), percentile(o.ours, 0.5), percentile(o.ours, 0.99), o.first, percentile(o.port, 0.5), percentile(o.port, 0.99));
  std::printf(
      "steps where both reach the goal: ours %.2f, the paper's method %.2f, ours more in %d; without a plan: ours %d, the paper's "
      "%d\n",
      mean(o.steps_ours), mean(o.steps_port), o.worse, o.unsolved, o.port_unsolved);
  add("online_median", percentile(o.ours, 0.5), "ms", 1.0, kPaperOnlineMs);
  add("online_p99", percentile(o.ours, 0.99), "ms", 3.0, kPaperOnlineMs);
  add("online_first", o.first, "ms", {}, kPaperOnlineMs);
  add("prepare", percentile(o.prepare, 0.5), "ms", 2.0, kPaperPrepareMs);
  add("paper_port_median", percentile(o.port, 0.5), "ms", {}, kPaperOnlineMs);
  figures.push_back({"paper_port_over_ours", percentile(o.port, 0.5) / percentile(o.ours, 0.5), "1", "more", {}, {}, {}});
  if (!o.steps_ours.empty()) {
    add("steps_ours_mean", mean(o.steps_ours), "1", {}, {});
    add("steps_paper_port_mean", mean(o.steps_port), "1", {}, {});
  }
  add("steps_more_than_paper_port", o.worse, "1", 0.0, {});
  add("online_unsolved", o.unsolved, "1", {}, {});
  add("paper_port_unsolved", o.port_unsolved, "1", {}, {});

  int without_motion = 0;
  const std::vector<double> moved = with_motion(planner, requests, without_motion);
  add("with_motion", percentile(moved, 0.5), "ms", 50.0, {});
  add("with_motion_p99", percentile(moved, 0.99), "ms", {}, {});
  add("without_motion", without_motion, "1", {}, {});
  add("ppic_12_vertices", ppic_us(quick ? 20000 : 200000), "us", 1.0, kPaperPpicUs);

  for (const char* vendor : {"cyclone", "fastdds"}) {
    const std::string suffix = vendor == std::string("cyclone") ? "" : "_fastdds";
    add(("first_step" + suffix).c_str(), percentile(first_steps(vendor, false, quick ? 30 : 200), 0.5), "ms", 5.0, {});
    add(("first_step_with_motion" + suffix).c_str(), percentile(first_steps(vendor, true, quick ? 10 : 50), 0.5), "ms", 5.0, {});
  }
  for (const Figure& figure : hyrecro_tables(quick)) figures.push_back(figure);
  for (const Figure& figure : hyrecro_network_figures(quick)) figures.push_back(figure);
  std::vector<Size> sizes;
  const std::vector<int> all{2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000}, few{2, 20, 200};
  for (const int beams : quick ? few : all) {
    sizes.push_back(quick ? on_trusses(planner, model, beams, 1, 2, 2.0) : on_trusses(planner, model, beams, 2, 2, 10.0));
    if (beams != 200) continue;
    if (sizes.back().asked == 0) continue;
    add("truss_200", percentile(sizes.back().first, 0.5), "ms", 20.0, {});
    add("truss_200_p99", percentile(sizes.back().first, 0.99), "ms", {}, {});
    add("truss_200_prepare", percentile(sizes.back().prepare, 0.5), "ms", {}, {});
    if (!sizes.back().again.empty()) add("truss_200_again", percentile(sizes.back().again, 0.5), "ms", {}, {});
    add("truss_200_unsolved", sizes.back().asked - sizes.back().reached, "1", {}, {});
  }
  print_sizes(sizes);

  report("hyrecro", figures);
}
