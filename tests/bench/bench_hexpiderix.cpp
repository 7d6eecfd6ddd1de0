// Hex-piderix: a posture, the best posture of a plane, the paper's strategies, walks: bench_hexpiderix [--quick].
//
// Times are this thread's CPU time, so that what else the machine does counts little; of several runs the least. The table of
// slopes stands beside the paper's words (section 4.1).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <random>
#include <string>

#include "figures.hpp"
#include "hexpiderix/optimal/best_posture.hpp"
#include "hexpiderix/walk/instant.hpp"
#include "slopes.hpp"

namespace {

using namespace foothold;
using namespace foothold::hexpiderix;
using namespace foothold::hexpiderix::testing;
using foothold::bench::Figure;
using foothold::bench::least_seconds;
using foothold::bench::percentile;

double sink = 0.0;  // so that nothing measured is left out

// A thorax that moves in small steps over its footholds, as in a search: six inverse kinematics, NESM on the triad, equilibrium
// with a tenth more friction than the slope needs.
void postures(int runs, std::vector<Figure>& out) {
  constexpr double kSlope = 25 * kDegree;
  const Model& model = shipped_model();
  const Situation from = tilted(kSlope, 1.0, kTriad1);
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> step(-0.003, 0.003);
  std::vector<Isometry3d> poses;
  for (int k = 0; k < 2000; ++k) {
    Isometry3d pose = from.thorax;
    for (int twice = 0; twice < 3; ++twice) {
      pose.translate(Vector3d(step(random), step(random), step(random)));
      pose.rotate(Eigen::AngleAxisd(step(random), Vector3d(1, step(random), 0).normalized()));
    }
    poses.push_back(pose);
  }
  const double count = static_cast<double>(poses.size());
  for (const bool six : {false, true}) {
    const Legs supports = six ? Legs{0b111111} : kTriad1;
    Footholds feet = from.footholds;
    feet.supports = supports;
    contact::Equilibrium equilibrium(contact::FrictionCone::circular());
    const double whole = least_seconds(runs, [&] {
      for (const Isometry3d& pose : poses) {
        Coordinates at;
        std::size_t leg = 0;
        if (!place_feet(model, pose, feet.points, at, leg)) continue;
        Vector3d com;
        sink += nesm_on(model, at, feet, supports, com);
        sink += stands(equilibrium, feet, com, 1.1 * std::tan(kSlope)) ? 1.0 : 0.0;
      }
    });
    out.push_back({six ? "posture_six_feet" : "posture", 1e6 * whole / count, "us", "less", 3.0});
  }
  const double evaluated = least_seconds(runs, [&] {
    for (const Isometry3d& pose : poses) sink += evaluate(model, from.ground, from.footholds, pose, {model.lift, true}, 0.0).nesm;
  });
  out.push_back({"posture_with_collisions", 1e6 * evaluated / count, "us", "less"});
}

void best_postures(bool quick, std::vector<Figure>& out) {
  const double slope_step = quick ? 10 : 5, direction_step = quick ? 30 : 10;
  std::vector<double> times;
  double most_boxes = 0.0;
  for (double slope = 0; slope <= 60.0; slope += slope_step)
    for (double direction = 0; direction < 360; direction += direction_step)
      for (const Legs triad : {kTriad1, kTriad2}) {
        const Situation from = tilted(slope * kDegree, direction * kDegree, triad);
        times.push_back(1e3 * least_seconds(2, [&] {
                          const BestPosture found = best_posture(shipped_model(), from, {}, {});
                          most_boxes = std::max(most_boxes, static_cast<double>(found.boxes));
                        }));
      }
  out.push_back({"best_posture", percentile(times, 0.5), "ms", "less", 5.0});
  out.push_back({"best_posture_p99", percentile(times, 0.99), "ms", "less", 5.0});
  out.push_back({"best_posture_worst", percentile(times, 1.0), "ms", "less"});
  out.push_back({"best_posture_most_boxes", most_boxes, "1", "less"});
}

void strategies(int runs, std::vector<Figure>& out) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> slope(0, 60), direction(0, 360);
  std::vector<Situation> all;
  for (int k = 0; k < 500; ++k)
    all.push_back(tilted(slope(random) * kDegree, direction(random) * kDegree, k % 2 ? kTriad1 : kTriad2));
  const auto each = [&](const char* name, auto&& adapted) {
    const double whole = least_seconds(runs, [&] {
      for (const Situation& from : all) sink += std::max(-1.0, adapted(from).evaluation.nesm);
    });
    out.push_back({name, 1e6 * whole / static_cast<double>(all.size()), "us", "less"});
  };
  const Model& model = shipped_model();
  each("constant_orientation", [&](const Situation& from) { return constant_orientation(model, from); });
  each("geometric", [&](const Situation& from) { return geometric(model, from); });
  each("emergency", [&](const Situation& from) { return emergency(model, from, EmergencyRule::kLongestDistance); });
  each("emergency_best_margin", [&](const Situation& from) { return emergency(model, from, EmergencyRule::kBestMargin); });
  each("choice", [&](const Situation& from) { return chosen(model, from); });
}

// On slopes so steep that no posture is stable: the proof of it.
void existence(bool quick, std::vector<Figure>& out) {
  BestOptions options;
  options.most_boxes = 300'000;
  std::vector<double> proofs, boxes;
  int found = 0, unknown = 0;
  for (double slope = 62; slope <= 86; slope += quick ? 8 : 4)
    for (double direction = 0; direction < 360; direction += quick ? 60 : 20) {
      Existence answer;
      const Situation from = tilted(slope * kDegree, direction * kDegree, kTriad1);
      const double time = 1e3 * least_seconds(1, [&] { answer = stable_posture(shipped_model(), from, options, {}); });
      found += answer.answer == Existence::Answer::kFound;
      unknown += answer.answer == Existence::Answer::kUnknown;
      if (answer.answer != Existence::Answer::kProvedNone) continue;
      proofs.push_back(time);
      boxes.push_back(static_cast<double>(answer.boxes));
    }
  std::printf("existence, slopes of 62 to 86 deg: %zu proved to have none, %d have one, %d open after %ld boxes\n", proofs.size(),
              found, unknown, options.most_boxes);
  if (!proofs.empty()) {
    out.push_back({"existence_proof", percentile(proofs, 0.5), "ms", "less"});
    out.push_back({"existence_proof_worst", percentile(proofs, 1.0), "ms", "less"});
    out.push_back({"existence_proof_boxes", percentile(boxes, 0.5), "1", "less"});
  }
  out.push_back({"existence_open", static_cast<double>(unknown), "1", "less"});
}

void walks(int runs, std::vector<Figure>& out) {
  struct Case {
    const char* name;
    Ground ground;
    Vector3d from, to;
  };
  const auto plane = [](double slope) {
    const std::string z = std::to_string(2.5 * std::tan(slope));
    return terrain::parse_terrain("kind: terrain\nvertices: [[-2.5, -2.5, -" + z + "], [2.5, -2.5, " + z + "], [2.5, 2.5, " + z +
                                  "], [-2.5, 2.5, -" + z + "]]\ntriangles: [[0, 1, 2], [0, 2, 3]]\n");
  };
  const Case cases[] = {
      {"walk_2m", Ground(plane(0)), {-1, 0, 0}, {1, 0, 0}},
      {"walk_2m_up_10_deg", Ground(plane(10 * kDegree)), {-1, 0, 0}, {1, 0, 0}},
      {"walk_2m_up_20_deg", Ground(plane(20 * kDegree)), {-1, 0, 0}, {1, 0, 0}},
      {"walk_2m_across_20_deg", Ground(plane(20 * kDegree)), {0, -1, 0}, {0, 1, 0}},
      {"walk_stairs", Ground(terrain::read_terrain(FOOTHOLD_CONFIG_DIR "/scenes/terrain-stairs.yaml")), {-0.6, 0, 0}, {0.6, 0, 0}}};
  const WalkOptions options;
  for (const Case& c : cases) {
    const auto on = [&](const Vector3d& p) { return Vector3d(p.x(), p.y(), c.ground.surface().height(p.x(), p.y()).value()); };
    const auto from = stand_at(shipped_model(), c.ground, {on(c.from), 0.0}, options);
    if (!from) {
      std::printf("%s: the robot cannot stand at the start\n", c.name);
      continue;
    }
    Walk found;
    const double time = 1e3 * least_seconds(runs, [&] {
                          found = walk(shipped_model(), c.ground, *from, {on(c.to), 0.0}, options, {});
                        });
    const bool arrived = found.end == Walk::End::kArrived;
    double least = 1.0;
    for (const HalfCycle& half : found.half_cycles) least = std::min(least, half.least_nesm);
    std::printf("%-24s %s, %zu half cycles of %ld tried, least NESM %.1f mm, %.1f ms%s%s\n", c.name,
                arrived ? "arrives" : "BLOCKED", found.half_cycles.size(), found.tried, 1e3 * least, time, arrived ? "" : ": ",
                arrived ? "" : found.because.c_str());
    if (arrived) out.push_back({c.name, time, "ms", "less", 50.0});
  }
}

// The thorax turned back by the paper's angles, against what the paper says and the best posture.
void table() {
  struct Row {
    double slope, reorientation;
    const char* paper;
  };
  constexpr Row kRows[] = {{15, 15, "stable"}, {30, 30, "stable"},   {45, 26, "stable"},
                           {50, 32, "stable"}, {55, 33, "critical"}, {60, 34, "unstable"}};
  std::printf("slope/turned back      NESM  the paper says   best posture  friction needed  by the best\n");
  for (const Row& row : kRows) {
    Situation from = tilted(row.slope * kDegree, 0.0, kTriad1);
    const Isometry3d turned = from.thorax * Eigen::AngleAxisd(-row.reorientation * kDegree, Vector3d::UnitY());
    const Evaluation at =
        evaluate(shipped_model(), from.ground, from.footholds, turned, {shipped_model().lift, true}, from.clearance);
    const BestPosture best = best_posture(shipped_model(), from, {}, {});
    std::printf("%4.0f / %2.0f deg     %6.2f mm  %-14s %9.2f mm  %15.2f  %11.2f\n", row.slope, row.reorientation, 1e3 * at.nesm,
                row.paper, 1e3 * best.polished.nesm, friction_needed(from.footholds, at.centre_of_mass),
                friction_needed(from.footholds, best.polished.centre_of_mass));
  }
}

}  // namespace

int main(int count, char** words) {
  const bool quick = foothold::bench::quick(count, words);
  const int runs = quick ? 5 : 20;
  std::vector<Figure> figures;
  table();
  postures(runs, figures);
  best_postures(quick, figures);
  walks(quick ? 3 : 7, figures);
  strategies(runs, figures);
  existence(quick, figures);
  std::printf("check sum %g\n", sink);
  foothold::bench::report("hexpiderix", figures);
}
