// Lines of the nine free joints, lines over what is in their way, and the two trees that find a way where these do not.
#include "bioloid/gait/swing.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <set>

namespace foothold::bioloid {
namespace {

constexpr std::size_t kSwing[3] = {1, 2, 3};  // of the swing leg's joints, those that are free: roll, pitch, knee

struct Tree {
  std::vector<Free> nodes;
  std::vector<int> parents;

  int nearest(const Free& to) const {
    int best = 0;
    double least = HUGE_VAL;
    for (std::size_t k = 0; k < nodes.size(); ++k)
      if (const double distance = (nodes[k] - to).squaredNorm(); distance < least) least = distance, best = static_cast<int>(k);
    return best;
  }
  int add(const Free& node, int parent) {
    nodes.push_back(node);
    parents.push_back(parent);
    return static_cast<int>(nodes.size()) - 1;
  }
  std::vector<Free> way_to(int node) const {  // from the node back to the root
    std::vector<Free> out;
    for (; node >= 0; node = parents[static_cast<std::size_t>(node)]) out.push_back(nodes[static_cast<std::size_t>(node)]);
    return out;
  }
};

struct Range {
  Free low, high;
};

Range range_of(const Model& model, Side support, const Free& a, const Free& b) {
  Range out;
  const auto put = [&](Eigen::Index row, Side side, std::size_t joint) {
    const auto& limits = model.joints[leg_joint(side, joint)].limits;
    out.low[row] = limits.low;
    out.high[row] = limits.high;
  };
  for (std::size_t k = 0; k < kLegJoints; ++k) put(static_cast<Eigen::Index>(k), support, k);
  for (std::size_t k = 0; k < 3; ++k) put(static_cast<Eigen::Index>(6 + k), other(support), kSwing[k]);
  out.low[9] = std::min(a[9], b[9]);
  out.high[9] = std::max(a[9], b[9]);
  return out;
}

// Shortcuts between nodes drawn at random; none is tried twice, and none where the way is nearly straight already.
void shorten(const Model& model, Judge& judge, const Support& support, std::vector<Free>& way, int tries, std::mt19937_64& random) {
  constexpr double kNearlyStraight = 1.05;
  const auto length = [&](std::size_t i, std::size_t j) {
    double sum = 0.0;
    for (; i < j; ++i) sum += (way[i + 1] - way[i]).norm();
    return sum;
  };
  std::vector<std::size_t> names(way.size());
  std::iota(names.begin(), names.end(), std::size_t{0});
  std::set<std::pair<std::size_t, std::size_t>> tried;
  for (; tries > 0 && way.size() > 2 && length(0, way.size() - 1) > kNearlyStraight * (way.back() - way.front()).norm(); --tries) {
    const std::size_t i = std::uniform_int_distribution<std::size_t>(0, way.size() - 3)(random);
    const std::size_t j = std::uniform_int_distribution<std::size_t>(i + 2, way.size() - 1)(random);
    if (!tried.emplace(names[i], names[j]).second || !free_line(model, judge, support, way[i], way[j], 0)) continue;
    const auto cut = [&](auto& row) {
      row.erase(row.begin() + static_cast<std::ptrdiff_t>(i) + 1, row.begin() + static_cast<std::ptrdiff_t>(j));
    };
    cut(way);
    cut(names);
  }
}

double height_of(const Model& model, Side support, const Free& at) {
  Joints joints;
  if (!from_free(model, support, at, joints)) return HUGE_VAL;
  return (sole_in_torso(model, support, joints).inverse() * sole_in_torso(model, other(support), joints)).translation().z();
}

// With the swing sole at `height`, all else as it is. Empty if the leg does not reach.
std::optional<Free> at_height(const Model& model, Side support, const Free& at, double height) {
  Joints joints;
  if (!from_free(model, support, at, joints)) return std::nullopt;
  const Isometry3d stands = sole_in_torso(model, support, joints);
  Isometry3d sole = stands.inverse() * sole_in_torso(model, other(support), joints);
  sole.translation().z() = height;
  if (!reach(model, other(support), stands * sole, joints)) return std::nullopt;
  return to_free(model, support, joints);
}

// Straight up at both ends and level across, as high as need be: over what stands in the way of the line, which sags in the middle,
// where the leg is straightest. Empty if that is not free.
std::vector<Free> over(const Model& model, Judge& judge, const Support& support, const Free& a, const Free& b) {
  const auto is_free = [&](const Free& p, const Free& q) { return free_line(model, judge, support, p, q, 0); };
  const double from = height_of(model, support.foot, a), to = height_of(model, support.foot, b);
  for (const double rise : {0.0, 0.004, 0.008, 0.012, 0.016, 0.024}) {
    const auto up = at_height(model, support.foot, a, from + rise), down = at_height(model, support.foot, b, to + rise),
               middle = at_height(model, support.foot, 0.5 * (a + b), 0.5 * (from + to) + rise);
    if (!up || !down || !middle) return {};
    if (!is_free(*up, *middle) || !is_free(*middle, *down)) continue;
    if (rise == 0.0) return {a, *middle, b};
    if (is_free(a, *up) && is_free(*down, b)) return {a, *up, *middle, *down, b};
  }
  return {};
}

}  // namespace

Free to_free(const Model& model, Side support, const Joints& joints) {
  Free out;
  out << free_joints(joints, support), heading_of(model, support, joints);
  return out;
}

bool from_free(const Model& model, Side support, const Free& free, Joints& joints) {
  return couple(model, support, free.head<9>(), free[9], joints);
}

JointPath swing_line(const Model& model, Side support, const Free& a, const Free& b) {
  return [&model, support, a, b](double s, Joints& joints) { return from_free(model, support, a + s * (b - a), joints); };
}

bool free_line(const Model& model, Judge& judge, const Support& support, const Free& a, const Free& b, unsigned ground,
               double grain) {
  const int pieces = std::max(1, static_cast<int>(std::ceil((b - a).cwiseAbs().maxCoeff() / grain)));
  const auto posture = [&](int k, Joints& joints) {
    const Free at = k == pieces ? b : Free(a + (b - a) * (static_cast<double>(k) / pieces));
    return from_free(model, support.foot, at, joints);
  };
  const auto is_free = [&](int k, const Joints& from, const Joints& to) {
    const unsigned ends = (k == 0 ? ground & 1U : 0U) | (k + 1 == pieces ? ground & 2U : 0U);
    return judge.motion(from, to, support, ends) == Fault::kNone;
  };
  // The piece in the middle first: what is in the way stands there as a rule.
  const int first = pieces / 2;
  Joints last, next;
  if (!posture(first, last) || !posture(first + 1, next) || !is_free(first, last, next)) return false;
  if (!posture(0, last)) return false;
  for (int k = 0; k < pieces; ++k) {
    if (!posture(k + 1, next)) return false;
    if (k != first && !is_free(k, last, next)) return false;
    last = next;
  }
  return true;
}

std::vector<Free> connect(const Model& model, Judge& judge, const Support& support, const Free& a, const Free& b,
                          const SearchOptions& options, std::mt19937_64& random, std::stop_token stop) {
  if (free_line(model, judge, support, a, b, 0)) return {a, b};
  if (std::vector<Free> way = over(model, judge, support, a, b); !way.empty()) return way;
  const Range range = range_of(model, support.foot, a, b);
  Tree trees[2];
  trees[0].add(a, -1);
  trees[1].add(b, -1);
  const auto extend = [&](Tree& tree, const Free& to) -> int {
    const int near = tree.nearest(to);
    const Free from = tree.nodes[static_cast<std::size_t>(near)];
    const double distance = (to - from).norm();
    if (distance < 1e-12) return near;
    const Free next = distance <= options.reach ? to : Free(from + (to - from) * (options.reach / distance));
    return free_line(model, judge, support, from, next, 0) ? tree.add(next, near) : -1;
  };
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const auto may_grow = [&](int tries) {
    return tries < options.most_tries && static_cast<int>(trees[0].nodes.size() + trees[1].nodes.size()) < options.most_nodes;
  };
  for (int tries = 0, side = 0; may_grow(tries); ++tries, side ^= 1) {
    if (stop.stop_requested()) return {};
    Free sample;
    // Near the straight line first: a single support is a short way through a narrow set.
    const double share = unit(random), spread = unit(random);
    for (Eigen::Index k = 0; k < 10; ++k) {
      const double wide = range.low[k] + unit(random) * (range.high[k] - range.low[k]);
      sample[k] = a[k] + share * (b[k] - a[k]) + spread * (wide - a[k] - share * (b[k] - a[k]));
    }
    const int grown = extend(trees[side], sample);
    if (grown < 0) continue;
    const Free target = trees[side].nodes[static_cast<std::size_t>(grown)];
    int reached = extend(trees[side ^ 1], target);
    while (reached >= 0 && trees[side ^ 1].nodes[static_cast<std::size_t>(reached)] != target)
      reached = extend(trees[side ^ 1], target);
    if (reached < 0) continue;
    std::vector<Free> way = trees[0].way_to(side == 0 ? grown : reached);
    std::reverse(way.begin(), way.end());
    const std::vector<Free> rest = trees[1].way_to(side == 0 ? reached : grown);
    way.insert(way.end(), rest.begin() + 1, rest.end());
    shorten(model, judge, support, way, options.shortening, random);
    return way;
  }
  return {};
}

double travel(std::span<const Joints> points) {
  double sum = 0.0;
  for (std::size_t k = 1; k < points.size(); ++k) sum += (points[k] - points[k - 1]).cwiseAbs().sum();
  return sum;
}

}  // namespace foothold::bioloid
