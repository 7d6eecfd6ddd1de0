#include "hyrecro/optimal/truss_graph.hpp"

#include <algorithm>
#include <cmath>

namespace foothold::hyrecro {
namespace {

constexpr double kSameLength = 1e-9;  // m

std::uint64_t pair_of(int a, int b) { return (static_cast<std::uint64_t>(a) << 32) | static_cast<std::uint32_t>(b); }

}  // namespace

KeptTruss::KeptTruss(const Model& model, const PreparedTruss& scene) : strides(model, scene), legs(strides) {
  for (std::size_t k = 0; k < 2; ++k) {
    transitions[k].resize(scene.transitions.all().size());
    listed[k].assign(scene.transitions.all().size(), 0);
  }
}

TrussGraph::TrussGraph(const Model& model, const PreparedTruss& scene, KeptTruss& kept, const Foothold& start, const Foothold& goal,
                       const OptimalOptions& options)
    : model_(model),
      scene_(scene),
      kept_(kept),
      start_(start),
      goal_(goal),
      options_(options),
      samples_(static_cast<int>(scene.transitions.all().size())) {
  if (!options.banned.empty())
    banned_ = [this](const Foothold& a, const Foothold& b) {
      return std::any_of(options_.banned.begin(), options_.banned.end(), [&](const Ban& ban) {
        return (same(ban.one, a) && same(ban.other, b)) || (same(ban.one, b) && same(ban.other, a));
      });
    };
  start_face_ = scene.transitions.of_face(start.face);
  start_face_.push_back(this->start());
  if (goal.face == start.face) start_face_.push_back(this->goal());
  goal_face_ = scene.transitions.of_face(goal.face);
  goal_face_.push_back(this->goal());
  list_own(this->start());
  list_own(this->goal());
}

const Foothold& TrussGraph::at(int node) const {
  if (node < samples_) return scene_.transitions.all()[static_cast<std::size_t>(node)].foothold;
  return node == start() ? start_ : goal_;
}

Isometry3d TrussGraph::pose(int node) const {
  if (node < samples_) return scene_.transitions.all()[static_cast<std::size_t>(node)].pose;
  return pose_of(scene_.truss, at(node));
}

Vector3d TrussGraph::place(int node) const {
  if (node < samples_) return scene_.transitions.all()[static_cast<std::size_t>(node)].pose.translation();
  return pose(node).translation();
}

Cost TrussGraph::cost(int strides, double length) const {
  return options_.objective == Objective::kSteps ? Cost{static_cast<double>(strides), length}
                                                 : Cost{length, static_cast<double>(strides)};
}

std::span<const int> TrussGraph::on_face(int face) const {
  if (face == start_.face) return start_face_;
  if (face == goal_.face) return goal_face_;
  return scene_.transitions.of_face(face);
}

void TrussGraph::leg_bounds(int node, std::span<Cost> out) {
  const std::span<const int> there = on_face(face_of(node));
  const Foothold& from = at(node);
  for (std::size_t i = 0; i < there.size(); ++i) {
    const Foothold& to = at(there[i]);
    out[i] = there[i] == node ? Cost{} : cost(kept_.legs.least(from, to), (to.at - from.at).norm());
  }
}

Cost TrussGraph::from_start(int node) const {
  const double distance = (place(node) - place(start())).norm();
  return cost(static_cast<int>(std::ceil(distance / kept_.strides.bounds().transition_reach() - 1e-9)), distance);
}

const KeptTruss::Leg& TrussGraph::walk(int from, int to) {
  const bool own = std::max(from, to) >= samples_ || banned_;
  auto& known = own ? own_walked_ : kept_.walked;
  const auto [entry, fresh] = known.try_emplace(pair_of(from, to));
  KeptTruss::Leg& leg = entry->second;
  if (!fresh) return leg;
  leg.least = kept_.legs.least(at(from), at(to));
  if (leg.least == 0) {
    leg.found = true;
    return leg;
  }
  constexpr int kMore = 3;
  for (int count = leg.least; count <= leg.least + kMore && !leg.found; ++count)
    if (auto found = kept_.legs.find(at(from), at(to), count, banned_)) {
      leg.found = true;
      leg.strides = std::move(*found);
    }
  return leg;
}

Cost TrussGraph::leg(int from, int to) {
  const KeptTruss::Leg& leg = walk(from, to);
  if (!leg.found) return kNever;
  double length = 0.0;
  Vector2d before = at(from).at;
  for (const Stride& stride : leg.strides) {
    length += (stride.to.at - before).norm();
    before = stride.to.at;
  }
  const double straight = (at(to).at - at(from).at).norm();
  return cost(static_cast<int>(leg.strides.size()), length < straight + kSameLength ? straight : length);
}

const std::vector<RouteGraph::Transition>& TrussGraph::kept_list(int sample) {
  const std::size_t kind = options_.objective == Objective::kSteps ? 0 : 1, i = static_cast<std::size_t>(sample);
  std::vector<Transition>& out = kept_.transitions[kind][i];
  if (kept_.listed[kind][i]) return out;
  kept_.listed[kind][i] = 1;
  for (const int to : scene_.transitions.near(place(sample), kept_.strides.bounds().transition_reach(), face_of(sample)))
    if (kept_.strides.alone(pose(sample).inverse(Eigen::Isometry) * pose(to)))
      out.push_back({to, cost(1, (place(to) - place(sample)).norm())});
  return out;
}

// `end`: start or goal. The list of what may be reached from it, and it in the lists of all these.
void TrussGraph::list_own(int end) {
  std::vector<Transition>& out = own_lists_[end];
  const auto connect = [&](int to) {
    if (face_of(to) == face_of(end) || !kept_.strides.alone(pose(end).inverse(Eigen::Isometry) * pose(to))) return;
    const Cost length = cost(1, (place(to) - place(end)).norm());
    out.push_back({to, length});
    if (to >= samples_) return;
    const auto [list, fresh] = own_lists_.try_emplace(to);
    if (fresh) list->second = kept_list(to);
    list->second.push_back({end, length});
  };
  for (const int to : scene_.transitions.near(place(end), kept_.strides.bounds().transition_reach(), face_of(end))) connect(to);
  connect(end == start() ? goal() : start());
}

std::span<const RouteGraph::Transition> TrussGraph::transitions(int node) {
  const auto own = own_lists_.find(node);
  return own != own_lists_.end() ? own->second : kept_list(node);
}

const std::optional<Coordinates>& TrussGraph::judge(int from, int to) {
  auto& known = std::max(from, to) >= samples_ ? own_judged_ : kept_.judged;
  const auto [entry, fresh] = known.try_emplace(pair_of(from, to));
  if (fresh) entry->second = kept_.strides.exact(at(from), at(to));
  return entry->second;
}

bool TrussGraph::transition(int from, int to) {
  if (banned_ && banned_(at(from), at(to))) return false;
  return from < to ? judge(from, to).has_value() : judge(to, from).has_value();
}

std::vector<Stride> TrussGraph::strides_of(const Hop& hop) {
  if (hop.leg) return walk(hop.from, hop.to).strides;
  const Coordinates coordinates = hop.from < hop.to ? *judge(hop.from, hop.to) : swapped(*judge(hop.to, hop.from));
  return {{at(hop.to), coordinates}};
}

}  // namespace foothold::hyrecro
