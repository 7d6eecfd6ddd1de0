// Where legs can stand, and the centre of mass.
#include "octopod/transition/passage.hpp"

#include <algorithm>

namespace foothold::octopod {
namespace {

constexpr double kPhase = 0.025;  // m, of the shoulder that moves farthest, in one phase
constexpr int kSwaySamples = 4;   // of a phase

// All that the robot can touch on its way.
collision::Bounds around(const Setting& setting, const BodyPath& path, const Standing& from, const Standing& to) {
  const Model& model = setting.model;
  collision::Bounds out;
  for (int k = 0; k <= 4; ++k) {
    const Pair pair = path.at(k / 4.0);
    for (int leg = 0; leg < kLegs; ++leg) out.extend(shoulder(model, pair, leg));
  }
  const double turns = std::max(path.turn(0), path.turn(1)) / 4;
  const double bulge = turns * turns * (model.arm() + model.body.norm()) / 8;
  out = collision::grown(out, model.coxa + model.femur + bulge);
  for (const Standing* at : {&from, &to})
    for (const Footing& foot : at->feet)
      out.extend(foot.point).extend(Vector3d(foot.point + 3 * setting.options.swing_height * foot.normal));
  return collision::grown(out, model.leg_radius + setting.options.clearance + 0.03);
}

}  // namespace

double Passage::shoulder_way(int leg) const {
  return path_.way() + lever(setting_->model, leg).norm() * path_.turn(module_of(leg));
}

FromShoulder Passage::from_shoulder(const Pair& pair, int leg, const Vector3d& foot) const {
  const Vector3d v =
      pair.turn[static_cast<std::size_t>(module_of(leg))].transpose() * (foot - pair.joint) - lever(setting_->model, leg);
  return {side(leg) * v.y(), v.x(), v.z()};
}

Vector3d Passage::to_world(const Pair& pair, int leg, const FromShoulder& at) const {
  return shoulder(setting_->model, pair, leg) +
         pair.turn[static_cast<std::size_t>(module_of(leg))] * Vector3d(at.forth, side(leg) * at.out, at.up);
}

double Passage::sign(int leg, bool moved) const {
  const double out = held_[index(leg, moved, moved ? phases_ : 0)].foot.out;
  return out < 0 ? -1.0 : 1.0;
}

Vector3d Passage::share(const Pair& pair, int leg, const FromShoulder& at, const Vector3d& foot) const {
  const Model& model = setting_->model;
  const Vector3d knee_at = to_world(pair, leg, knee(model, at));
  return (model.femur_mass / 2 * (shoulder(model, pair, leg) + knee_at) + model.tibia_mass / 2 * (knee_at + foot)) / model.mass();
}

Passage::Passage(const Setting& setting, const Standing& from, const Standing& to)
    : setting_(&setting),
      from_(&from),
      to_(&to),
      path_(pair_of(setting.model, from.at), pair_of(setting.model, to.at)),
      ground_(setting.surface, around(setting, path_, from, to)) {
  const Model& model = setting.model;
  double farthest = 0.0;
  for (int leg = 0; leg < kLegs; ++leg)
    farthest = std::max(farthest, (shoulder(model, path_.at(1), leg) - shoulder(model, path_.at(0), leg)).norm());
  phases_ = std::clamp(static_cast<int>(std::ceil(farthest / kPhase)), 1, kMostPhases);
  for (int k = 0; k <= phases_; ++k) {
    const auto at = static_cast<std::size_t>(k);
    pairs_[at] = path_.at(part(k));
    bodies_share_[at] = model.body_mass / model.mass() *
                        (module_pose(model, pairs_[at], 0).translation() + module_pose(model, pairs_[at], 1).translation());
  }
  for (int leg = 0; leg < kLegs; ++leg)
    for (const bool moved : {false, true}) {
      const Vector3d& foot = footing(leg, moved).point;
      for (int k = 0; k <= phases_; ++k) held_[index(leg, moved, k)].foot = from_shoulder(pair(k), leg, foot);
      for (int k = 0; k <= phases_; ++k) {
        Held& held = held_[index(leg, moved, k)];
        held.holds = may_be(model, held.foot, sign(leg, moved));
        if (held.holds) held.share = share(pair(k), leg, held.foot, foot);
      }
    }
}

bool Passage::holds_on(int leg, bool moved, int phase) {
  Known& known = on_[index(leg, moved, phase)];
  if (known == Known::kNot) {
    const FromShoulder &a = held_[index(leg, moved, phase)].foot, &b = held_[index(leg, moved, phase + 1)].foot;
    // The foot as seen from the shoulder is a turned vector that grows evenly: it is off its chord by its second derivative / 8.
    const double turn = path_.turn(module_of(leg)) / phases_, way = path_.way() / phases_;
    const double far = (footing(leg, moved).point - pair(phase).joint).norm() + way;
    const double bulge = turn * (far * turn + 2 * way) / 8;
    known = may_be_between(setting_->model, a, b, sign(leg, moved), bulge) &&
                    leg_clear(leg, moved, part(phase), part(phase + 1), 0) &&
                    off_modules(leg, moved, part(phase), part(phase + 1), 0)
                ? Known::kYes
                : Known::kNo;
  }
  return known == Known::kYes;
}

Vector3d Passage::centre_of_mass(unsigned moved, int phase) const {
  Vector3d out = bodies_share_[static_cast<std::size_t>(phase)];
  for (int leg = 0; leg < kLegs; ++leg) out += held_[index(leg, (moved >> leg & 1U) != 0, phase)].share;
  return out;
}

double Passage::sway(unsigned moved, int phase) const {
  const Model& model = setting_->model;
  const Vector3d begin = centre_of_mass(moved, phase), end = centre_of_mass(moved, phase + 1);
  double off = 0.0, between_samples = 0.0;
  for (int leg = 0; leg < kLegs; ++leg) {
    const bool is_moved = (moved >> leg & 1U) != 0;
    const FromShoulder &a = held_[index(leg, is_moved, phase)].foot, &b = held_[index(leg, is_moved, phase + 1)].foot;
    const double turn = path_.turn(module_of(leg)) / phases_;
    const double knee_way = knee_rate(model, a, b) * (shoulder_way(leg) / phases_ + model.reach() * turn) + model.femur * turn;
    between_samples += knee_weight() * knee_way / 2;
  }
  for (int k = 1; k < kSwaySamples; ++k) {
    const double within = static_cast<double>(k) / kSwaySamples;
    const Pair pair = path_.at((phase + within) / phases_);
    Vector3d at =
        model.body_mass / model.mass() * (module_pose(model, pair, 0).translation() + module_pose(model, pair, 1).translation());
    for (int leg = 0; leg < kLegs; ++leg) {
      const Vector3d& foot = footing(leg, (moved >> leg & 1U) != 0).point;
      at += share(pair, leg, from_shoulder(pair, leg, foot), foot);
    }
    off = std::max(off, (at - begin - within * (end - begin)).head<2>().norm());
  }
  const double turn = std::max(path_.turn(0), path_.turn(1)) / (phases_ * kSwaySamples);
  return off + between_samples / kSwaySamples + turn * turn * (model.arm() + model.body.norm()) / 8;
}

}  // namespace foothold::octopod
