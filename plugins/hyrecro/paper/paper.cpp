// PPT, then PPI on each face of its route; what faces and workspaces give is kept with the scene.
#include "hyrecro/paper/paper.hpp"

#include <chrono>
#include <unordered_map>

#include "hyrecro/paper/face_walk.hpp"
#include "hyrecro/paper/transition_search.hpp"
#include "hyrecro/route/unreachable.hpp"

namespace foothold::hyrecro {
namespace {

// The workspace's order and the safe polygons of faces walked on, for one workspace and one inset.
struct KeptByPaper final : PreparedTruss::Kept {
  KeptByPaper(std::shared_ptr<const PlanarWorkspace> workspace, double safe_inset)
      : of(workspace), inset(safe_inset), order(std::move(workspace)) {}
  std::shared_ptr<const PlanarWorkspace> of;
  double inset;
  WorkspaceOrder order;
  std::unordered_map<int, SafeGround> grounds;
  ByPoses<Answer> answers;  // for the workspace's lift

  const SafeGround& ground(const truss::Truss& truss, int face) {
    return grounds.try_emplace(face, truss.faces[static_cast<std::size_t>(face)], inset).first->second;
  }
};

KeptByPaper& kept_of(const PreparedTruss& scene, const PaperOptions& options) {
  auto* kept = dynamic_cast<KeptByPaper*>(scene.kept_by_paper.get());
  if (!kept || kept->of != scene.workspace || kept->inset != options.safe_inset) {
    auto fresh = std::make_unique<KeptByPaper>(scene.workspace, options.safe_inset);
    kept = fresh.get();
    scene.kept_by_paper = std::move(fresh);
  }
  return *kept;
}

class Watch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double milliseconds = std::chrono::duration<double, std::milli>(now - last_).count();
    last_ = now;
    return milliseconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace

Found plan_paper(const Model& model, const PreparedTruss& scene, Reachability& reachability, const Foothold& start,
                 const Foothold& goal, const PaperOptions& options, const std::stop_token& stop, const OnStride& on_stride,
                 PaperTimes* times) {
  Found found;
  found.route.start = start;
  found.objective =
      "the shortest way over transition footholds, then on each face long strides along its shortest way; proves nothing";
  KeptByPaper& kept = kept_of(scene, options);
  JointSolutions solutions(model, scene, reachability, options.lift, options.keeps ? &kept.answers : nullptr);
  const double greatest = greatest_reach(model);
  Watch watch;
  const GlobalRoute global =
      search_transitions(scene, solutions, start, goal, options.reach_radius > 0.0 ? options.reach_radius : greatest, stop);
  if (times) times->ppt = watch.lap();
  const auto stopped = [&] {
    found.outcome = Found::Outcome::kStopped;
    return found;
  };
  if (global.outcome == GlobalRoute::Outcome::kStopped) return stopped();
  if (global.outcome == GlobalRoute::Outcome::kUnreachable) {
    found.failure = explain_unreachable(model, scene, *make_exact(model, scene.clearance), global.reached, goal, greatest);
    return found;
  }

  double length = 0.0;
  if (times) times->ppi.assign(1, 0.0);
  const Walker walker{model, scene, kept.order, solutions, options};
  for (std::size_t k = 1; k < global.waypoints.size(); ++k) {
    const Foothold& from = global.waypoints[k - 1].foothold;
    const Waypoint& to = global.waypoints[k];
    if (from.face != to.foothold.face) {
      found.route.strides.push_back({to.foothold, *to.coordinates});
      if (times) times->ppi.push_back(0.0);
      continue;
    }
    if (from.at == to.foothold.at && from.heading == to.foothold.heading) continue;
    watch.lap();
    FaceWalk walk = walk_face(walker, kept.ground(scene.truss, from.face), from, to.foothold, stop);
    if (times) times->ppi.back() += watch.lap();
    if (walk.outcome == FaceWalk::Outcome::kStopped) return stopped();
    if (walk.outcome == FaceWalk::Outcome::kStuck) {
      const std::string& name = scene.truss.faces[static_cast<std::size_t>(from.face)].name;
      found.failure = {PlanError::kNoPath, "goal", "the walk on face " + name + " got stuck: " + walk.stuck,
                       "the paper's method does not come back to try other transitions: method optimal does"};
      return found;
    }
    length += walk.way.empty() ? (to.foothold.at - from.at).norm() : geometry::length_of(walk.way);
    found.route.strides.insert(found.route.strides.end(), walk.strides.begin(), walk.strides.end());
  }
  found.outcome = Found::Outcome::kReached;
  found.cost = static_cast<double>(found.route.strides.size());
  found.figures = {{"nodes expanded", static_cast<double>(global.expanded), 0.0, ""},
                   {"poses tested", static_cast<double>(solutions.asked()), 0.0, ""},
                   {"way on faces", length, 0.0, "m"}};
  // A face that gets stuck spoils the whole route, so nothing is final before the last one is walked.
  if (on_stride)
    for (const Stride& stride : found.route.strides)
      if (!on_stride(stride)) return stopped();
  return found;
}

std::optional<std::vector<Stride>> plan_face(const Model& model, const PreparedTruss& scene, const Foothold& from,
                                             const Foothold& to, const PaperOptions& options, const std::stop_token& stop) {
  const std::unique_ptr<Reachability> exact = make_exact(model, scene.clearance);
  JointSolutions solutions(model, scene, *exact, options.lift);
  KeptByPaper& kept = kept_of(scene, options);
  FaceWalk walk = walk_face({model, scene, kept.order, solutions, options}, kept.ground(scene.truss, from.face), from, to, stop);
  if (walk.outcome != FaceWalk::Outcome::kReached) return std::nullopt;
  return std::move(walk.strides);
}

}  // namespace foothold::hyrecro
