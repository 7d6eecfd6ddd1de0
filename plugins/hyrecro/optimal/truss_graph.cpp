#include "hyrecro/optimal/truss_graph.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace foothold::hyrecro {
namespace {

constexpr double kSameLength = 1e-9;  // m
constexpr double kCorner = 0.2;       // m: footholds this near each other share what is in their way
constexpr int kToldByPair = 4;        // failures that tell of all others
constexpr int kToldByCorner = 24;
constexpr int kNeverBarred = -1;
constexpr std::size_t kMostKept = 64'000'000;  // of the smallest things, one octet each; fewer of larger ones

// m: tells routes apart that are equally long, so that the answer does not depend on what is known from earlier requests.
double preference(int node) {
  std::uint64_t mixed = (static_cast<std::uint64_t>(node) + 1) * 0x9e3779b97f4a7c15u;
  mixed = (mixed ^ (mixed >> 30)) * 0xbf58476d1ce4e5b9u;
  return kPreference * static_cast<double>((mixed ^ (mixed >> 31)) >> 11) * 0x1p-53;
}

std::uint64_t pair_of(int a, int b) { return (static_cast<std::uint64_t>(a) << 32) | static_cast<std::uint32_t>(b); }

}  // namespace

KeptTruss::KeptTruss(const Model& model, const PreparedTruss& given)
    : scene(given), strides(model, given), legs(strides), filter(shared_reach_filter(model)) {
  for (const TransitionFoothold& one : given.transitions.all()) places.push_back(one.pose.translation());
  footing.assign(places.size(), -1);
  if (!listable()) return;
  rows_.resize(places.size());
  advances_.assign(places.size(), {-1.0, -1.0});
}

const Advances& KeptTruss::advances_of(int foothold) {
  Advances& out = advances_[static_cast<std::size_t>(foothold)];
  if (out.forth < 0.0) out = legs.advances_of(scene.transitions.all()[static_cast<std::size_t>(foothold)].foothold);
  return out;
}

const std::vector<std::uint8_t>& KeptTruss::row(int foothold) {
  std::vector<std::uint8_t>& out = rows_[static_cast<std::size_t>(foothold)];
  if (!out.empty()) return out;
  const auto& all = scene.transitions.all();
  const Foothold& from = all[static_cast<std::size_t>(foothold)].foothold;
  const Advances& of_from = advances_of(foothold);
  for (const int other : scene.transitions.of_face(from.face))
    out.push_back(static_cast<std::uint8_t>(
        std::min(255, legs.least(from, of_from, all[static_cast<std::size_t>(other)].foothold, advances_of(other)))));
  in_rows_ += out.size();
  return out;
}

TransitionLists& KeptTruss::lists() {
  if (!lists_) lists_.emplace(scene.transitions, *filter, strides.bounds().transition_reach());
  return *lists_;
}

void KeptTruss::tidy() {
  if (in_rows_ > kMostKept) {
    rows_.assign(rows_.size(), {});
    in_rows_ = 0;
  }
  if (judged.size() + walked.size() > kMostKept / 64) {
    judged.clear();
    walked.clear();
  }
  if (lists_ && lists_->entries() > kMostKept / 8) lists_.reset();
}

Banned banned_by(const std::vector<Ban>& bans) {
  if (bans.empty()) return {};
  return [&bans](const Foothold& a, const Foothold& b) {
    const auto near = [](const Foothold& ban, const Foothold& at, double within) {
      return same(ban, at) || (ban.face == at.face && (ban.at - at.at).norm() < within);
    };
    return std::any_of(bans.begin(), bans.end(), [&](const Ban& ban) {
      return (near(ban.one, a, ban.within) && near(ban.other, b, ban.within)) ||
             (near(ban.one, b, ban.within) && near(ban.other, a, ban.within));
    });
  };
}

TrussGraph::TrussGraph(const Model& model, const PreparedTruss& scene, KeptTruss& kept, const Foothold& start, const Foothold& goal,
                       const OptimalOptions& options)
    : model_(model),
      scene_(scene),
      kept_(kept),
      start_(start),
      goal_(goal),
      options_(options),
      banned_(banned_by(options.banned)),
      samples_(static_cast<int>(scene.transitions.all().size())),
      own_places_{pose_of(scene.truss, start).translation(), pose_of(scene.truss, goal).translation()} {
  start_face_ = scene.transitions.of_face(start.face);
  start_face_.push_back(this->start());
  if (goal.face == start.face) start_face_.push_back(this->goal());
  goal_face_ = scene.transitions.of_face(goal.face);
  goal_face_.push_back(this->goal());
  own_advances_ = {kept.legs.advances_of(start), kept.legs.advances_of(goal)};
}

const Foothold& TrussGraph::at(int node) const {
  if (node < samples_) return scene_.transitions.all()[static_cast<std::size_t>(node)].foothold;
  return node == start() ? start_ : goal_;
}

Isometry3d TrussGraph::pose(int node) const {
  if (node < samples_) return scene_.transitions.all()[static_cast<std::size_t>(node)].pose;
  return pose_of(scene_.truss, at(node));
}

const Vector3d& TrussGraph::place(int node) const {
  return node < samples_ ? kept_.places[static_cast<std::size_t>(node)] : own_places_[static_cast<std::size_t>(node - samples_)];
}

Cost TrussGraph::of(int strides, double length) const {
  return options_.objective == Objective::kSteps ? Cost{static_cast<double>(strides), length}
                                                 : Cost{length, static_cast<double>(strides)};
}

std::span<const int> TrussGraph::on_face(int face) const {
  if (face == start_.face) return start_face_;
  if (face == goal_.face) return goal_face_;
  return scene_.transitions.of_face(face);
}

const std::vector<std::uint8_t>* TrussGraph::row_of(int node) { return node < samples_ ? &kept_.row(node) : nullptr; }

// on_face() begins with the scene's footholds, in the order of a row.
int TrussGraph::least(int node, const std::vector<std::uint8_t>* row, std::size_t index, int other) {
  return row != nullptr && other < samples_ ? (*row)[index]
                                            : kept_.legs.least(at(node), advances_of(node), at(other), advances_of(other));
}

void TrussGraph::leg_bounds(int node, std::span<Cost> out) {
  const std::span<const int> there = on_face(face_of(node));
  const std::vector<std::uint8_t>* row = row_of(node);
  const Vector3d from = place(node);
  for (std::size_t i = 0; i < there.size(); ++i) {
    const double distance = (place(there[i]) - from).norm();
    out[i] = there[i] == node ? Cost{} : of(least(node, row, i, there[i]), distance);
  }
}

void TrussGraph::leg_firsts(int node, std::span<double> out) {
  const std::span<const int> there = on_face(face_of(node));
  const std::vector<std::uint8_t>* row = row_of(node);
  const bool steps = options_.objective == Objective::kSteps;
  const Vector3d from = place(node);
  for (std::size_t i = 0; i < there.size(); ++i) {
    if (there[i] == node)
      out[i] = 0.0;
    else  // a row knows without the distance
      out[i] = steps ? least(node, row, i, there[i]) : (place(there[i]) - from).norm();
  }
}

double TrussGraph::from_start(int node) {
  const double distance = (place(node) - own_places_[0]).norm();
  if (options_.objective == Objective::kDistance) return distance;
  return std::ceil(distance / kept_.strides.bounds().transition_reach() - 1e-9);
}

double TrussGraph::second_to_goal(int node) {
  const double distance = (place(node) - own_places_[1]).norm();
  if (options_.objective == Objective::kSteps) return distance;
  return std::ceil(distance / kept_.strides.bounds().transition_reach() - 1e-9);
}

bool TrussGraph::footing(int node) {
  signed char& known = node < samples_ ? kept_.footing[static_cast<std::size_t>(node)] : own_footing_[node == start() ? 0 : 1];
  if (known < 0) known = kept_.legs.has_footing(at(node), node >= samples_) ? 1 : 0;
  return known == 1;
}

bool TrussGraph::hemmed_in(int end) {
  if (footing(end)) return false;
  std::vector<int> others;
  for (const Transition& transition : own_list(end)) others.push_back(transition.to);
  if (std::any_of(others.begin(), others.end(), [&](int to) { return transition(end, to); })) return false;
  return start_.face != goal_.face || walk(start(), goal()).strides.empty();
}

const KeptTruss::Leg& TrussGraph::walk(int from, int to) {
  if (const auto achieved = achieved_.find(pair_of(from, to)); achieved != achieved_.end()) return achieved->second;
  const KeptTruss::Leg& leg = walk(from, to, {}, std::max(from, to) >= samples_ ? own_walked_ : kept_.walked);
  // What is not there without bans is not there with them, and most of what is there they do not touch.
  Foothold before = at(from);
  const auto touched = [&](const Stride& stride) { return banned_(std::exchange(before, stride.to), stride.to); };
  if (!banned_ || std::none_of(leg.strides.begin(), leg.strides.end(), touched)) return leg;
  return walk(from, to, banned_, round_bans_);
}

const KeptTruss::Leg& TrussGraph::walk(int from, int to, const Banned& banned, Walked& known) {
  const auto [entry, fresh] = known.try_emplace(pair_of(from, to));
  KeptTruss::Leg& leg = entry->second;
  if (!fresh) return leg;
  leg.least = kept_.legs.least(at(from), at(to));
  if (leg.least == 0) {
    leg.found = true;
    return leg;
  }
  constexpr int kMore = 3;
  if (!footing(from) || !footing(to)) return leg;
  const int most = kept_.legs.likely(at(from), at(to)) + kMore;
  for (int count = leg.least; count <= most && !leg.found; ++count)
    if (auto found = kept_.legs.find(at(from), at(to), count, banned)) {
      leg.found = true;
      leg.strides = std::move(*found);
    } else if (count == 1 && !banned) {
      leg.least = 2;  // by exact reachability
    }
  return leg;
}

// Legs between the same two corners of a face mostly fail together, where a beam stands in the way, and so do all from or to a
// corner that is hemmed in: after so many of them that all failed the others are taken to fail. This leaves routes out but proves
// nothing: leg()'s proved costs do not ask it.
bool TrussGraph::barred(int from, int to) const {
  const auto fails = [this](std::uint64_t corners, int most) {
    const auto known = failures_.find(corners);
    return known != failures_.end() && known->second >= most;
  };
  const std::uint64_t a = corner(from), b = corner(to);
  return fails(a << 32 | b, kToldByPair) || fails(a << 32, kToldByCorner) || fails(b, kToldByCorner);
}

void TrussGraph::tell(int from, int to, bool found) {
  const std::uint64_t a = corner(from), b = corner(to);
  for (const std::uint64_t corners : {a << 32 | b, a << 32, b}) {
    int& failures = failures_[corners];
    if (failures >= 0) failures = found ? kNeverBarred : failures + 1;
  }
}

// Where on its face a foothold stands, and whether along or across; never 0.
std::uint32_t TrussGraph::corner(int node) const {
  const Foothold& foothold = at(node);
  const auto cell = [](double place) { return static_cast<std::uint32_t>(std::lround(place / kCorner)) & 0xff; };
  const auto across = static_cast<std::uint32_t>(std::lround(foothold.heading / (0.5 * std::numbers::pi))) & 1;
  return (static_cast<std::uint32_t>(foothold.face) + 1) << 17 | cell(foothold.at.x()) << 9 | cell(foothold.at.y()) << 1 | across;
}

Cost TrussGraph::leg(int from, int to, bool proved) {
  const double straight_way = (at(to).at - at(from).at).norm();
  if (proved) {
    int least = kept_.legs.least_exactly(at(from), at(to));
    if (least == 1) least = walk(from, to).least;
    const auto doubted = doubtful_.find(pair_of(from, to));
    return of(doubted == doubtful_.end() ? least : std::max(least, doubted->second + 1), straight_way);
  }
  if (guesses_ && barred(from, to)) {
    guessed_ = true;
    return kNever;
  }
  const KeptTruss::Leg& leg = walk(from, to);
  tell(from, to, leg.found);
  if (!leg.found) return kNever;
  double length = 0.0;
  Vector2d before = at(from).at;
  for (const Stride& stride : leg.strides) {
    length += (stride.to.at - before).norm();
    before = stride.to.at;
  }
  return of(static_cast<int>(leg.strides.size()), length < straight_way + kSameLength ? straight_way : length);
}

bool TrussGraph::achieve(int from, int to) {
  const int wanted = static_cast<int>(leg(from, to, true).first);
  const KeptTruss::Leg& known = walk(from, to);
  if (known.found && static_cast<int>(known.strides.size()) <= wanted) return true;
  // For this request alone: answers do not depend on what was asked before.
  if (auto found = kept_.legs.find_thoroughly(at(from), at(to), wanted, banned_)) {
    achieved_[pair_of(from, to)] = {known.least, true, std::move(*found)};
    return true;
  }
  doubtful_[pair_of(from, to)] = wanted;
  return false;
}

const std::vector<RouteGraph::Transition>& TrussGraph::own_list(int node) {
  static const std::vector<Transition> none;
  if (own_lists_.empty()) {
    list_own(start());
    list_own(goal());
  }
  const auto own = own_lists_.find(node);
  return own == own_lists_.end() ? none : own->second;
}

// `end`: start or goal. What may be reached from it, and it from there.
void TrussGraph::list_own(int end) {
  const Isometry3d sole = pose(end);
  own_lists_[end] = kept_.lists().around(sole, face_of(end));
  for (const Transition& transition : own_lists_[end]) own_lists_[transition.to].push_back({end, -1, transition.distance});
  if (end == start() || start_.face == goal_.face) return;
  if (!kept_.filter->may_reach(sole.inverse(Eigen::Isometry) * pose(start()))) return;
  const double distance = (own_places_[1] - own_places_[0]).norm();
  own_lists_[start()].push_back({goal(), -1, distance});
  own_lists_[goal()].push_back({start(), -1, distance});
}

std::array<std::span<const RouteGraph::Transition>, 2> TrussGraph::transitions(int node) {
  std::array<std::span<const Transition>, 2> out;
  if (node < samples_) out[0] = kept_.lists().of(node);
  out[1] = own_list(node);
  return out;
}

Cost TrussGraph::cost(int node, const Transition& transition) const {
  return of(1, transition.distance + preference(node) + preference(transition.to));
}

// What is found impossible leaves the lists.
const std::optional<Coordinates>& TrussGraph::judge(int from, int to) {
  const bool own = std::max(from, to) >= samples_;
  const auto [entry, fresh] = (own ? own_judged_ : kept_.judged).try_emplace(pair_of(from, to));
  if (!fresh) return entry->second;
  const Isometry3d holding = pose(from);
  const Isometry3d seen = holding.inverse(Eigen::Isometry) * pose(to);
  entry->second = kept_.strides.alone(seen);
  if (entry->second && kept_.strides.clear(*entry->second, holding)) return entry->second;
  const bool alone = entry->second.has_value();
  if (alone) entry->second = kept_.strides.exact(at(from), at(to));
  if (entry->second) return entry->second;
  if (!own && kept_.large()) return entry->second;
  if (!own) {
    if (alone)
      kept_.lists().exclude(from, to);
    else
      kept_.lists().exclude_alike(from, to);
  } else {
    for (const auto& [one, other] : {std::pair(from, to), std::pair(to, from)})
      std::erase_if(own_lists_[one], [other = other](const Transition& transition) { return transition.to == other; });
  }
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
