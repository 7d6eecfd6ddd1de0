// Legs and bodies on the way from posture to posture, kept off each other: as they are kept off the ground.
#include <algorithm>

#include "octopod/transition/passage.hpp"

namespace foothold::octopod {
namespace {

constexpr int kDeepest = 7;  // halvings of a phase or of a part of a swing

}  // namespace

double Passage::keep_apart() const { return setting_->options.clearance + kApart / 2; }

LegPoints Passage::points(const Pair& pair, int leg, const FromShoulder& at, const Vector3d& foot) const {
  return {shoulder(setting_->model, pair, leg), to_world(pair, leg, knee(setting_->model, at)), foot};
}

Passage::Moving Passage::moving(int leg, bool moved, double begin, double end) const {
  const Model& model = setting_->model;
  const Vector3d& foot = footing(leg, moved).point;
  const FromShoulder a = from_shoulder(path_.at(begin), leg, foot), b = from_shoulder(path_.at(end), leg, foot);
  const Pair pair = path_.at((begin + end) / 2);
  const double part = end - begin, turn = part * path_.turn(module_of(leg)), shifted = part * shoulder_way(leg);
  const double rate = knee_rate(model, a, b), of_foot = shifted + model.reach() * turn;
  return {points(pair, leg, from_shoulder(pair, leg, foot), foot), (shifted + model.femur * turn + rate * of_foot) / 2,
          std::max(1.0, rate) * of_foot / 2};
}

const Passage::Moving& Passage::moving(int leg, bool moved, int phase) {
  std::optional<Moving>& known = moving_[index(leg, moved, phase)];
  if (!known) known = moving(leg, moved, part(phase), part(phase + 1));
  return *known;
}

bool Passage::apart_on(int leg, bool moved, int other, bool other_moved, int phase) {
  Known& known = apart_[pair_index(leg, moved, other, other_moved, phase)];
  if (known == Known::kNot) {
    const Moving &a = moving(leg, moved, phase), &b = moving(other, other_moved, phase);
    const bool apart = !legs_nearer(setting_->model, a.at, b.at, keep_apart() + a.way + b.way) ||
                       apart_on(leg, moved, other, other_moved, part(phase), part(phase + 1), 0);
    known = apart ? Known::kYes : Known::kNo;
  }
  return known == Known::kYes;
}

bool Passage::apart_on(int leg, bool moved, int other, bool other_moved, double begin, double end, int depth) {
  const Moving a = moving(leg, moved, begin, end), b = moving(other, other_moved, begin, end);
  if (!legs_nearer(setting_->model, a.at, b.at, keep_apart() + a.way + b.way)) return true;
  if (depth == kDeepest || legs_nearer(setting_->model, a.at, b.at, keep_apart())) return false;
  const double middle = (begin + end) / 2;
  return apart_on(leg, moved, other, other_moved, begin, middle, depth + 1) &&
         apart_on(leg, moved, other, other_moved, middle, end, depth + 1);
}

bool Passage::off_modules(int leg, bool moved, double begin, double end, int depth) {
  const Model& model = setting_->model;
  const Moving at = moving(leg, moved, begin, end);
  const Pair pair = path_.at((begin + end) / 2);
  bool all = true;
  for (int m = 0; m < 2; ++m) {
    const bool own = module_of(leg) == m;
    const Isometry3d pose = module_pose(model, pair, m);
    const double of_module = (end - begin) * (path_.way() + (model.arm() + model.body.norm() / 2) * path_.turn(m)) / 2;
    const double way = own ? at.from_module : at.way + of_module;
    if (!leg_nearer(model, at.at, m, pose, own, keep_apart() + way)) continue;
    if (depth == kDeepest || leg_nearer(model, at.at, m, pose, own, keep_apart())) return false;
    all = false;
  }
  const double middle = (begin + end) / 2;
  return all || (off_modules(leg, moved, begin, middle, depth + 1) && off_modules(leg, moved, middle, end, depth + 1));
}

template <class Nearer>
bool Passage::swing_keeps_off(const Pair& pair, int leg, const Vector3d& from, const Vector3d& to, int depth,
                              const Nearer& nearer) const {
  const FromShoulder a = from_shoulder(pair, leg, from), b = from_shoulder(pair, leg, to);
  const Vector3d foot = (from + to) / 2;
  const LegPoints at = points(pair, leg, between(a, b, 0.5), foot);
  const double way = (to - from).norm() / 2 * std::max(1.0, knee_rate(setting_->model, a, b));
  if (!nearer(at, keep_apart() + way)) return true;
  if (depth == kDeepest || nearer(at, keep_apart())) return false;
  return swing_keeps_off(pair, leg, from, foot, depth + 1, nearer) && swing_keeps_off(pair, leg, foot, to, depth + 1, nearer);
}

bool Passage::swing_off_modules(const Swing& swing, int leg, int phase) const {
  const Model& model = setting_->model;
  const std::array<Isometry3d, 2> poses{module_pose(model, pair(phase), 0), module_pose(model, pair(phase), 1)};
  const auto nearer = [&](const LegPoints& at, double clearance) {
    return leg_nearer(model, at, 0, poses[0], module_of(leg) == 0, clearance) ||
           leg_nearer(model, at, 1, poses[1], module_of(leg) == 1, clearance);
  };
  for (std::size_t k = 0; k < 3; ++k)
    if (!swing_keeps_off(pair(phase), leg, swing.points[k], swing.points[k + 1], 0, nearer)) return false;
  return true;
}

bool Passage::swing_apart(int leg, int phase, int other, bool other_moved) {
  Known& known = swing_apart_[pair_index(leg, false, other, other_moved, phase)];
  if (known == Known::kNot) {
    const Model& model = setting_->model;
    const FromShoulder& seen = held_[index(other, other_moved, phase)].foot;
    const LegPoints standing = points(pair(phase), other, seen, footing(other, other_moved).point);
    const auto nearer = [&](const LegPoints& at, double clearance) { return legs_nearer(model, at, standing, clearance); };
    const Swing& over = *swing(leg, phase);
    bool apart = true;
    for (std::size_t k = 0; apart && k < 3; ++k)
      apart = swing_keeps_off(pair(phase), leg, over.points[k], over.points[k + 1], 0, nearer);
    known = apart ? Known::kYes : Known::kNo;
  }
  return known == Known::kYes;
}

}  // namespace foothold::octopod
