// Bioloid: postures and motions judged, gait cycles, walks, and single supports beside OMPL's planners and the paper's stochastic
// method: bench_bioloid [--quick].
//
// Times are this thread's CPU time, so that what else the machine does counts little. All planners of a phase are judged alike:
// Judge::posture for points, Judge::motion for the lines between.
#include <algorithm>
#include <cstdio>

#include "bioloid/paper/nine_space.hpp"
#include "bioloid/steps/walk.hpp"
#include "bioloid_ompl.hpp"
#include "figures.hpp"
#include "robot.hpp"

namespace {

using namespace foothold;
using namespace foothold::bioloid;
using namespace foothold::bench;
using foothold::bioloid::testing::shipped_model;

int sink = 0;  // so that nothing measured is left out

template <class Work>
double least_seconds(int runs, Work&& work) {
  double least = 1e9;
  for (int k = 0; k < runs; ++k) {
    const double begin = cpu_seconds();
    work();
    least = std::min(least, cpu_seconds() - begin);
  }
  return least;
}

// Postures of single supports on the way, and lines between neighbours.
void judged(const std::vector<SinglePhase>& phases, std::vector<Figure>& out) {
  const Model& model = shipped_model();
  Judge judge(model, {});
  Support support;
  std::vector<Joints> postures;
  for (const SinglePhase& phase : phases) {
    if (phase.support.foot != support.foot) continue;
    for (int k = 0; k <= 10; ++k) {
      Joints joints;
      if (from_free(model, support.foot, phase.from + 0.1 * k * (phase.to - phase.from), joints) &&
          judge.posture(joints, support) == Fault::kNone)
        postures.push_back(joints);
    }
  }
  const double count = static_cast<double>(postures.size());
  const double posture = least_seconds(50, [&] {
    for (const Joints& joints : postures) sink += static_cast<int>(judge.posture(joints, support));
  });
  const double motion = least_seconds(50, [&] {
    for (std::size_t k = 0; k + 1 < postures.size(); ++k)
      sink += static_cast<int>(judge.motion(postures[k], postures[k + 1], support));
  });
  out.push_back({"validity_check", 1e9 * posture / count, "ns", "less", 260.0});
  out.push_back({"motion_check", 1e9 * motion / (count - 1.0), "ns", "less"});
}

// Two strides from a standing posture back to the same one, ahead by both: steps of 20 to 50 mm lifted by 8 to 12, turning by 0.1
// rad at most. Everything from nothing, the judge included.
void gaits(int seeds, std::vector<Figure>& out) {
  const Model& model = shipped_model();
  std::vector<double> times;
  int good = 0;
  for (int seed = 0; seed < seeds; ++seed) {
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    std::uniform_real_distribution<double> unit(0.0, 1.0);
    const auto between = [&](double low, double high) { return low + (high - low) * unit(random); };
    GaitOptions options;
    options.height = between(0.118, 0.122);
    const double length = between(0.02, 0.05), turn = between(-0.1, 0.1), lift = between(0.008, 0.012);
    const PlanarPose left = rounded({length, beside(model, Side::kRight).y + between(0.0, 0.003), turn});
    const PlanarPose right = rounded({left.x, -left.y, -left.heading});
    const double begin = cpu_seconds();
    Gait gait(model, options);
    const auto first = gait.stride(Side::kRight, rounded(inverse(right)), left, lift, random, {});
    const auto second = gait.stride(Side::kLeft, rounded(inverse(left)), right, lift, random, {});
    times.push_back(1e3 * (cpu_seconds() - begin));
    Judge again(model, options.demands);
    bool sound = first && second;
    for (const auto* stride : {&first, &second})
      if (sound)
        for (const Phase& phase : (*stride)->phases) sound = sound && certify(again, phase, phase.support) == Fault::kNone;
    good += sound;
    if (!sound) std::printf("seed %d: no gait (length %.3f, turn %.3f, lift %.4f)\n", seed, length, turn, lift);
  }
  out.push_back({"gait_median", percentile(times, 0.5), "ms", "less", 2.0});
  out.push_back({"gait_p99", percentile(times, 0.99), "ms", "less", 10.0});
  out.push_back({"gait_success", 1000.0 * good / seeds, "of 1000", "more", 1000.0, 760.0, "paper, real robot"});
}

// The paper's step (50 mm, lifted by 10) from standing to standing, by ours and with the lifted sole's way by the paper's
// stochastic method: there the weight comes over the sole's centre, ours is shifted as far as the balance asked for needs.
void travels(int seeds, std::vector<Figure>& out) {
  const Model& model = shipped_model();
  std::vector<double> ours, travel_share, time_share;
  const double y = beside(model, Side::kRight).y;
  for (int seed = 0; seed < seeds; ++seed) {
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    GaitOptions options, paper;
    options.height = paper.height = std::uniform_real_distribution<double>(0.118, 0.122)(random);
    paper.paper.emplace();
    const auto stride = [&](const GaitOptions& by) {
      return Gait(model, by).stride(Side::kRight, rounded({-0.05, y, 0.0}), rounded({0.05, y, 0.0}), 0.01, random, {});
    };
    const auto one = stride(options), two = stride(paper);
    if (!one || !two) continue;
    const auto travelled = [](const Stride& by) {
      double sum = 0.0;
      for (const Phase& phase : by.phases) sum += travel(phase.points);
      return sum;
    };
    ours.push_back(travelled(*one));
    travel_share.push_back(ours.back() / travelled(*two));
    time_share.push_back(duration(one->phases) / duration(two->phases));
  }
  if (ours.empty()) return;
  out.push_back({"gait_travel", percentile(ours, 0.5), "rad", "less"});
  out.push_back({"gait_travel_over_stochastic", percentile(travel_share, 0.5), "1", "less", 0.5});
  out.push_back({"gait_duration_over_stochastic", percentile(time_share, 0.5), "1", "less"});
}

Prism box(const char* name, double x0, double x1, double y0, double y1, double height) {
  return {name, {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, height};
}

// A metre over a tile, past a brick and a post.
void walks(int runs, std::vector<Figure>& out) {
  const Model& model = shipped_model();
  const std::vector<Prism> prisms{box("tile", 0.30, 0.32, -0.065, -0.035, 0.012), box("brick", 0.55, 0.65, 0.11, 0.2, 0.06),
                                  box("post", 0.8, 0.84, -0.3, -0.26, 0.5)};
  Walk found;
  const double time = 1e3 * least_seconds(runs, [&] {
                        Gait gait(model, {});
                        Walker walker(model, gait, {}, prisms);
                        std::mt19937_64 random(1);
                        Feet feet;
                        for (const Side side : {Side::kRight, Side::kLeft})
                          feet.of(side) = sole_at(side, {}, walker.half_spacing());
                        found = walker.walk(feet, {{0.95, 0.0, 0.0}, false}, random, {});
                      });
  std::printf("walk: %s, %zu steps (least %zu), %zu nodes, %d routes, %.1f ms%s%s\n",
              found.end == Walk::End::kFound ? "arrives" : "BLOCKED", found.steps.size(), found.least, found.expanded, found.routes,
              time, found.hindrance.empty() ? "" : ": ", found.hindrance.c_str());
  if (found.end != Walk::End::kFound) return;
  out.push_back({"walk_20_steps", time, "ms", "less", 50.0});
  out.push_back({"walk_steps", static_cast<double>(found.steps.size()), "1", "less"});
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

// The same phases by all planners, one after the other on each phase.
//
// Between two given postures no joint can travel less than the difference of its ends, so no path less than the sum of these: the
// baseline of travel_over_stochastic, which the stochastic method nearly attains where nothing is in the way, for each of its
// joints goes to its goal in one direction. What can be gained lies in the choice of the postures: gait_travel_over_stochastic.
void against(const char* name, const std::vector<SinglePhase>& phases, double patience, std::vector<Figure>& out) {
  const Model& model = shipped_model();
  std::mt19937_64 random(3);
  Answers ours, bare, rrt, simplified, lbkpiece, stochastic;
  const std::string suffix = name == std::string("free") ? "" : std::string("_") + name;
  std::vector<double> share, least;  // of stochastic's travel
  SearchOptions not_shortened;
  not_shortened.shortening = 0;
  for (const SinglePhase& phase : phases) {
    double spent = cpu_seconds();
    const auto way = connect(model, *phase.judge, phase.support, phase.from, phase.to, {}, random, {});
    const bool solved = add(model, phase, cpu_seconds() - spent, way, ours);
    spent = cpu_seconds();
    const auto first = connect(model, *phase.judge, phase.support, phase.from, phase.to, not_shortened, random, {});
    add(model, phase, cpu_seconds() - spent, first, bare);

    for (const auto& [planner, simplify, answers] :
         {std::tuple(OmplPlanner::kRrtConnect, false, &rrt), std::tuple(OmplPlanner::kRrtConnect, true, &simplified),
          std::tuple(OmplPlanner::kLbkpiece, false, &lbkpiece)}) {
      const auto path = solve_by_ompl(model, phase, planner, patience, simplify, spent);
      add(model, phase, spent, path, *answers);
    }

    const paper::Space space = paper::nine_space(model, *phase.judge, phase.support, phase.a, phase.b);
    const int dimension = space.dimension();
    paper::Options options;
    options.iterations = 100'000;
    spent = cpu_seconds();
    const paper::Plan plan = paper::plan(space, paper::nine_point(model, phase.support.foot, phase.a, dimension),
                                         paper::nine_point(model, phase.support.foot, phase.b, dimension), options, random);
    spent = cpu_seconds() - spent;
    std::vector<Free> path;
    for (const paper::Point& point : plan.path) {
      Free free = phase.from;
      free.head(dimension) = point;
      path.push_back(free);
    }
    if (add(model, phase, spent, path, stochastic) && solved) {
      share.push_back(ours.travel.back() / stochastic.travel.back());
      least.push_back((phase.a - phase.b).cwiseAbs().sum() / stochastic.travel.back());
    }
  }
  const double count = static_cast<double>(phases.size());
  std::printf("%s: %zu phases      solved   median us      p99 us   travel rad\n", name, phases.size());
  for (const auto& [who, answers] : {std::pair("ours", &ours), std::pair("ours, not shortened", &bare),
                                     std::pair("RRTConnect", &rrt), std::pair("RRTConnect, simplified", &simplified),
                                     std::pair("LBKPIECE", &lbkpiece), std::pair("stochastic (paper)", &stochastic)})
    std::printf("  %-22s %6zu  %10.1f  %10.1f  %10.3f\n", who, answers->solved, 1e6 * percentile(answers->seconds, 0.5),
                1e6 * percentile(answers->seconds, 0.99), mean(answers->travel));
  const auto median = [](const Answers& answers) { return percentile(answers.seconds, 0.5); };
  out.push_back(
      {"phase_median" + suffix, 1e6 * median(ours), "us", "less", 100.0, 1e6 * median(simplified), "OMPL RRTConnect, simplified"});
  out.push_back({"phase_solved" + suffix, static_cast<double>(ours.solved) / count, "1", "more", 1.0,
                 static_cast<double>(rrt.solved) / count, "OMPL RRTConnect"});
  // Like beside like: first paths, and shortened ones.
  out.push_back({"ompl_over_ours" + suffix, median(rrt) / median(bare), "1", "more", 1.0});
  out.push_back({"ompl_simplified_over_ours" + suffix, median(simplified) / median(ours), "1", "more", 1.0});
  out.push_back({"lbkpiece_over_ours" + suffix, median(lbkpiece) / median(bare), "1", "more", 1.0});
  out.push_back({"stochastic_over_ours" + suffix, median(stochastic) / median(ours), "1", "more", 1.0});
  if (!share.empty())
    out.push_back({"travel_over_stochastic" + suffix, percentile(share, 0.5), "1", "less", 0.5, percentile(least, 0.5),
                   "least between these postures"});
}

}  // namespace

int main(int count, char** words) {
  const bool brief = quick(count, words);
  seed_ompl(1);
  std::mt19937_64 random(2);
  const std::size_t phases = brief ? 20 : 100;
  const auto free = single_phases(shipped_model(), phases, false, random);
  const auto over = single_phases(shipped_model(), phases, true, random);
  std::vector<Figure> figures;
  judged(free, figures);
  gaits(brief ? 100 : 1000, figures);
  travels(brief ? 5 : 50, figures);
  walks(brief ? 1 : 5, figures);
  against("free", free, brief ? 0.2 : 1.0, figures);
  against("sill", over, brief ? 0.2 : 1.0, figures);
  report("bioloid", figures);
  return sink == -1;
}
