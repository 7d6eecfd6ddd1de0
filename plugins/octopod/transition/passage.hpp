// Two postures and the bodies' way between them, cut into phases: where a leg can stand, where it is clear of the ground, of bodies
// and of other legs, where it can swing, and where the centre of mass is. Answers are kept; used by one thread.
#pragma once

#include <cstdint>

#include "octopod/posture/apart.hpp"
#include "octopod/posture/near_ground.hpp"
#include "octopod/transition/body_path.hpp"
#include "octopod/transition/leg_shape.hpp"
#include "octopod/transition/transition.hpp"

namespace foothold::octopod {

struct Setting {
  const Model& model;
  const terrain::Surface& surface;
  TransitionOptions options;
};

// A foot's way through the air: up, across, down.
struct Swing {
  std::array<Vector3d, 4> points;  // m, world
  double knee_spread = 0.0;        // m, how far the knee comes from the middle of where it begins and ends
};

class Passage {
 public:
  static constexpr int kMostPhases = 16;

  // Borrows all.
  Passage(const Setting& setting, const Standing& from, const Standing& to);

  const Setting& setting() const { return *setting_; }
  int phases() const { return phases_; }
  double part(int phase) const { return static_cast<double>(phase) / phases_; }
  const BodyPath& bodies() const { return path_; }
  const Pair& pair(int phase) const { return pairs_[static_cast<std::size_t>(phase)]; }
  const Footing& footing(int leg, bool moved) const { return (moved ? *to_ : *from_).feet[static_cast<std::size_t>(leg)]; }

  // Whether the leg can stand on its old or new foothold while the bodies are there; and while they go on to the next phase.
  bool holds(int leg, bool moved, int phase) const { return held_[index(leg, moved, phase)].holds; }
  bool holds_on(int leg, bool moved, int phase);
  bool bodies_clear(int phase);  // on the way to the next phase
  // Empty if the leg cannot swing over from its old to its new foothold there.
  const std::optional<Swing>& swing(int leg, int phase);
  // Whether two legs keep apart while both stand and the bodies go on to the next phase. Precondition: both hold there and then.
  bool apart_on(int leg, bool moved, int other, bool other_moved, int phase);
  // Whether a leg that swings over keeps apart from one that stands. Precondition: it can swing, the other one holds.
  bool swing_apart(int leg, int phase, int other, bool other_moved);

  // m, world; `moved`: bit i is leg i. Precondition: all legs hold there.
  Vector3d centre_of_mass(unsigned moved, int phase) const;
  // How far the centre of mass may be off the straight line between two phases, m.
  double sway(unsigned moved, int phase) const;
  // Parts of the robot's weight that hang on a knee and on a foot.
  double knee_weight() const { return (setting_->model.femur_mass + setting_->model.tibia_mass) / 2 / setting_->model.mass(); }
  double foot_weight() const { return setting_->model.tibia_mass / 2 / setting_->model.mass(); }

 private:
  struct Held {
    FromShoulder foot;
    Vector3d share;  // of the leg in the centre of mass
    bool holds = false;
  };
  enum class Known : std::uint8_t { kNot, kNo, kYes };
  // A standing leg in the middle of a piece of the way, and how far any of its points can be from there within the piece, m: in the
  // world, and as seen from its module.
  struct Moving {
    LegPoints at;
    double way = 0.0, from_module = 0.0;
  };

  static std::size_t index(int leg, bool moved, int phase) {
    return (static_cast<std::size_t>(leg) * 2 + (moved ? 1 : 0)) * (kMostPhases + 1) + static_cast<std::size_t>(phase);
  }
  static std::size_t pair_index(int leg, bool moved, int other, bool other_moved, int phase) {
    return (static_cast<std::size_t>(leg) * 2 + (moved ? 1 : 0)) * kLegs * 2 * (kMostPhases + 1) + index(other, other_moved, phase);
  }
  FromShoulder from_shoulder(const Pair& pair, int leg, const Vector3d& foot) const;
  Vector3d to_world(const Pair& pair, int leg, const FromShoulder& at) const;
  double sign(int leg, bool moved) const;
  double shoulder_way(int leg) const;  // m, of the shoulder in all, at most
  bool leg_clear(int leg, bool moved, double begin, double end, int depth);
  bool bodies_clear(double begin, double end, int depth);
  bool swing_clear(const Pair& pair, int leg, const Vector3d& from, const Vector3d& to, bool in_the_air, int depth,
                   const Vector3d& knee_middle, double& spread);
  std::optional<Swing> find_swing(int leg, int phase);
  double keep_apart() const;  // m, between legs, and between legs and bodies
  LegPoints points(const Pair& pair, int leg, const FromShoulder& at, const Vector3d& foot) const;
  Moving moving(int leg, bool moved, double begin, double end) const;
  const Moving& moving(int leg, bool moved, int phase);
  bool apart_on(int leg, bool moved, int other, bool other_moved, double begin, double end, int depth);
  bool off_modules(int leg, bool moved, double begin, double end, int depth);
  bool swing_off_modules(const Swing& swing, int leg, int phase) const;
  template <class Nearer>
  bool swing_keeps_off(const Pair& pair, int leg, const Vector3d& from, const Vector3d& to, int depth, const Nearer& nearer) const;
  Vector3d share(const Pair& pair, int leg, const FromShoulder& at, const Vector3d& foot) const;

  const Setting* setting_;
  const Standing *from_, *to_;
  BodyPath path_;
  int phases_ = 1;
  std::array<Pair, kMostPhases + 1> pairs_;
  std::array<Vector3d, kMostPhases + 1> bodies_share_;
  std::array<Held, 2 * kLegs*(kMostPhases + 1)> held_;
  std::array<Known, 2 * kLegs*(kMostPhases + 1)> on_{};
  std::array<Known, kMostPhases + 1> bodies_on_{};
  std::array<Known, kLegs*(kMostPhases + 1)> swung_{};
  std::array<std::optional<Swing>, kLegs*(kMostPhases + 1)> swings_;
  std::array<std::optional<Moving>, 2 * kLegs*(kMostPhases + 1)> moving_;
  std::array<Known, 4 * kLegs * kLegs*(kMostPhases + 1)> apart_{}, swing_apart_{};
  NearGround ground_;
};

// Away from the ground where a foot stands: the mean normal of what it stands on. Empty in a corner so narrow that there is none.
std::optional<Vector3d> away_from(const terrain::Surface& surface, const Vector3d& foot);

}  // namespace foothold::octopod
