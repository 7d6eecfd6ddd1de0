// Lines of the nine free joints, and the two trees that find a way where a line does not.
#include "bioloid/gait/swing.hpp"

#include <algorithm>

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

void shorten(const Model& model, Judge& judge, const Support& support, std::vector<Free>& way, int tries, std::mt19937_64& random) {
  for (; tries > 0 && way.size() > 2; --tries) {
    const std::size_t i = std::uniform_int_distribution<std::size_t>(0, way.size() - 3)(random);
    const std::size_t j = std::uniform_int_distribution<std::size_t>(i + 2, way.size() - 1)(random);
    if (free_line(model, judge, support, way[i], way[j], 0))
      way.erase(way.begin() + static_cast<std::ptrdiff_t>(i) + 1, way.begin() + static_cast<std::ptrdiff_t>(j));
  }
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
  Joints last, next;
  if (!from_free(model, support.foot, a, last)) return false;
  for (int k = 1; k <= pieces; ++k) {
    const Free at = k == pieces ? b : Free(a + (b - a) * (static_cast<double>(k) / pieces));
    if (!from_free(model, support.foot, at, next)) return false;
    const unsigned ends = (k == 1 ? ground & 1U : 0U) | (k == pieces ? ground & 2U : 0U);
    if (judge.motion(last, next, support, ends) != Fault::kNone) return false;
    last = next;
  }
  return true;
}

std::vector<Free> connect(const Model& model, Judge& judge, const Support& support, const Free& a, const Free& b,
                          const SearchOptions& options, std::mt19937_64& random, std::stop_token stop) {
  if (free_line(model, judge, support, a, b, 0)) return {a, b};
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
  for (int side = 0; static_cast<int>(trees[0].nodes.size() + trees[1].nodes.size()) < options.most_nodes; side ^= 1) {
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
