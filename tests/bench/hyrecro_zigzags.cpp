// See hyrecro_zigzags.hpp.
#include "hyrecro_zigzags.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "hyrecro/paper/way.hpp"

namespace foothold::bench {
namespace {

using namespace foothold::hyrecro;

constexpr double kWay = 2.631;  // m

struct Zigzag {
  truss::Face face;
  Foothold from, to;
};

// The outline of strips round a line of right angles: its corners moved to both sides, its ends lengthened by half the width.
Polygon widened(const std::vector<Vector2d>& line, double width) {
  Polygon right, left;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const Vector2d before = k > 0 ? (line[k] - line[k - 1]).normalized() : (line[1] - line[0]).normalized();
    const Vector2d after = k + 1 < line.size() ? (line[k + 1] - line[k]).normalized() : before;
    const auto across = [](const Vector2d& d) { return Vector2d(-d.y(), d.x()); };
    const bool begin = k == 0, end = k + 1 == line.size();
    const Vector2d side = begin || end ? across(after) : Vector2d(across(before) + across(after));
    const Vector2d beyond = begin ? Vector2d(-after) : end ? before : Vector2d::Zero();
    right.push_back(line[k] + 0.5 * width * (beyond - side));
    left.push_back(line[k] + 0.5 * width * (beyond + side));
  }
  right.insert(right.end(), left.rbegin(), left.rend());
  if (geometry::signed_area(right) < 0.0) std::reverse(right.begin(), right.end());
  return right;
}

// Lengths in whole centimetres; the goal stands on the last strip where the way has its length. Empty if there is no such place.
std::optional<Zigzag> make_zigzag(std::mt19937& random) {
  const auto between = [&](int low, int high) {
    return 0.01 * static_cast<double>(low + static_cast<int>(random() % static_cast<unsigned>(high - low + 1)));
  };
  const double width = between(16, 40);
  const int strips = 3 + static_cast<int>(random() % 3);
  std::vector<Vector2d> line{{0.5 * width, 0.5 * width}};
  double up = 1.0;
  for (int k = 0; k < strips; ++k) {
    const double length = between(35, 110);
    line.push_back(line.back() + (k % 2 == 0 ? Vector2d(length, 0.0) : Vector2d(0.0, up * length)));
    if (k % 2 == 1 && strips > 3) up = -up;
  }
  Zigzag out;
  out.face.name = "zigzag";
  out.face.frame = Isometry3d::Identity();
  out.face.outline = widened(line, width);
  if (geometry::first_crossing(out.face.outline)) return std::nullopt;
  const SafeGround ground(out.face, PaperOptions{}.safe_inset);
  const Vector2d back = line[line.size() - 2] - line.back();
  const auto way_less = [&](double part) {
    const std::vector<Vector2d> way = ground.way(line.front(), line.back() + part * back, FaceWay::kVisibility);
    return way.empty() || geometry::length_of(way) <= kWay;
  };
  if (way_less(0.0) || !way_less(1.0)) return std::nullopt;
  double longer = 0.0, less = 1.0;
  for (int k = 0; k < 40; ++k) (way_less(0.5 * (longer + less)) ? less : longer) = 0.5 * (longer + less);
  out.from = {0, line.front(), 0.0};
  out.to = {0, line.back() + less * back, std::atan2(-back.y(), -back.x())};
  return out;
}

}  // namespace

RuleTally compare_rules(const Model& model, std::shared_ptr<const PlanarWorkspace> workspace, PaperOptions options, int faces) {
  RuleTally tally;
  std::mt19937 random(2024);
  while (tally.faces < faces) {
    const std::optional<Zigzag> zigzag = make_zigzag(random);
    if (!zigzag) continue;
    ++tally.faces;
    truss::Truss truss;
    truss.faces.push_back(zigzag->face);
    PreparedTruss scene(model, std::move(truss), {}, 0.005);
    scene.workspace = workspace;
    const auto steps = [&](FaceRule rule) {
      options.rule = rule;
      const auto strides = plan_face(model, scene, zigzag->from, zigzag->to, options, {});
      return strides ? static_cast<int>(strides->size()) : 0;
    };
    const int paper = steps(FaceRule::kPaper), zhu = steps(FaceRule::kZhu);
    tally.paper_stuck += paper == 0;
    tally.zhu_stuck += zhu == 0;
    if (paper == 0 || zhu == 0) continue;
    tally.fewer += paper < zhu;
    tally.same += paper == zhu;
    tally.more += paper > zhu;
    tally.paper_steps += paper;
    tally.zhu_steps += zhu;
  }
  return tally;
}

}  // namespace foothold::bench
