// Pairwise order where faces overlap, then a topological order; cuts where no order exists.
#include "painter.hpp"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>

#include "screen_grid.hpp"

namespace foothold::drawing {
namespace {

constexpr double kLeastOverlap = 0.05;  // px^2

enum class Order { kNone, kFirstNearer, kSecondNearer, kSame, kCrossing };

struct Comparison {
  Order order = Order::kNone;
  Vector3d where = Vector3d::Zero();  // the overlap's middle
};

Comparison compare(const Points& a, const Points& b) {
  const Points common = overlap(a, b);
  if (common.empty() || flat_area(common) < kLeastOverlap) return {};
  const auto plane = depth_plane(b);
  if (!plane) return {};
  double least = INFINITY, most = -INFINITY;
  for (const Vector3d& p : common) {
    least = std::min(least, p.z() - (*plane)(p));
    most = std::max(most, p.z() - (*plane)(p));
  }
  const Vector3d where = mean(common);
  if (least >= -kSameDepth && most <= kSameDepth) return {Order::kSame, where};
  if (least >= -kSameDepth) return {Order::kFirstNearer, where};
  if (most <= kSameDepth) return {Order::kSecondNearer, where};
  return {Order::kCrossing, where};
}

// The part of a face where `value` is not below 0. The new edge is no outline.
template <class Value>
SeenFace part(const SeenFace& face, Value&& value) {
  SeenFace result;
  result.shade = face.shade;
  result.body = face.body;
  for (std::size_t i = 0; i < face.points.size(); ++i) {
    const Vector3d& a = face.points[i];
    const Vector3d& b = face.points[(i + 1) % face.points.size()];
    const double at_a = value(a), at_b = value(b);
    if (at_a >= 0.0) {
      result.points.push_back(a);
      result.outline.push_back(face.outline[i]);
    }
    if ((at_a < 0.0) != (at_b < 0.0)) {
      result.points.push_back(a + (b - a) * (at_a / (at_a - at_b)));
      // Leaving the part, the cut begins here; entering it, the rest of this edge does.
      result.outline.push_back(at_a < 0.0 && face.outline[i]);
    }
  }
  return result;
}

class Painting {
 public:
  explicit Painting(std::vector<SeenFace> faces);
  std::vector<SeenFace> ordered();

 private:
  struct Node {
    SeenFace face;
    std::size_t rank = 0;  // the number of the face it was cut from
    double depth = 0.0;
    std::vector<std::size_t> nearer;  // to be drawn after it
    std::vector<std::size_t> farther;
    std::size_t waits_for = 0;
    bool placed = true;  // drawn or cut into others
  };

  void insert(SeenFace face, std::size_t rank);
  // Two parts of more than nothing each, or none.
  template <class Value>
  bool cut(const SeenFace& face, std::size_t rank, Value&& value);
  void release(std::size_t number);
  void open_ring();
  Comparison compare_nodes(std::size_t a, std::size_t b) const { return compare(nodes_[a].face.points, nodes_[b].face.points); }

  std::vector<Node> nodes_;
  ScreenGrid grid_;
  std::size_t cuts_left_;
  std::vector<std::pair<SeenFace, std::size_t>> waiting_;  // to be inserted, the last first
  using Key = std::tuple<double, std::size_t, std::size_t>;
  std::priority_queue<Key, std::vector<Key>, std::greater<>> free_;
};

Painting::Painting(std::vector<SeenFace> faces) : grid_(flat_bounds(faces), faces.size()), cuts_left_(1000 + 4 * faces.size()) {
  for (std::size_t i = faces.size(); i-- > 0;) waiting_.emplace_back(std::move(faces[i]), i);
}

template <class Value>
bool Painting::cut(const SeenFace& face, std::size_t rank, Value&& value) {
  if (cuts_left_ == 0) return false;
  SeenFace first = part(face, value);
  SeenFace second = part(face, [&](const Vector3d& p) { return -value(p); });
  if (first.points.size() < 3 || second.points.size() < 3) return false;
  if (flat_area(first.points) < kLeastOverlap || flat_area(second.points) < kLeastOverlap) return false;
  --cuts_left_;
  waiting_.emplace_back(std::move(second), rank);
  waiting_.emplace_back(std::move(first), rank);
  return true;
}

void Painting::insert(SeenFace face, std::size_t rank) {
  std::vector<std::size_t> nearer, farther;
  const Box2 box = flat_bounds(face.points);
  const double depth = mean(face.points).z();
  for (const std::size_t k : grid_.near(box)) {
    if (nodes_[k].placed) continue;
    const Order order = compare(face.points, nodes_[k].face.points).order;
    if (order == Order::kNone) continue;
    bool behind = order == Order::kSecondNearer;
    if (order == Order::kSame) behind = rank < nodes_[k].rank;
    if (order == Order::kCrossing) {
      const auto plane = depth_plane(nodes_[k].face.points);
      if (cut(face, rank, [&](const Vector3d& p) { return p.z() - (*plane)(p); })) return;
      behind = depth < nodes_[k].depth;
    }
    (behind ? nearer : farther).push_back(k);
  }
  const std::size_t number = nodes_.size();
  grid_.insert(number, box);
  for (const std::size_t k : nearer) {
    nodes_[k].farther.push_back(number);
    ++nodes_[k].waits_for;
  }
  for (const std::size_t k : farther) nodes_[k].nearer.push_back(number);
  const std::size_t waits_for = farther.size();
  nodes_.push_back({std::move(face), rank, depth, std::move(nearer), std::move(farther), waits_for, false});
}

// What waited for this face need not do so any longer.
void Painting::release(std::size_t number) {
  nodes_[number].placed = true;
  for (const std::size_t k : nodes_[number].nearer)
    if (!nodes_[k].placed && --nodes_[k].waits_for == 0) free_.emplace(nodes_[k].depth, nodes_[k].rank, k);
}

// Every face that is left waits for another. Follows what they wait for until a face comes up again: that is a ring. Cuts the face
// of it whose two overlaps with its neighbours are farthest apart, half way between them.
void Painting::open_ring() {
  std::size_t at = 0;
  while (nodes_[at].placed) ++at;
  std::vector<std::size_t> way;
  while (std::find(way.begin(), way.end(), at) == way.end()) {
    way.push_back(at);
    at = *std::find_if(nodes_[at].farther.begin(), nodes_[at].farther.end(), [&](std::size_t k) { return !nodes_[k].placed; });
  }
  way.erase(way.begin(), std::find(way.begin(), way.end(), at));

  std::size_t widest = 0;
  double width = -1.0;
  Vector3d one = Vector3d::Zero(), other = Vector3d::Zero();
  for (std::size_t i = 0; i < way.size(); ++i) {
    const Vector3d a = compare_nodes(way[i], way[(i + 1) % way.size()]).where;
    const Vector3d b = compare_nodes(way[i], way[(i + way.size() - 1) % way.size()]).where;
    if ((a - b).head<2>().norm() <= width) continue;
    width = (a - b).head<2>().norm();
    widest = way[i];
    one = a;
    other = b;
  }
  const Vector2d across = (other - one).head<2>(), half_way = (one + other).head<2>() / 2.0;
  const SeenFace face = nodes_[widest].face;
  if (cut(face, nodes_[widest].rank, [&](const Vector3d& p) { return across.dot(p.head<2>() - half_way); })) {
    release(widest);
    return;
  }
  // No cut helps, or there were too many: the farthest of the ring goes first.
  const std::size_t farthest =
      *std::min_element(way.begin(), way.end(), [&](std::size_t a, std::size_t b) { return nodes_[a].depth < nodes_[b].depth; });
  nodes_[farthest].waits_for = 0;
  free_.emplace(nodes_[farthest].depth, nodes_[farthest].rank, farthest);
}

std::vector<SeenFace> Painting::ordered() {
  std::vector<SeenFace> result;
  std::size_t seen = 0;  // nodes that were looked at for being free
  while (true) {
    while (!waiting_.empty()) {
      auto [face, rank] = std::move(waiting_.back());
      waiting_.pop_back();
      insert(std::move(face), rank);
    }
    for (; seen < nodes_.size(); ++seen)
      if (!nodes_[seen].placed && nodes_[seen].waits_for == 0) free_.emplace(nodes_[seen].depth, nodes_[seen].rank, seen);
    if (free_.empty()) {
      if (std::all_of(nodes_.begin(), nodes_.end(), [](const Node& node) { return node.placed; })) break;
      open_ring();
      continue;
    }
    const std::size_t next = std::get<2>(free_.top());
    free_.pop();
    if (nodes_[next].placed || nodes_[next].waits_for != 0) continue;
    result.push_back(nodes_[next].face);
    release(next);
  }
  return result;
}

}  // namespace

std::vector<SeenFace> painters_order(std::vector<SeenFace> faces) { return Painting(std::move(faces)).ordered(); }

}  // namespace foothold::drawing
