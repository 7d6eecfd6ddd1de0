// Best-first search over base points, placements judged when they are taken from the queue.
#include "bioloid/steps/footsteps.hpp"

#include <algorithm>
#include <limits>
#include <queue>
#include <tuple>
#include <unordered_map>

#include "bioloid/gait/gait.hpp"

namespace foothold::bioloid {
namespace {

constexpr double kSame = 1e-9, kSlack = 1e-9;

double to_left(Side side) { return side == Side::kLeft ? 1.0 : -1.0; }

// A foot that stands: on the lattice, or where it stood at the start, or at the goal.
struct Node {
  enum class Kind : std::int32_t { kLattice, kStart, kGoal, kDone };
  Kind kind = Kind::kLattice;
  Side side = Side::kRight;
  std::int32_t i = 0, j = 0, h = 0;
  friend bool operator==(const Node&, const Node&) = default;
};

struct NodeHash {
  std::size_t operator()(const Node& node) const {
    std::uint64_t mix = static_cast<std::uint64_t>(node.kind) * 2 + index_of(node.side);
    for (const std::int32_t part : {node.i, node.j, node.h}) mix = (mix ^ static_cast<std::uint32_t>(part)) * 0x9E3779B97F4A7C15ULL;
    return static_cast<std::size_t>(mix ^ (mix >> 29));
  }
};

struct Entry {
  std::size_t steps = 0;     // so far
  double total = 0.0;        // with the (weighted) bound of what remains
  double left = 0.0;         // finer than the bound, among equals
  std::int64_t from = -1;    // index of the closed node that it comes from
  std::int32_t stride = -1;  // between points of the lattice: which
  bool accepted = false;     // else it is judged when it is taken
  Node node;
  PlanarPose base;
  // Last: the best. Fewest in all, then deepest, then nearest.
  bool operator<(const Entry& b) const { return std::tie(total, b.steps, left) > std::tie(b.total, steps, b.left); }
};

// What is known of a node: the fewest placements that surely lead to it, and its bound.
struct Reached {
  std::size_t steps = std::numeric_limits<std::size_t>::max();
  double least = -1.0, finer = 0.0;  // of what remains; not yet worked out
  bool done = false;
};

struct Closed {
  Node node;
  PlanarPose base;
  std::int64_t from = -1;
  bool open = false;  // Acceptance::open
};

class Search {
 public:
  Search(const Feet& start, const FootstepGoal& goal, double half, const StepOptions& options, const Acceptance& acceptance)
      : start_(start),
        goal_(goal),
        half_(half),
        options_(options),
        acceptance_(acceptance),
        anchor_(base_of(Side::kRight, start.right, half)) {
    headings_ = static_cast<std::int32_t>(std::lround(2.0 * M_PI / options.heading));
    list_strides();
  }

  // `weight` of the bound; routes of `below` placements or more are not looked for.
  Footsteps run(double weight, std::size_t below, std::size_t most, std::stop_token stop) {
    Footsteps out;
    if (at_goal(base_of(Side::kRight, start_.right, half_)) && at_goal(base_of(Side::kLeft, start_.left, half_)))
      return ended(out, Footsteps::End::kFound);
    weight_ = weight;
    for (const Side side : {Side::kRight, Side::kLeft})
      push({Node::Kind::kStart, side, 0, 0, 0}, base_of(side, start_.of(side), half_), 0, -1);
    while (!open_.empty()) {
      const Entry at = open_.top();
      if (weight == 1.0) out.least = std::max(out.least, static_cast<std::size_t>(at.total));
      if (out.least >= below) return ended(out, Footsteps::End::kNone);
      if (stop.stop_requested()) return ended(out, Footsteps::End::kStopped);
      open_.pop();
      Reached& reached = reached_[at.node];
      if (reached.done || (at.from >= 0 && !at.accepted && !accepted(at))) continue;
      reached.done = true;
      closed_.push_back({at.node, at.base, at.from, acceptance_.open(sole_at(at.node.side, at.base, half_))});
      if (at.node.kind == Node::Kind::kDone) {
        out.steps = way();
        return ended(out, Footsteps::End::kFound);
      }
      if (closed_.size() > most) return ended(out, Footsteps::End::kTooMany);
      expand(at, static_cast<std::int64_t>(closed_.size()) - 1);
    }
    out.least = below;
    return ended(out, Footsteps::End::kNone);
  }

 private:
  bool at_goal(const PlanarPose& base) const {
    return std::hypot(base.x - goal_.base.x, base.y - goal_.base.y) < kSame &&
           (goal_.any_heading || std::abs(wrapped(base.heading - goal_.base.heading)) < kSame);
  }

  Footsteps ended(Footsteps out, Footsteps::End end) const {
    out.end = end;
    out.expanded = closed_.size();
    return out;
  }

  // How far a placement brings the base point along a line that lies `angle` from the standing foot's heading, at most, over all
  // angles at least as large.
  double most_along(double angle) const {
    const double ahead = angle < 0.5 * M_PI ? options_.length * std::cos(angle) : 0.0;
    const double across = angle < 0.5 * M_PI ? options_.width * std::sin(angle) : options_.width;
    return std::max({std::hypot(ahead, across), options_.width, options_.back});
  }

  // Placements until this foot is at the goal, at least, and one more to bring the other beside it.
  std::pair<double, double> left(const PlanarPose& base) const {
    const double way = std::hypot(goal_.base.x - base.x, goal_.base.y - base.y);
    const double turn = goal_.any_heading ? 0.0 : std::abs(wrapped(base.heading - goal_.base.heading));
    const double longest = std::max({options_.length, options_.width, options_.back});
    int count = static_cast<int>(std::ceil(std::max(way / longest, turn / options_.turn) - 1e-7));
    const double finer = way / longest + turn / options_.turn + 1.0;
    if (way < kSame) return {count + 1, finer};
    const double direction = std::atan2(goal_.base.y - base.y, goal_.base.x - base.x);
    const double first = std::abs(wrapped(direction - base.heading));
    const double last = goal_.any_heading ? 0.0 : std::abs(wrapped(direction - goal_.base.heading));
    for (;; ++count) {
      double along = 0.0;
      for (int k = 0; k < count && along < way; ++k) {
        const double off = std::max(first - k * options_.turn, last - (count - k) * options_.turn);
        along += off > 0.0 ? most_along(off) : longest;
      }
      if (along >= way - 1e-7 * longest) break;
    }
    return {count + 1, finer};
  }

  void push(const Node& node, const PlanarPose& base, std::size_t steps, std::int64_t from, std::int32_t stride = -1) {
    Reached& to = reached_[node];
    if (to.done || to.steps <= steps) return;
    if (to.least < 0.0) std::tie(to.least, to.finer) = node.kind == Node::Kind::kDone ? std::pair{0.0, 0.0} : left(base);
    Entry entry{steps, static_cast<double>(steps) + weight_ * to.least, to.finer, from, stride, false, node, base};
    // Of a placement that is accepted already no later one to the same place needs to be kept.
    if (stride >= 0 && known(entry) == LatticeStride::Known::kReaches && closed_[static_cast<std::size_t>(from)].open) {
      entry.accepted = true;
      to.steps = steps;
    }
    open_.push(entry);
  }

  // A placement from one point of the lattice to another: the same for all headings that a quarter turn makes equal.
  struct LatticeStride {
    std::int32_t i, j, turn;
    enum class Known : std::int8_t { kNothing, kReaches, kDoesNot } known = Known::kNothing;
  };

  // All that a step may do, by standing side and heading within a quarter turn.
  void list_strides() {
    const auto most = static_cast<std::int32_t>(std::floor(options_.turn / options_.heading + kSlack));
    const auto far =
        static_cast<std::int32_t>(std::ceil(std::max({options_.length, options_.back, options_.width}) / options_.cell));
    strides_.resize(2 * static_cast<std::size_t>(quarter()));
    for (const Side side : {Side::kRight, Side::kLeft})
      for (std::int32_t h = 0; h < quarter(); ++h) {
        const double c = std::cos(h * options_.heading), s = std::sin(h * options_.heading);
        for (std::int32_t turn = -most; turn <= most; ++turn)
          for (std::int32_t i = -far; i <= far; ++i)
            for (std::int32_t j = -far; j <= far; ++j) {
              const double x = i * options_.cell, y = j * options_.cell;
              if (within_step(side, {c * x + s * y, c * y - s * x, turn * options_.heading}, options_))
                strides_[of_heading(side, h)].push_back({i, j, turn});
            }
      }
  }
  std::int32_t quarter() const { return headings_ / 4; }
  std::size_t of_heading(Side side, std::int32_t h) const {
    return index_of(side) * static_cast<std::size_t>(quarter()) + static_cast<std::size_t>(h % quarter());
  }
  // (i, j) turned by whole quarters.
  static std::pair<std::int32_t, std::int32_t> turned(std::int32_t i, std::int32_t j, std::int32_t quarters) {
    for (; quarters > 0; --quarters) std::tie(i, j) = std::pair{-j, i};
    return {i, j};
  }

  bool accepted(const Entry& at) {
    const Closed& from = closed_[static_cast<std::size_t>(at.from)];
    const Side support = from.node.side, moves = other(support);
    const PlanarPose sole = sole_at(support, from.base, half_);
    const PlanarPose place = rounded(relative(sole, sole_at(moves, at.base, half_)));
    if (!from.open) return acceptance_.accept({support, sole, place});
    if (at.stride < 0) return acceptance_.reaches(support, place);
    auto& reaches = known(at);
    using Known = LatticeStride::Known;
    if (reaches == Known::kNothing) reaches = acceptance_.reaches(support, place) ? Known::kReaches : Known::kDoesNot;
    return reaches == Known::kReaches;
  }
  LatticeStride::Known& known(const Entry& at) {
    const Node& from = closed_[static_cast<std::size_t>(at.from)].node;
    return strides_[of_heading(from.side, from.h)][static_cast<std::size_t>(at.stride)].known;
  }

  PlanarPose pose_of(std::int32_t i, std::int32_t j, std::int32_t h) const {
    return anchor_ * PlanarPose{i * options_.cell, j * options_.cell, wrapped(h * options_.heading)};
  }

  void expand(const Entry& at, std::int64_t index) {
    const Side support = at.node.side, moves = other(support);
    if (at_goal(at.base)) {
      // The feet are closed: the end.
      push({Node::Kind::kDone, moves, 0, 0, 0}, at.base, at.steps + 1, index);
    } else {
      PlanarPose goal = goal_.base;
      if (goal_.any_heading) goal.heading = at.base.heading;
      if (within_step(support, relative(at.base, goal), options_))
        push({Node::Kind::kGoal, moves, 0, 0, goal_.any_heading ? at.node.h + 1000 * static_cast<std::int32_t>(at.node.kind) : 0},
             goal, at.steps + 1, index);
    }
    if (at.node.kind == Node::Kind::kLattice) {
      const std::vector<LatticeStride>& strides = strides_[of_heading(support, at.node.h)];
      for (std::size_t k = 0; k < strides.size(); ++k) {
        if (strides[k].known == LatticeStride::Known::kDoesNot) continue;
        const auto [i, j] = turned(strides[k].i, strides[k].j, at.node.h / quarter());
        const Node node{Node::Kind::kLattice, moves, at.node.i + i, at.node.j + j,
                        (at.node.h + strides[k].turn + headings_) % headings_};
        push(node, pose_of(node.i, node.j, node.h), at.steps + 1, index, static_cast<std::int32_t>(k));
      }
      return;
    }
    const PlanarPose seen = relative(anchor_, at.base);
    const double reach = std::max(options_.length, options_.width) + options_.cell;
    const auto low = [&](double value) { return static_cast<std::int32_t>(std::ceil((value - reach) / options_.cell)); };
    const auto high = [&](double value) { return static_cast<std::int32_t>(std::floor((value + reach) / options_.cell)); };
    const auto most = static_cast<std::int32_t>(std::floor(options_.turn / options_.heading + kSlack)) + 1;
    const auto near = static_cast<std::int32_t>(std::lround(seen.heading / options_.heading));
    for (std::int32_t turn = -most; turn <= most; ++turn) {
      const std::int32_t h = ((near + turn) % headings_ + headings_) % headings_;
      const double heading = wrapped(h * options_.heading - seen.heading);
      if (std::abs(heading) > options_.turn + kSlack) continue;
      const double c = std::cos(seen.heading), s = std::sin(seen.heading);
      for (std::int32_t i = low(seen.x); i <= high(seen.x); ++i)
        for (std::int32_t j = low(seen.y); j <= high(seen.y); ++j) {
          const double x = i * options_.cell - seen.x, y = j * options_.cell - seen.y;
          if (within_step(support, {c * x + s * y, c * y - s * x, heading}, options_))
            push({Node::Kind::kLattice, moves, i, j, h}, pose_of(i, j, h), at.steps + 1, index);
        }
    }
  }

  std::vector<Footstep> way() const {
    std::vector<Footstep> out;
    for (std::int64_t k = static_cast<std::int64_t>(closed_.size()) - 1; k >= 0;) {
      const Closed& at = closed_[static_cast<std::size_t>(k)];
      if (at.from >= 0) out.push_back({at.node.side, sole_at(at.node.side, at.base, half_)});
      k = at.from;
    }
    std::reverse(out.begin(), out.end());
    return out;
  }

  const Feet& start_;
  const FootstepGoal& goal_;
  double half_;
  const StepOptions& options_;
  const Acceptance& acceptance_;
  PlanarPose anchor_;
  std::int32_t headings_ = 24;
  double weight_ = 1.0;
  std::vector<std::vector<LatticeStride>> strides_;
  std::priority_queue<Entry> open_;
  std::unordered_map<Node, Reached, NodeHash> reached_;
  std::vector<Closed> closed_;
};

}  // namespace

PlanarPose base_of(Side side, const PlanarPose& sole, double half_spacing) {
  return sole * PlanarPose{0.0, -to_left(side) * half_spacing, 0.0};
}

PlanarPose sole_at(Side side, const PlanarPose& base, double half_spacing) {
  return base * PlanarPose{0.0, to_left(side) * half_spacing, 0.0};
}

bool within_step(Side support, const PlanarPose& to, const StepOptions& options) {
  const double out = to_left(other(support)) * to.y;  // away from the standing foot
  if (std::abs(wrapped(to.heading)) > options.turn + kSlack || out < -options.cell - kSlack) return false;
  const double along = to.x / (to.x >= 0.0 ? options.length : options.back),
               across = out / (out >= 0.0 ? options.width : options.cell);
  return along * along + across * across <= 1.0 + 1e-7;
}

Footsteps find_footsteps(const Feet& start, const FootstepGoal& goal, double half_spacing, const StepOptions& options,
                         const Acceptance& acceptance, std::stop_token stop) {
  constexpr double kWeight = 1.5;
  return Search(start, goal, half_spacing, options, acceptance)
      .run(kWeight, std::numeric_limits<std::size_t>::max(), options.most_nodes, stop);
}

Footsteps least_footsteps(const Feet& start, const FootstepGoal& goal, double half_spacing, const StepOptions& options,
                          std::size_t below, std::size_t most, const Acceptance& acceptance, std::stop_token stop) {
  return Search(start, goal, half_spacing, options, acceptance).run(1.0, below, most, stop);
}

}  // namespace foothold::bioloid
