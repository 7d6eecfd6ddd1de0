// Bodies and legs on the way from posture to posture, kept off the ground: a piece of the way is clear if its middle is by more
// than anything moves within half of it; else it is halved.
#include <algorithm>

#include "octopod/transition/passage.hpp"

namespace foothold::octopod {
namespace {

constexpr int kDeepest = 6;         // halvings of a phase or of a part of a swing
constexpr double kKeep = 1e-6;      // m, kept besides the clearance
constexpr double kOn = 1e-9;        // m: soles this deep are on the ground
constexpr double kTouch = 1e-6;     // m
constexpr double kLeastRise = 0.2;  // cosine between a foot's way up and every normal of what it stands on

Vector3d ankle_of(const Model& model, const Vector3d& foot, const Vector3d& knee_at) {
  return foot + (knee_at - foot) * (model.foot / model.tibia);
}

}  // namespace

bool Passage::leg_clear(int leg, bool moved, double begin, double end, int depth) {
  const Model& model = setting_->model;
  const Vector3d& foot = footing(leg, moved).point;
  const Pair pair = path_.at((begin + end) / 2);
  const FromShoulder a = from_shoulder(path_.at(begin), leg, foot), b = from_shoulder(path_.at(end), leg, foot);
  const Vector3d shoulder_at = shoulder(model, pair, leg);
  const Vector3d knee_at = to_world(pair, leg, knee(model, from_shoulder(pair, leg, foot)));
  const Vector3d ankle = ankle_of(model, foot, knee_at);
  const double part = end - begin, turn = part * path_.turn(module_of(leg)), shifted = part * shoulder_way(leg);
  const double way = (shifted + model.femur * turn + knee_rate(model, a, b) * (shifted + model.reach() * turn)) / 2;
  const double keep = setting_->options.clearance + kKeep, thick = model.leg_radius + keep;
  const std::array<NearGround::Kept, 4> points{
      {{shoulder_at, thick + shifted / 2}, {knee_at, thick + way}, {ankle, thick + way * model.foot / model.tibia}, {foot, -kOn}}};
  if (ground_.above(points)) return true;
  if (!ground_.foot_free(foot, ankle)) return false;
  const collision::Capsule femur{shoulder_at, knee_at, model.leg_radius}, tibia{knee_at, ankle, model.leg_radius};
  if (!ground_.nearer(femur, keep + way) && !ground_.nearer(tibia, keep + way)) return true;
  if (depth == kDeepest || ground_.nearer(femur, keep) || ground_.nearer(tibia, keep)) return false;
  return leg_clear(leg, moved, begin, (begin + end) / 2, depth + 1) && leg_clear(leg, moved, (begin + end) / 2, end, depth + 1);
}

bool Passage::bodies_clear(int phase) {
  Known& known = bodies_on_[static_cast<std::size_t>(phase)];
  if (known == Known::kNot) known = bodies_clear(part(phase), part(phase + 1), 0) ? Known::kYes : Known::kNo;
  return known == Known::kYes;
}

bool Passage::bodies_clear(double begin, double end, int depth) {
  const Model& model = setting_->model;
  const Pair pair = path_.at((begin + end) / 2);
  const double keep = setting_->options.clearance + kKeep;
  // They share C, so only their turns bring them nearer to each other.
  const std::array<Isometry3d, 2> poses{module_pose(model, pair, 0), module_pose(model, pair, 1)};
  const double turning = (end - begin) * (model.arm() + model.body.norm() / 2) * (path_.turn(0) + path_.turn(1)) / 2;
  bool all = !modules_nearer(model, poses, keep_apart() + turning);
  if (!all && (depth == kDeepest || modules_nearer(model, poses, keep_apart()))) return false;
  for (int m = 0; m < 2; ++m) {
    const Isometry3d& pose = poses[static_cast<std::size_t>(m)];
    const Vector3d forth = (m == 0 ? -model.body.x() : model.body.x()) / 2 * pose.linear().col(0);
    const collision::Box body{pose, model.body / 2};
    const collision::Capsule neck{pose.translation() + forth, pair.joint, model.neck_radius};
    const double way = (end - begin) * (path_.way() + (model.arm() + model.body.norm() / 2) * path_.turn(m)) / 2;
    if (!ground_.nearer(body, keep + way) && !ground_.nearer(neck, keep + way)) continue;
    if (depth == kDeepest || ground_.nearer(body, keep) || ground_.nearer(neck, keep)) return false;
    all = false;
  }
  return all || (bodies_clear(begin, (begin + end) / 2, depth + 1) && bodies_clear((begin + end) / 2, end, depth + 1));
}

bool Passage::swing_clear(const Pair& pair, int leg, const Vector3d& from, const Vector3d& to, bool in_the_air, int depth,
                          const Vector3d& knee_middle, double& spread) {
  const Model& model = setting_->model;
  const Vector3d foot = (from + to) / 2;
  const FromShoulder a = from_shoulder(pair, leg, from), b = from_shoulder(pair, leg, to);
  const Vector3d shoulder_at = shoulder(model, pair, leg), knee_at = to_world(pair, leg, knee(model, between(a, b, 0.5)));
  const Vector3d ankle = ankle_of(model, foot, knee_at);
  const double half = (to - from).norm() / 2, way = half * knee_rate(model, a, b);
  const double keep = setting_->options.clearance + kKeep, thick = model.leg_radius + keep, larger = std::max(way, half);
  const double of_foot = model.foot / model.tibia;
  const std::array<NearGround::Kept, 5> points{{{shoulder_at, thick},
                                                {knee_at, thick + way},
                                                {ankle, thick + of_foot * way + (1 - of_foot) * half},
                                                {from, in_the_air ? kKeep : -kOn},
                                                {to, in_the_air ? kKeep : -kOn}}};
  if (ground_.above(points)) {
    spread = std::max(spread, (knee_at - knee_middle).norm() + way);
    return true;
  }
  const collision::Capsule femur{shoulder_at, knee_at, model.leg_radius}, tibia{knee_at, ankle, model.leg_radius};
  const collision::Capsule sole{foot, ankle, 0.0};
  if (!ground_.foot_free(foot, ankle)) return false;
  if (!ground_.nearer(femur, keep + way) && !ground_.nearer(tibia, keep + larger) &&
      (!in_the_air || !ground_.nearer(sole, kKeep + larger))) {
    spread = std::max(spread, (knee_at - knee_middle).norm() + way);
    return true;
  }
  if (depth == kDeepest || ground_.nearer(femur, keep) || ground_.nearer(tibia, keep)) return false;
  return swing_clear(pair, leg, from, foot, in_the_air, depth + 1, knee_middle, spread) &&
         swing_clear(pair, leg, foot, to, in_the_air, depth + 1, knee_middle, spread);
}

const std::optional<Swing>& Passage::swing(int leg, int phase) {
  const std::size_t at = static_cast<std::size_t>(leg) * (kMostPhases + 1) + static_cast<std::size_t>(phase);
  if (swung_[at] == Known::kNot) {
    swings_[at] = find_swing(leg, phase);
    swung_[at] = Known::kYes;
  }
  return swings_[at];
}

std::optional<Swing> Passage::find_swing(int leg, int phase) {
  if (!holds(leg, false, phase) || !holds(leg, true, phase) || sign(leg, false) != sign(leg, true)) return std::nullopt;
  const Model& model = setting_->model;
  const Pair& at = pair(phase);
  const Vector3d &begin = footing(leg, false).point, &end = footing(leg, true).point;
  const auto up = away_from(setting_->surface, begin), down = away_from(setting_->surface, end);
  if (!up || !down) return std::nullopt;
  const auto knee_of = [&](const Vector3d& foot) { return to_world(at, leg, knee(model, from_shoulder(at, leg, foot))); };
  const Vector3d knee_middle = (knee_of(begin) + knee_of(end)) / 2;
  for (const double times : {1.0, 2.0, 3.0}) {
    const double height = times * setting_->options.swing_height;
    Swing out{{begin, begin + height * *up, end + height * *down, end}, 0.0};
    bool free = true;
    for (std::size_t k = 0; free && k < 3; ++k)
      free = may_be_between(model, from_shoulder(at, leg, out.points[k]), from_shoulder(at, leg, out.points[k + 1]),
                            sign(leg, true), 0.0) &&
             swing_clear(at, leg, out.points[k], out.points[k + 1], k == 1, 0, knee_middle, out.knee_spread);
    if (free && swing_off_modules(out, leg, phase)) return out;
  }
  return std::nullopt;
}

std::optional<Vector3d> away_from(const terrain::Surface& surface, const Vector3d& foot) {
  const terrain::Terrain& terrain = surface.terrain();
  std::array<Vector3d, 16> normals;
  std::size_t count = 0;
  Vector3d sum = Vector3d::Zero();
  const collision::Bounds here = collision::grown(collision::Bounds(foot, foot), kTouch);
  surface.visit(here, [&](std::uint32_t found) {
    const int t = static_cast<int>(found);
    const Vector3d nearest = terrain::nearest_on_triangle(foot, terrain.corner(t, 0), terrain.corner(t, 1), terrain.corner(t, 2));
    if ((nearest - foot).norm() > kTouch) return true;
    normals[count++] = terrain.normals[found];
    sum += terrain.normals[found];
    return count < normals.size();
  });
  if (count == 0 || sum.norm() < 1e-9) return std::nullopt;
  const Vector3d out = sum.normalized();
  for (std::size_t k = 0; k < count; ++k)
    if (normals[k].dot(out) < kLeastRise) return std::nullopt;
  return out;
}

}  // namespace foothold::octopod
