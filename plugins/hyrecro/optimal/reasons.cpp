#include "hyrecro/optimal/reasons.hpp"

#include <algorithm>
#include <cstdio>
#include <limits>

namespace foothold::hyrecro {
namespace {

constexpr int kMostTransitions = 20'000;  // judged, in all
constexpr double kFar = 0.2;              // m: collisions are looked for up to here

std::string metres(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f m", value);
  return text;
}

class Flood {
 public:
  Flood(TrussGraph& graph, const PreparedTruss& scene, const std::stop_token& stop)
      : graph_(graph), stop_(stop), entered_at_(scene.truss.faces.size(), -1) {
    enter(graph.start());
    for (std::size_t next = 0; next < order_.size() && !stop_.stop_requested() && left_ > 0; ++next) spread(order_[next]);
  }

  bool entered(int face) const { return entered_at_[static_cast<std::size_t>(face)] >= 0; }
  int entry(int face) const { return entered_at_[static_cast<std::size_t>(face)]; }
  std::size_t faces() const { return order_.size(); }
  bool walked() const { return walked_; }  // some leg or transition away from the start exists

 private:
  void enter(int node) {
    entered_at_[static_cast<std::size_t>(graph_.face_of(node))] = node;
    order_.push_back(graph_.face_of(node));
  }

  void spread(int face) {
    const int from = entry(face);
    for (const int node : graph_.on_face(face)) {
      if (stop_.stop_requested() || left_ <= 0) return;
      std::vector<int> beyond;
      for (const auto part : graph_.transitions(node))
        for (const RouteGraph::Transition& transition : part)
          if (!entered(graph_.face_of(transition.to))) beyond.push_back(transition.to);
      if (beyond.empty() || (node != from && graph_.leg(from, node, false) == kNever)) continue;
      walked_ = walked_ || node != from;
      for (const int to : beyond)
        if (!entered(graph_.face_of(to)) && --left_ > 0 && graph_.transition(node, to)) {
          walked_ = true;
          enter(to);
        }
    }
  }

  TrussGraph& graph_;
  const std::stop_token& stop_;
  std::vector<int> entered_at_;  // by face
  std::vector<int> order_;
  int left_ = kMostTransitions;
  bool walked_ = false;
};

struct Nearest {
  int from = -1, to = -1;
  bool reachable = false;  // but for the scene
  double distance = std::numeric_limits<double>::infinity();
};

// From any entered face to the goal's.
Nearest nearest_transition(TrussGraph& graph, const PreparedTruss& scene, KeptTruss& kept, const Flood& flood) {
  Nearest best;
  const int face = graph.face_of(graph.goal());
  const auto consider = [&](int from, int to) {
    if (!flood.entered(graph.face_of(from))) return;
    const Isometry3d a = pose_of(scene.truss, graph.at(from)), b = pose_of(scene.truss, graph.at(to));
    const double distance = (a.translation() - b.translation()).norm();
    const bool reachable =
        distance <= kept.strides.bounds().transition_reach() && kept.strides.alone(a.inverse(Eigen::Isometry) * b).has_value();
    if (reachable > best.reachable || (reachable == best.reachable && distance < best.distance))
      best = {from, to, reachable, distance};
  };
  for (double radius = kept.strides.bounds().transition_reach(); best.from < 0 && radius < 1000.0; radius *= 2.0)
    for (const int to : graph.on_face(face)) {
      for (const int from : scene.transitions.near(pose_of(scene.truss, graph.at(to)).translation(), radius, face))
        consider(from, to);
      if (graph.face_of(graph.start()) != face) consider(graph.start(), to);
    }
  return best;
}

std::string what_blocks(TrussGraph& graph, const PreparedTruss& scene, KeptTruss& kept, const Nearest& nearest) {
  const Isometry3d from = pose_of(scene.truss, graph.at(nearest.from)), to = pose_of(scene.truss, graph.at(nearest.to));
  const double beyond = nearest.distance - kept.strides.bounds().transition_reach();
  if (beyond > 0.0) return "out of reach by at least " + metres(beyond);
  if (!nearest.reachable) return "out of the legs' reach in every posture";
  const std::optional<Coordinates> posture = kept.strides.alone(from.inverse(Eigen::Isometry) * to);
  const Bodies bodies = bodies_at(kept.strides.model(), *posture, from);
  Obstacles::Nearest hit = scene.obstacles.nearest(bodies, kFar);
  if (const Obstacles::Nearest plate = scene.obstacles.nearest_of_plates(bodies, kFar);
      plate.solid >= 0 && plate.distance <= 0.0 && hit.distance > scene.clearance)
    hit = plate;
  if (hit.solid < 0) return "in collision in every posture";
  return "in collision in every posture: " + hit.body + " comes within " + metres(hit.distance) + " of '" +
         scene.truss.solids[static_cast<std::size_t>(hit.solid)].name + "', clearance is " + metres(scene.clearance);
}

std::string name_of(const PreparedTruss& scene, int face) {
  return "'" + scene.truss.faces[static_cast<std::size_t>(face)].name + "'";
}

}  // namespace

Failure hemmed_in(const PreparedTruss& scene, const Foothold& at, const std::string& field) {
  return {PlanError::kUnreachableGoal, field,
          "the " + field + " on face " + name_of(scene, at.face) +
              " is hemmed in: no stride was found between it and any foothold on its face or another",
          "move or turn the " + field + "; legs or hip would touch what stands near it"};
}

Failure why_unreachable(TrussGraph& graph, const PreparedTruss& scene, KeptTruss& kept, const std::stop_token& stop) {
  Failure out{PlanError::kUnreachableGoal, "goal", "", ""};
  const int from = graph.face_of(graph.start()), to = graph.face_of(graph.goal());
  if (from != to && scene.transitions.all().empty()) {
    out.message = "the scene has no transition footholds, so nothing leads from face " + name_of(scene, from) + " to face " +
                  name_of(scene, to);
    out.hint = "no two faces meet with room for both plates: make faces wider, or sample with other transition distances";
    return out;
  }
  const Flood flood(graph, scene, stop);
  if (flood.entered(to)) {
    out.message = "face " + name_of(scene, to) + (from == to ? " holds start and goal" : " can be entered") +
                  ", but no strides were found to the goal on it";
    out.hint = "move or turn the goal; it may stand too near something that leg or hip would touch";
    return out;
  }
  const Nearest nearest = nearest_transition(graph, scene, kept, flood);
  out.message = "face " + name_of(scene, to) + " cannot be entered: ";
  if (!flood.walked()) return hemmed_in(scene, graph.at(graph.start()), "start");
  out.message += std::to_string(flood.faces()) + (flood.faces() == 1 ? " face is" : " faces are") + " within reach of the start; ";
  if (nearest.from < 0) {
    out.message += "no transition footholds lead to it";
    out.hint = "give a goal on another face, or sample with other transition distances";
    return out;
  }
  out.message += "the nearest transition, from face " + name_of(scene, graph.face_of(nearest.from)) + " over " +
                 metres(nearest.distance) + ", is " + what_blocks(graph, scene, kept, nearest);
  out.hint =
      nearest.reachable ? "take away what is in the way, or lower clearance" : "give a goal on another face, or add a beam between";
  return out;
}

}  // namespace foothold::hyrecro
