// See hyrecro_tables.hpp. The paper: Python, AMD Ryzen 7 5800U.
#include "hyrecro_tables.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <string>

#include "foothold/robot_file.hpp"
#include "hyrecro/paper/paper.hpp"
#include "hyrecro/paper/way.hpp"
#include "hyrecro_zigzags.hpp"

namespace foothold::bench {
namespace {

using namespace foothold::hyrecro;
using Clock = std::chrono::steady_clock;

constexpr double kClearance = 0.005;      // m
constexpr double kNone = -1.0;            // the paper gives no figure
constexpr double kPaperOnline = 700.743;  // ms

double ms_since(Clock::time_point start) { return std::chrono::duration<double, std::milli>(Clock::now() - start).count(); }

// Discretisations of one row of table 2, and what the paper measured with them.
struct Setting {
  const char* changed;
  double potential;  // m, between potential transition footholds
  double position;   // m, of the planar workspace
  double heading;    // deg
  struct Printed {
    double prepare, ppt, f1, f2, f3, total;  // ms
    int steps;
  } printed;
};

constexpr Setting kSettings[] = {
    {"as in the paper", 0.05, 0.01, 5, {136.999, 688.478, 3.160, 7.792, 1.313, 837.742, 11}},
    {"potential points 0.150 m", 0.15, 0.01, 5, {84.498, 153.899, 2.932, 989.954, 1.121, 1232.404, 13}},
    {"potential points 0.100 m", 0.10, 0.01, 5, {105.473, 294.708, 2.910, 7.403, 1.299, 411.793, 11}},
    {"potential points 0.070 m", 0.07, 0.01, 5, {128.936, 527.592, 2.946, 7.539, 1.318, 668.331, 11}},
    {"potential points 0.030 m", 0.03, 0.01, 5, {271.241, 1686.992, 8.653, 13.307, 6.081, 1986.274, 11}},
    {"workspace 0.050 m", 0.05, 0.05, 5, {kNone, kNone, kNone, kNone, kNone, kNone, 0}},
    {"workspace 0.030 m", 0.05, 0.03, 5, {136.981, 678.223, 2.194, 7.003, 1.106, 825.507, 12}},
    {"workspace 0.005 m", 0.05, 0.005, 5, {135.894, 690.109, 9.606, 27.750, 7.992, 871.351, 11}},
    {"workspace 20 deg", 0.05, 0.01, 20, {134.583, 682.909, 1.601, 6.125, 1.198, 826.416, 12}},
    {"workspace 10 deg", 0.05, 0.01, 10, {135.104, 688.911, 2.912, 7.329, 1.002, 835.258, 11}},
    {"workspace 2 deg", 0.05, 0.01, 2, {136.004, 694.291, 4.928, 11.583, 3.136, 849.942, 11}},
};

struct Ends {
  Foothold start, goal;
};

Foothold stand(const truss::Truss& truss, const Vector3d& at, const Vector3d& normal, const Vector3d& forward) {
  Isometry3d pose = Isometry3d::Identity();
  pose.linear() << forward, normal.cross(forward), normal;
  pose.translation() = at;
  return foothold_at(truss, pose, 1e-6).value();
}

// Figure 10's problem on our beams: as in requests/hyrecro-crossed-beams.yaml, but the goal is turned across, so that the last face
// needs the additional foothold that the paper describes. Where the paper's beams cross is not printed; our ways are shorter.
Ends figure_10(const truss::Truss& truss) {
  return {stand(truss, {0.2, -0.075, 0.0}, -Vector3d::UnitY(), Vector3d::UnitX()),
          stand(truss, {1.425, 0.0, 0.43}, -Vector3d::UnitX(), Vector3d::UnitY())};
}

struct Measured {
  double prepare = 0.0, online = 0.0, ppt = 0.0, workspace = 0.0;  // ms
  std::array<double, 3> ppi{};
  std::size_t steps = 0, wrong = 0;
  std::string failure;
};

// Steps whose joints do not put the sole where the step says: what check() refuses.
std::size_t wrong_steps(const Model& model, const truss::Truss& truss, const Route& route) {
  std::size_t count = 0;
  Isometry3d holding = pose_of(truss, route.start);
  for (const Stride& stride : route.strides) {
    const Isometry3d wanted = pose_of(truss, stride.to);
    count += ((holding * forward(model, stride.coordinates)).translation() - wanted.translation()).norm() > 1e-6;
    holding = wanted;
  }
  return count;
}

class Bench {
 public:
  explicit Bench(int repetitions)
      : repetitions_(repetitions), model_(Model::from_model(load_robot_model(FOOTHOLD_CONFIG_DIR "/robots/hyrecro.yaml"))) {}

  Measured run(const Setting& setting, const truss::Truss& truss, Reachability& reachability) {
    Measured out;
    const auto workspace = workspace_of(setting.position, setting.heading, &out.workspace);
    SamplingOptions sampling;
    sampling.step = setting.potential;
    std::unique_ptr<PreparedTruss> scene;
    for (int k = 0; k < repetitions_; ++k) {
      const auto begin = Clock::now();
      scene = std::make_unique<PreparedTruss>(model_, truss, sampling, kClearance);
      out.prepare += ms_since(begin) / repetitions_;
    }
    scene->workspace = workspace;
    const Ends ends = figure_10(scene->truss);
    // The first plan makes what is kept of the faces and of the workspace.
    Found found = plan_paper(model_, *scene, reachability, ends.start, ends.goal, {}, {}, {});
    if (found.outcome != Found::Outcome::kReached) {
      out.failure = found.failure.message;
      return out;
    }
    out.steps = found.route.strides.size();
    out.wrong = wrong_steps(model_, scene->truss, found.route);
    for (int k = 0; k < repetitions_; ++k) {
      PaperTimes times;
      const auto begin = Clock::now();
      found = plan_paper(model_, *scene, reachability, ends.start, ends.goal, {}, {}, {}, &times);
      out.online += ms_since(begin) / repetitions_;
      out.ppt += times.ppt / repetitions_;
      for (std::size_t f = 0; f < std::min(times.ppi.size(), out.ppi.size()); ++f) out.ppi[f] += times.ppi[f] / repetitions_;
    }
    return out;
  }

  std::shared_ptr<const PlanarWorkspace> workspace_of(double position, double heading, double* ms = nullptr) {
    auto& [workspace, took] = workspaces_[{position, heading}];
    if (!workspace) {
      const auto begin = Clock::now();
      workspace = std::make_shared<const PlanarWorkspace>(
          *PlanarWorkspace::make(model_, position, heading * std::numbers::pi / 180.0, kClearance));
      took = ms_since(begin);
    }
    if (ms) *ms = took;
    return workspace;
  }

  const Model& model() const { return model_; }
  int repetitions() const { return repetitions_; }

 private:
  int repetitions_;
  Model model_;
  std::map<std::pair<double, double>, std::pair<std::shared_ptr<const PlanarWorkspace>, double>> workspaces_;
};

std::string number(double value) {
  if (value == kNone) return "-";
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", value);
  return text;
}

void table_1(Bench& bench, const truss::Truss& truss, std::vector<Figure>& figures) {
  const Measured network = bench.run(kSettings[0], truss, *make_network(bench.model()));
  const Measured exact = bench.run(kSettings[0], truss, *make_exact(bench.model(), kClearance));
  const Setting::Printed& paper = kSettings[0].printed;
  std::printf("\nTable 1: mean times of %d repetitions, ms, crossed beams\n%-44s %10s %15s %15s\n", bench.repetitions(), "",
              "paper", "ours, network", "ours, exact");
  const auto row = [](const char* what, double printed, double by_network, double by_exact) {
    std::printf("%-44s %10s %15.3f %15.3f\n", what, number(printed).c_str(), by_network, by_exact);
  };
  row("2.3  preprocessing of the structure", paper.prepare, network.prepare, exact.prepare);
  row("3    whole algorithm (online)", kPaperOnline, network.online, exact.online);
  row("3.1  transition planner (PPT)", paper.ppt, network.ppt, exact.ppt);
  row("3.2  intermediate planner (PPI), F1", paper.f1, network.ppi[0], exact.ppi[0]);
  row("3.2  intermediate planner (PPI), F2", paper.f2, network.ppi[1], exact.ppi[1]);
  row("3.2  intermediate planner (PPI), F3", paper.f3, network.ppi[2], exact.ppi[2]);
  row("     steps", paper.steps, static_cast<double>(network.steps), static_cast<double>(exact.steps));
  row("     of these refused by check()", kNone, static_cast<double>(network.wrong), static_cast<double>(exact.wrong));
  for (const Measured* one : {&network, &exact}) {
    const std::string name = one == &network ? "_network" : "";
    if (!one->failure.empty()) std::printf("%s\n", one->failure.c_str());
    const auto add = [&](const char* what, double value, const char* unit, double printed) {
      figures.push_back({what + name, value, unit, "less", std::nullopt, printed, "paper"});
    };
    add("table1_prepare", one->prepare, "ms", paper.prepare);
    add("table1_online", one->online, "ms", kPaperOnline);
    add("table1_ppt", one->ppt, "ms", paper.ppt);
    add("table1_ppi", one->ppi[0] + one->ppi[1] + one->ppi[2], "ms", paper.f1 + paper.f2 + paper.f3);
    add("table1_steps", static_cast<double>(one->steps), "", paper.steps);
    figures.push_back({"table1_wrong_steps" + name, static_cast<double>(one->wrong), "", "less", std::nullopt, std::nullopt, ""});
  }
}

void table_2(Bench& bench, const truss::Truss& truss, std::vector<Figure>& figures) {
  std::printf("\nTable 2: discretisations, crossed beams; each figure: ours, then (paper); ms, means of %d repetitions\n",
              bench.repetitions());
  std::printf("%-26s %19s %19s %17s %18s %17s %20s %9s %12s\n", "", "preprocessing", "PPT", "PPI F1", "PPI F2", "PPI F3", "total",
              "steps", "workspace");
  const auto exact = make_exact(bench.model(), kClearance);
  for (const Setting& setting : kSettings) {
    const Measured ours = bench.run(setting, truss, *exact);
    const Setting::Printed& paper = setting.printed;
    const auto cell = [](double measured, double printed, int width) {
      std::printf(" %*s", width, (number(measured) + " (" + number(printed) + ")").c_str());
    };
    std::printf("%-26s", setting.changed);
    cell(ours.prepare, paper.prepare, 19);
    if (!ours.failure.empty()) {
      std::printf(" does not end: %s (paper: %s)\n", ours.failure.c_str(),
                  paper.steps == 0 ? "does not converge" : (std::to_string(paper.steps) + " steps").c_str());
      continue;
    }
    cell(ours.ppt, paper.ppt, 19);
    cell(ours.ppi[0], paper.f1, 17);
    cell(ours.ppi[1], paper.f2, 18);
    cell(ours.ppi[2], paper.f3, 17);
    cell(ours.prepare + ours.online, paper.total, 20);
    std::printf(" %9s %12.1f\n",
                (std::to_string(ours.steps) + " (" + (paper.steps == 0 ? "none" : std::to_string(paper.steps)) + ")").c_str(),
                ours.workspace);
    if (setting.potential != 0.05)
      figures.push_back({"table2_potential_" + std::to_string(static_cast<int>(std::lround(setting.potential * 1e3))) + "_mm",
                         ours.prepare + ours.online, "ms", "less", std::nullopt, paper.total, "paper"});
  }
  std::printf("(workspace: made once for the robot, ms; not part of the paper's figures either)\n");
}

void figure_11(Bench& bench, std::vector<Figure>& figures) {
  PreparedTruss scene(bench.model(), truss::read_truss(FOOTHOLD_CONFIG_DIR "/scenes/truss-turns.yaml"), {}, kClearance);
  scene.workspace = bench.workspace_of(0.01, 5);
  // As in requests/hyrecro-turns.yaml.
  const Foothold from = stand(scene.truss, {0.15, 0.15, 0.0}, Vector3d::UnitZ(), Vector3d::UnitX());
  const Foothold to = stand(scene.truss, {1.8, 0.162, 0.0}, Vector3d::UnitZ(), -Vector3d::UnitY());

  const truss::Face& face = scene.truss.faces[static_cast<std::size_t>(from.face)];
  const Region region = shrunk(face, PaperOptions{}.safe_inset).at(0);
  const geometry::PolygonPaths kept(region.outline, region.holes);
  std::vector<Vector2d> way;
  const auto per_call = [&](auto work, int calls) {
    const auto begin = Clock::now();
    for (int k = 0; k < calls; ++k) work();
    return ms_since(begin) / calls;
  };
  const int calls = 100 * bench.repetitions();
  std::printf("\nFigure 11 (a): continuous way on the face with turns, ms and m; paper, ours\n");
  const auto row = [&](const char* what, double paper_ms, double paper_m, double ms) {
    std::printf("%-52s %8s %12.6f   %8s %8.3f\n", what, number(paper_ms).c_str(), ms, number(paper_m).c_str(),
                geometry::length_of(way));
  };
  const double eight = per_call([&] { way = geometry::grid_path(kept, from.at, to.at, 0.1); }, calls);
  row("A* on a 0.1 m grid, eight neighbours", 8.975, 2.7, eight);
  const double four =
      per_call([&] { way = geometry::grid_path(kept, from.at, to.at, 0.1, geometry::GridNeighbours::kFour); }, calls);
  row("A* on a 0.1 m grid, four neighbours", 8.975, 2.7, four);
  const double whole =
      per_call([&] { way = SafeGround(face, PaperOptions{}.safe_inset).way(from.at, to.at, FaceWay::kVisibility); }, calls);
  row("visibility graph, safe polygon and graph made anew", 0.944, 2.631, whole);
  const double query = per_call([&] { way = kept.path(from.at, to.at); }, 100 * calls);
  row("visibility graph, kept", 0.944, 2.631, query);
  figures.push_back({"figure11_ppic_grid", eight, "ms", "less", std::nullopt, 8.975, "paper, A*"});
  figures.push_back({"figure11_ppic_new_graph", whole, "ms", "less", std::nullopt, 0.944, "paper"});
  figures.push_back({"figure11_ppic", 1e3 * query, "us", "less", 1.0, 944.0, "paper"});

  std::printf("\nFigure 11 (b): discrete way, steps and ms; paper, ours\n");
  const auto exact = make_exact(bench.model(), kClearance);
  for (const FaceRule rule : {FaceRule::kPaper, FaceRule::kZhu}) {
    PaperOptions options;
    options.rule = rule;
    const bool zhu = rule == FaceRule::kZhu;
    std::size_t steps = 0;
    double ms = 0.0;
    // The first plan makes what is kept.
    for (int k = -1; k < bench.repetitions(); ++k) {
      PaperTimes times;
      steps = plan_paper(bench.model(), scene, *exact, from, to, options, {}, {}, &times).route.strides.size();
      if (k >= 0) ms += times.ppi.at(0) / bench.repetitions();
    }
    std::printf("%-52s %8d %8zu   %8.3f %10.4f\n", zhu ? "rule of Zhu et al." : "algorithms 1 and 2", zhu ? 8 : 7, steps,
                zhu ? 8.299 : 63.643, ms);
    const std::string name = zhu ? "figure11_zhu" : "figure11_paper";
    figures.push_back({name + "_steps", static_cast<double>(steps), "", "less", std::nullopt, zhu ? 8.0 : 7.0, "paper"});
    figures.push_back({name, ms, "ms", "less", std::nullopt, zhu ? 8.299 : 63.643, "paper"});
  }
  std::printf("\nThe same on random zigzags with a way of 2.631 m: steps of algorithms 1 and 2 against the rule of Zhu et al.\n");
  for (const double r_max : {0.0, 0.44}) {
    PaperOptions options;
    options.r_max = r_max;
    const RuleTally tally = compare_rules(bench.model(), scene.workspace, options, bench.repetitions() >= 100 ? 400 : 60);
    const int judged = tally.fewer + tally.same + tally.more;
    std::printf("r_max %.2f m: of %d faces fewer on %d, as many on %d, more on %d (stuck: %d, Zhu %d); mean %.3f against %.3f\n",
                r_max > 0.0 ? r_max : scene.workspace->r_max(), tally.faces, tally.fewer, tally.same, tally.more, tally.paper_stuck,
                tally.zhu_stuck, tally.paper_steps / judged, tally.zhu_steps / judged);
    const std::string name = r_max > 0.0 ? "zigzags_steps_short_r_max" : "zigzags_steps";
    figures.push_back({name, tally.paper_steps / judged, "", "less", std::nullopt, tally.zhu_steps / judged, "rule of Zhu et al."});
  }
}

}  // namespace

std::vector<Figure> hyrecro_tables(bool quick) {
  std::vector<Figure> figures;
  Bench bench(quick ? 5 : 100);
  const truss::Truss beams = truss::read_truss(FOOTHOLD_CONFIG_DIR "/scenes/truss-crossed-beams.yaml");
  table_1(bench, beams, figures);
  table_2(bench, beams, figures);
  figure_11(bench, figures);
  return figures;
}

}  // namespace foothold::bench
