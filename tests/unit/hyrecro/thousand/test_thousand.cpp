// Plans on generated trusses: what is sent passes the judge, the optimal search is never behind the paper's, and what is not solved
// is such that no transitions join its faces or nothing leads to the goal itself, but for few (the long form asks). 24 trusses;
// 1,000 with FOOTHOLD_LONG=1; of those only the i-th of n parts with FOOTHOLD_PART=i/n, so that several processes share them.
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <numeric>
#include <sstream>

#include "fixtures.hpp"
#include "hyrecro/scene/random_foothold.hpp"
#include "truss/generate.hpp"

namespace foothold::hyrecro {
namespace {

using Outcome = PlanReport::Outcome;

bool is_long() { return std::getenv("FOOTHOLD_LONG") != nullptr; }
int trusses() { return is_long() ? 1000 : 24; }

// Which trusses, by their number, this process looks at.
struct Part {
  int index = 1, of = 1;
  bool has(int number) const { return number % of == index - 1; }
};
Part part() {
  const char* given = std::getenv("FOOTHOLD_PART");
  Part out;
  if (given != nullptr && (std::sscanf(given, "%d/%d", &out.index, &out.of) != 2 || out.index < 1 || out.index > out.of))
    ADD_FAILURE() << "FOOTHOLD_PART must be i/n with 1 <= i <= n, is " << given;
  return out;
}

// One truss with a start and a goal, all from the seed.
struct Case {
  truss::Truss truss;
  Request request;
  Foothold start, goal;
};

std::optional<Case> make_case(const Model& model, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  constexpr truss::Family kFamilies[] = {truss::Family::kPortal, truss::Family::kTower, truss::Family::kBridge};
  const int beams = static_cast<int>(truss::kFewestBeams + random() % (is_long() ? 12 : 5));
  Case out;
  out.truss = truss::build(truss::generate(kFamilies[seed % 3], seed, beams));
  const auto start = random_foothold(model, out.truss, random), goal = random_foothold(model, out.truss, random);
  if (!start || !goal) return std::nullopt;
  out.start = *start;
  out.goal = *goal;
  out.request = request_between(pose_of(out.truss, out.start), pose_of(out.truss, out.goal));
  out.request.start.contacts[0].face = out.truss.faces[static_cast<std::size_t>(start->face)].name;
  out.request.goal.contacts[0].face = out.truss.faces[static_cast<std::size_t>(goal->face)].name;
  out.request.seed = seed;
  return out;
}

PreparedTruss prepared(const Model& model, const truss::Truss& truss, bool both_headings) {
  return {model, truss, SamplingOptions{.both_headings = both_headings}, 0.005};
}

// Whether transitions join the faces of start and goal, if one can go everywhere on a face: found by joining faces pair by pair,
// without any search for a way. The planner cannot do more.
bool faces_join(const Model& model, const PreparedTruss& scene, const Foothold& start, const Foothold& goal) {
  std::vector<std::size_t> root(scene.truss.faces.size());
  std::iota(root.begin(), root.end(), 0u);
  const auto find = [&](int face) {
    auto at = static_cast<std::size_t>(face);
    while (root[at] != at) at = root[at] = root[root[at]];
    return at;
  };
  const auto exact = make_exact(model, scene.clearance);
  const auto join = [&](const Foothold& a, const Foothold& b) {
    const std::size_t one = find(a.face), two = find(b.face);
    if (one == two) return;
    const Isometry3d from = pose_of(scene.truss, a);
    const Isometry3d wanted = from.inverse() * pose_of(scene.truss, b);
    const auto free = [&](const Coordinates& c) { return scene.obstacles.free(bodies_at(model, c, from), scene.clearance); };
    if (exact->reach(wanted, free).reachable) root[one] = two;
  };
  constexpr double kFarthest = 1.2;  // m, more than the robot is long
  std::vector<Foothold> nodes;
  for (const TransitionFoothold& t : scene.transitions.all()) nodes.push_back(t.foothold);
  nodes.push_back(start);
  nodes.push_back(goal);
  for (const Foothold& a : nodes)
    for (const int near : scene.transitions.near(pose_of(scene.truss, a).translation(), kFarthest, a.face)) {
      join(a, scene.transitions.all()[static_cast<std::size_t>(near)].foothold);
      if (find(start.face) == find(goal.face)) return true;
    }
  join(start, goal);
  return find(start.face) == find(goal.face);
}

// Whether a foot may step between an end and somewhere: a coarse grid of its face, and the transitions near it.
bool can_be_entered(const Model& model, const PreparedTruss& scene, const Foothold& end) {
  const auto exact = make_exact(model, scene.clearance);
  const Isometry3d from = pose_of(scene.truss, end);
  const auto free = [&](const Coordinates& c) { return scene.obstacles.free(bodies_at(model, c, from), scene.clearance); };
  const auto reached = [&](const Isometry3d& other) { return exact->reach(from.inverse() * other, free).reachable; };
  constexpr double kStep = 0.1;  // m
  const truss::Face& face = scene.truss.faces[static_cast<std::size_t>(end.face)];
  for (int i = -6; i <= 6; ++i)
    for (int j = -6; j <= 6; ++j)
      for (int k = 0; k < 8; ++k) {
        const Foothold at{end.face, end.at + kStep * Eigen::Vector2d(i, j), end.heading + k * std::numbers::pi / 4.0};
        if ((i != 0 || j != 0) && plate_on_face(model, face, at) && reached(pose_of(scene.truss, at))) return true;
      }
  for (const int near : scene.transitions.near(from.translation(), 1.2, end.face))
    if (reached(scene.transitions.all()[static_cast<std::size_t>(near)].pose)) return true;
  return false;
}

std::string bytes_of(const Collector& out) {
  std::ostringstream text;
  text.precision(17);
  for (const Step& step : out.steps) {
    text << step.label << step.cost << step.after.base.matrix();
    for (const double joint : step.after.joints) text << ' ' << joint;
    for (const MotionPoint& point : step.motion) {
      text << point.time;
      for (const double joint : point.joints) text << ' ' << joint;
    }
  }
  return text.str();
}

TEST(Thousand, TrussesAreClimbedAsTheJudgeAllowsAndNeverInMoreStepsThanThePaper) {
  HyrecroPlanner planner(robot());
  const Model model = Model::from_model(robot());
  const Parameters optimal = parameters({{"motion", "true"}}), bare = parameters({{"motion", "false"}});
  const Parameters paper = parameters({{"method", "paper"}, {"motion", "false"}});
  const Part mine = part();
  int number = 0, planned = 0, reached = 0, proved = 0, within_one = 0, paper_reached = 0, better = 0, steps = 0, motions = 0,
      without_motion = 0, joined = 0, failed = 0;
  for (std::uint64_t seed = 1; number < trusses(); ++seed) {
    ASSERT_LT(seed, 4000u);
    const std::optional<Case> one = make_case(model, seed);
    if (!one) continue;
    const PreparedTruss scene = prepared(model, one->truss, false);
    try {
      planner.start(one->request, bare, scene);
    } catch (const InvalidRequest&) {
      continue;  // no room for the robot there
    }
    if (!mine.has(number++)) continue;
    SCOPED_TRACE("seed " + std::to_string(seed));
    ++planned;
    Collector ours(seed);
    const PlanReport report = judged_plan(planner, one->request, bare, scene, ours);
    const PreparedTruss papers_scene = prepared(model, one->truss, false);
    Collector theirs(seed);
    const PlanReport papers = judged_plan(planner, one->request, paper, papers_scene, theirs);
    if (report.outcome == Outcome::kReached) {
      ++reached;
      steps += static_cast<int>(ours.steps.size());
      if (report.optimal) ++proved;
      if (report.cost <= report.lower_bound + 1.0) ++within_one;
      EXPECT_LE(report.lower_bound, report.cost);
      const Isometry3d& end = ours.steps.empty() ? one->request.start.contacts[0].frame : ours.steps.back().placed[0].frame;
      EXPECT_TRUE(end.isApprox(one->request.goal.contacts[0].frame, 1e-9));
      if (planned % 12 == 0) {
        const PreparedTruss to_move = prepared(model, one->truss, false);
        Collector moved(seed);
        const PlanReport with_motion = judged_plan(planner, one->request, optimal, to_move, moved);
        ++motions;
        if (with_motion.outcome != Outcome::kReached) {
          ++without_motion;
          EXPECT_FALSE(with_motion.message.empty());
          std::printf("seed %llu: no motion: %s\n", static_cast<unsigned long long>(seed), with_motion.message.c_str());
        }
        EXPECT_LE(with_motion.lower_bound, with_motion.cost);
        if (planned % 24 == 0) {
          HyrecroPlanner fresh(robot());
          const PreparedTruss same = prepared(model, one->truss, false);
          Collector again(seed);
          fresh.plan(one->request, optimal, same, again);
          EXPECT_EQ(bytes_of(moved), bytes_of(again));
        }
      }
    } else {
      ++failed;
      EXPECT_EQ(report.outcome, Outcome::kFailed);
      EXPECT_NE(report.error, PlanError::kNone);
      EXPECT_FALSE(report.message.empty());
      if (is_long() && faces_join(model, scene, one->start, one->goal) && can_be_entered(model, scene, one->goal) &&
          can_be_entered(model, scene, one->start)) {
        ++joined;
        std::printf("seed %llu: not solved though its faces join: %s\n", static_cast<unsigned long long>(seed),
                    report.message.c_str());
      }
    }
    if (papers.outcome == Outcome::kReached) {
      ++paper_reached;
      EXPECT_EQ(report.outcome, Outcome::kReached) << "the paper's method finds a way: " << report.message;
      EXPECT_LE(report.cost, papers.cost);
      if (report.cost < papers.cost) ++better;
    } else {
      EXPECT_FALSE(papers.message.empty());
    }
  }
  std::printf(
      "part %d of %d, %d trusses: reached %d, proved %d, by one step at most %d, paper reached %d, in fewer steps %d; %d steps; "
      "motions asked for %d, none %d; failed %d, of them joined %d\n",
      mine.index, mine.of, planned, reached, proved, within_one, paper_reached, better, steps, motions, without_motion, failed,
      joined);
  // A part of the run may have more of the hard ones than its share. All 1,000 together: 91.7 % and 96.8 %; routes through
  // footholds that hardly any stride leads to are found, but not proved.
  const int chance = mine.of > 1 ? 5 : 0;
  EXPECT_GE(proved + chance, (is_long() ? 0.91 : 0.85) * reached);
  EXPECT_GE(within_one + chance, (is_long() ? 0.96 : 0.95) * reached);
  EXPECT_GE(reached, 0.8 * planned);
  EXPECT_LE(joined, 1 + 0.02 * planned);
  EXPECT_LE(without_motion, 1 + 0.1 * motions);
}

}  // namespace
}  // namespace foothold::hyrecro
