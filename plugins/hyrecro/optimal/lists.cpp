#include "hyrecro/optimal/lists.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace foothold::hyrecro {
namespace {

constexpr double kSame = 1e-7;  // m: places along lines, or directions, nearer than this are one

std::size_t at(int i) { return static_cast<std::size_t>(i); }

std::uint64_t mixed(std::uint64_t seed, std::uint32_t value) {
  seed = (seed ^ value) * 0x9e3779b97f4a7c15u;
  return seed ^ (seed >> 29);
}

std::int32_t rounded(double value) { return static_cast<std::int32_t>(std::lround(value / kSame)); }

}  // namespace

std::size_t TransitionLists::CellHash::operator()(const Cell& cell) const {
  std::uint64_t out = 1;
  for (const int value : {cell.x, cell.y, cell.z}) out = mixed(out, static_cast<std::uint32_t>(value));
  return out;
}

std::size_t TransitionLists::KeyHash::operator()(const Key& key) const {
  std::uint64_t out = 2;
  for (const std::int32_t value : key) out = mixed(out, static_cast<std::uint32_t>(value));
  return out;
}

TransitionLists::TransitionLists(const Transitions& transitions, const ReachFilter& filter, double reach)
    : transitions_(&transitions), filter_(&filter), reach_(reach) {
  const std::size_t count = transitions.all().size();
  line_of_.assign(count, -1);
  lists_.resize(count);
  cleaned_.assign(count, 0);
  make_lines();
  listed_.assign(lines_.size(), 0);
}

TransitionLists::Cell TransitionLists::cell_of(const Vector3d& point) const {
  return {static_cast<int>(std::floor(point.x() / reach_)), static_cast<int>(std::floor(point.y() / reach_)),
          static_cast<int>(std::floor(point.z() / reach_))};
}

// Footholds of one face, towards one other, with one heading, on one line across that heading.
void TransitionLists::make_lines() {
  std::map<std::tuple<int, int, bool, std::int32_t, std::int32_t>, int> known;
  for (std::size_t i = 0; i < line_of_.size(); ++i) {
    const TransitionFoothold& one = transitions_->all()[i];
    const Foothold& f = one.foothold;
    const Eigen::Vector2d ahead(std::cos(f.heading), std::sin(f.heading));
    const auto [entry, fresh] = known.try_emplace(
        std::tuple(f.face, one.towards, one.convex, rounded(f.heading), rounded(f.at.dot(ahead))), static_cast<int>(lines_.size()));
    if (fresh) {
      Line line;
      line.face = f.face;
      line.origin = one.pose.translation();
      line.axes = one.pose.linear();
      line.along = one.pose.linear().col(1);
      lines_.push_back(line);
    }
    line_of_[i] = entry->second;
    lines_[at(entry->second)].footholds.push_back(static_cast<int>(i));
  }
  for (std::size_t k = 0; k < lines_.size(); ++k) {
    Line& line = lines_[k];
    const auto place = [&](int i) { return line.along.dot(transitions_->all()[at(i)].pose.translation() - line.origin); };
    std::stable_sort(line.footholds.begin(), line.footholds.end(), [&](int a, int b) { return place(a) < place(b); });
    for (const int i : line.footholds) {
      line.places.push_back(place(i));
      std::vector<int>& cell = cells_[cell_of(transitions_->all()[at(i)].pose.translation())];
      if (cell.empty() || cell.back() != static_cast<int>(k)) cell.push_back(static_cast<int>(k));
    }
  }
}

int TransitionLists::kind_of(const Isometry3d& pose) {
  Key key;
  for (int i = 0; i < 3; ++i) {
    key[at(3 * i)] = rounded(pose.translation()[i]);
    key[at(3 * i + 1)] = rounded(pose.linear()(i, 0));
    key[at(3 * i + 2)] = rounded(pose.linear()(i, 1));
  }
  const auto [entry, fresh] = kinds_.try_emplace(key, static_cast<int>(excluded_.size()));
  if (fresh) excluded_.push_back(0);
  return entry->second;
}

const ReachFilter::Turn& TransitionLists::turn_of(const Eigen::Matrix3d& orientation) {
  constexpr std::size_t kMostTurns = 20'000;
  Key key;
  for (int i = 0; i < 9; ++i) key[at(i)] = rounded(orientation(i / 3, i % 3));
  if (turns_.size() > kMostTurns) turns_.clear();
  const auto [entry, fresh] = turns_.try_emplace(key);
  if (fresh) entry->second = filter_->turn(orientation);
  return entry->second;
}

// All footholds of a line at once.
void TransitionLists::list(int index) {
  listed_[at(index)] = 1;
  const Line& line = lines_[at(index)];
  std::vector<int> near;
  Cell last{1 << 30, 0, 0};
  for (const int i : line.footholds) {
    const Cell middle = cell_of(transitions_->all()[at(i)].pose.translation());
    if (middle == last) continue;
    last = middle;
    const std::vector<int> there = lines_near(transitions_->all()[at(i)].pose.translation());
    near.insert(near.end(), there.begin(), there.end());
  }
  std::sort(near.begin(), near.end());
  near.erase(std::unique(near.begin(), near.end()), near.end());
  for (const int other : near)
    if (lines_[at(other)].face != line.face) pair(line, lines_[at(other)]);
}

std::vector<int> TransitionLists::lines_near(const Vector3d& point) const {
  const Cell middle = cell_of(point);
  std::vector<int> out;
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (const auto cell = cells_.find({middle.x + x, middle.y + y, middle.z + z}); cell != cells_.end())
          out.insert(out.end(), cell->second.begin(), cell->second.end());
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

std::vector<TransitionLists::Entry> TransitionLists::around(const Isometry3d& sole, int face) {
  std::vector<Entry> out;
  const Eigen::Matrix3d back = sole.linear().transpose();
  for (const int index : lines_near(sole.translation())) {
    const Line& line = lines_[at(index)];
    if (line.face == face) continue;
    const Vector3d offset = back * (line.origin - sole.translation()), along = back * line.along;
    const Vector3d ball = filter_->ball(back * line.axes), middle = offset + ball;
    const double apart = filter_->apart(), half = middle.dot(along), root = half * half - middle.squaredNorm() + apart * apart;
    if (root < 0.0) continue;
    const auto begin = std::lower_bound(line.places.begin(), line.places.end(), -half - std::sqrt(root));
    if (begin == line.places.end() || *begin > -half + std::sqrt(root)) continue;
    const ReachFilter::Turn turn = filter_->turn(back * line.axes);
    if (turn.never()) continue;
    for (auto place = begin; place != line.places.end() && *place <= -half + std::sqrt(root); ++place)
      if (const Vector3d there = offset + *place * along; filter_->may_reach(turn, there))
        out.push_back({line.footholds[static_cast<std::size_t>(place - line.places.begin())], -1, there.norm()});
  }
  return out;
}

void TransitionLists::pair(const Line& from, const Line& to) {
  const Eigen::Matrix3d back = from.axes.transpose();
  // The other line seen from the foothold at the place 0 of this one, whose own line is the Y axis.
  const Vector3d offset = back * (to.origin - from.origin), along = back * to.along;
  const Vector3d ball = filter_->ball(back * to.axes);
  const ReachFilter::Turn* turn = nullptr;
  const bool parallel = std::hypot(along.x(), along.z()) < kSame;
  const double apart = filter_->apart();
  Isometry3d seen = Isometry3d::Identity();
  seen.linear() = back * to.axes;
  std::vector<std::pair<std::int32_t, int>> judged;  // by the distance along parallel lines: kind, -1: out of reach
  for (std::size_t a = 0; a < from.footholds.size(); ++a) {
    // Where the other line is within the ball, and beside this foothold by no more than a singular pose may be.
    const Vector3d base = offset - Vector3d(0.0, from.places[a], 0.0), middle = base + ball;
    const double half = middle.dot(along), root = half * half - middle.squaredNorm() + apart * apart;
    if (root < 0.0) continue;
    double low = -half - std::sqrt(root), high = -half + std::sqrt(root);
    if (to.places.back() < low || to.places.front() > high) continue;
    if (turn == nullptr) {
      turn = &turn_of(back * to.axes);
      if (turn->never()) return;
    }
    if (turn->singular && parallel) {
      const double beside = -base.y() * along.y();
      low = std::max(low, beside - filter_->aside() - kSame);
      high = std::min(high, beside + filter_->aside() + kSame);
    }
    const auto begin = std::lower_bound(to.places.begin(), to.places.end(), low);
    for (auto place = begin; place != to.places.end() && *place <= high; ++place) {
      seen.translation() = base + *place * along;
      const std::int32_t key = rounded(seen.translation().y());
      const auto known =
          parallel ? std::find_if(judged.begin(), judged.end(), [key](const auto& j) { return j.first == key; }) : judged.end();
      int kind = -1;
      if (known != judged.end()) {
        kind = known->second;
      } else {
        if (filter_->may_reach(*turn, seen.translation())) kind = kind_of(seen);
        if (parallel) judged.emplace_back(key, kind);
      }
      if (kind < 0) continue;
      lists_[at(from.footholds[a])].push_back(
          {to.footholds[static_cast<std::size_t>(place - to.places.begin())], kind, seen.translation().norm()});
      ++entries_;
    }
  }
}

const std::vector<TransitionLists::Entry>& TransitionLists::of(int foothold) {
  if (!listed_[at(line_of_[at(foothold)])]) list(line_of_[at(foothold)]);
  std::vector<Entry>& out = lists_[at(foothold)];
  if (cleaned_[at(foothold)] != exclusions_) {
    std::erase_if(out, [&](const Entry& entry) { return excluded_[at(entry.kind)]; });
    cleaned_[at(foothold)] = exclusions_;
  }
  return out;
}

void TransitionLists::exclude_alike(int one, int other) {
  for (const auto& [from, to] : {std::pair(one, other), std::pair(other, one)})
    for (const Entry& entry : of(from))
      if (entry.to == to) excluded_[at(entry.kind)] = 1;
  ++exclusions_;
}

void TransitionLists::exclude(int one, int other) {
  for (const auto& [from, to] : {std::pair(one, other), std::pair(other, one)}) {
    of(from);
    std::erase_if(lists_[at(from)], [to = to](const Entry& entry) { return entry.to == to; });
  }
}

}  // namespace foothold::hyrecro
