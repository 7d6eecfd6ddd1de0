// The robot's bodies against each other: planes for whole groups first, then box by box.
//
// The groups: the links of a leg (folds.hpp); leg against leg, by a plane along the pitch axes; torso against legs, by a plane
// under it; arms against legs, by a plane beside each arm. Box by box: exact for a posture; for a motion, one direction of
// separation for both ends, in the frame of one of the two bodies within a leg, else in the torso's.
#include "bioloid/posture/folds.hpp"
#include "bioloid/posture/inside.hpp"
#include "bioloid/posture/planes.hpp"

namespace foothold::bioloid {
namespace {

constexpr Lanes kInward{1.0, -1.0};  // which way along Y a leg's inner side lies

// Two instants of a motion, or twice the same posture; `bends` then 0.
struct Instants {
  const Snapshot &a, &b;
  bool moving;
};

// m, what of a link's box lies farthest along +-n (n by lane), at the worse of both instants; with the bends, in lengths of n.
Lanes farthest(const Spans& a, const Spans& b, Lanes way, const std::array<Lanes, kLinks>& bend, double length, std::size_t first) {
  Lanes most = all(-1e9);
  for (std::size_t k = first; k < kLinks; ++k)
    most = larger(most, larger(way * a.centre[k] + a.extent[k], way * b.centre[k] + b.extent[k]) + (0.125 * length) * bend[k]);
  return most;
}

bool is_leg(std::size_t body) { return body > kArmJoints; }
std::size_t side_of(std::size_t body) { return (body - 1) % 2; }

}  // namespace

// One pair of bodies, box by box.
bool Judge::Inside::bodies_apart(const Snapshot& a, const Snapshot& b, std::size_t one, std::size_t two, double bend) const {
  const bool moving = &a != &b, within_leg = is_leg(one) && is_leg(two) && side_of(one) == side_of(two);
  const double needed = demands.clearance + 0.125 * bend;
  const auto frames = [&](const Snapshot& at) {
    const Isometry3d first = body_frame(at, one), second = body_frame(at, two);
    return within_leg ? std::pair(Isometry3d::Identity(), first.inverse() * second) : std::pair(first, second);
  };
  const auto [one_a, two_a] = frames(a);
  const auto [one_b, two_b] = moving ? frames(b) : std::pair(one_a, two_a);
  const auto placed = [](const Isometry3d& frame, const BodyBox& box) {
    return collision::Box{frame * Eigen::Translation3d(box.centre), box.half};
  };
  for (const BodyBox& p : model.bodies[one].boxes)
    for (const BodyBox& q : model.bodies[two].boxes) {
      const collision::Box pa = placed(one_a, p), qa = placed(two_a, q);
      if (moving ? !parted(pa, qa, placed(one_b, p), placed(two_b, q), needed) : collision::nearer(pa, qa, demands.clearance))
        return false;
    }
  return true;
}

bool Judge::Inside::folds_apart(const Snapshot& a, const Snapshot& b, const Rates* rates) const {
  std::array<Flat, kLinks> at_a, at_b;
  for (std::size_t k = 0; k < kLinks; ++k) at_a[k] = flat(legs, a.stand, k);
  if (rates)
    for (std::size_t k = 0; k < kLinks; ++k) at_b[k] = flat(legs, b.stand, k);
  for (const Fold& fold : kFolds) {
    const Lanes bend = rates ? bend_of(legs, *rates, fold) : all(0.0);
    const Lanes room =
        rates ? gap(at_a[fold.a], at_a[fold.b], at_b[fold.a], at_b[fold.b]) - 0.125 * bend : gap(at_a[fold.a], at_a[fold.b]);
    for (const Side side : {Side::kRight, Side::kLeft})
      if (!(of(room, side) >= demands.clearance) &&
          !bodies_apart(a, b, body_of(side, fold.a), body_of(side, fold.b), of(bend, side)))
        return false;
  }
  return true;
}

bool Judge::Inside::legs_apart(const Snapshot& a, const Snapshot& b, const Rates* rates) const {
  Lanes3 n = a.stand.y_axis;
  if (rates) n = n + b.stand.y_axis;
  n = {n.x + swapped(n.x), n.y + swapped(n.y), n.z + swapped(n.z)};
  const double length = std::sqrt(dot(n, n)[0]);
  std::array<Lanes, kLinks> bend{};
  if (rates) {
    const auto across = [&](const Lanes3& y) {
      const Lanes along = dot(n, y) / length;
      return 1.0 - along * along;
    };
    // The pitch axes turn by no more than yaw and roll do.
    Lanes sine_squared = larger(across(a.stand.y_axis), across(b.stand.y_axis));
    Lanes sine = all(0.0);
    for (std::size_t s = 0; s < 2; ++s) sine[s] = std::sqrt(std::max(0.0, sine_squared[s]));
    bend = bends_from_torso(legs, *rates, smaller(all(1.0), sine + 0.5 * (magnitude(rates->yaw) + rates->roll)));
  }
  const Spans at_a = spans(legs, a.stand, n), at_b = rates ? spans(legs, b.stand, n) : at_a;
  const Lanes inner = farthest(at_a, at_b, kInward, bend, length, 0);
  if (length > 0.1 && -(inner[0] + inner[1]) >= demands.clearance * length) return true;
  if (rates) bend = bends_from_torso(legs, *rates, all(1.0));
  for (std::size_t i = 0; i < kLinks; ++i)
    for (std::size_t j = 0; j < kLinks; ++j)
      if (!bodies_apart(a, b, body_of(Side::kRight, i), body_of(Side::kLeft, j), bend[i][0] + bend[j][1])) return false;
  return true;
}

bool Judge::Inside::upper_apart(const Snapshot& a, const Snapshot& b, const Rates* rates) const {
  const bool arms_move = rates && rates->arms > 0.0;
  if (!a.upper->apart || !b.upper->apart) return false;
  const std::array<Lanes, kLinks> bend = rates ? bends_from_torso(legs, *rates, all(1.0)) : std::array<Lanes, kLinks>{};
  const Lanes3 up{all(0.0), all(0.0), all(1.0)};
  {
    const Spans at_a = spans(legs, a.stand, up), at_b = rates ? spans(legs, b.stand, up) : at_a;
    const Lanes top = farthest(at_a, at_b, all(1.0), bend, 1.0, kThigh);
    if (!both_above(a.upper->lowest - top, demands.clearance) && !against_legs(a, b, 0, 0, bend, 0.0)) return false;
  }
  if (!arms_move) {
    const auto& n = a.upper->normal;
    const Lanes offset{a.upper->offset[0], a.upper->offset[1]};
    const auto beside = [&](const Lanes3& normal, Lanes beyond) {
      const Spans at_a = spans(legs, a.stand, normal), at_b = rates ? spans(legs, b.stand, normal) : at_a;
      return both_above(beyond - farthest(at_a, at_b, all(1.0), bend, 1.0, kHipBlock), demands.clearance);
    };
    if (beside(lanes(n[0], n[1]), offset) && beside(lanes(n[1], n[0]), swapped(offset))) return true;
  }
  const double arm_bend = arms_move ? arm * rates->arms * rates->arms : 0.0;
  if (arms_move && !arms_apart(a, b, arm_bend)) return false;
  return against_legs(a, b, 1, kArmJoints, bend, arm_bend);
}

// Bodies `first` to `last` of torso and arms against all links, box by box.
bool Judge::Inside::against_legs(const Snapshot& a, const Snapshot& b, std::size_t first, std::size_t last,
                                 const std::array<Lanes, kLinks>& bend, double own_bend) const {
  for (std::size_t body = first; body <= last; ++body)
    for (const Side side : {Side::kRight, Side::kLeft})
      for (std::size_t k = 0; k < kLinks; ++k)
        if (!model.neighbours(body, body_of(side, k)) && !bodies_apart(a, b, body, body_of(side, k), of(bend[k], side) + own_bend))
          return false;
  return true;
}

// Arms that move, against each other and the torso.
bool Judge::Inside::arms_apart(const Snapshot& a, const Snapshot& b, double bend) const {
  for (std::size_t one = 0; one <= kArmJoints; ++one)
    for (std::size_t two = one + 1; two <= kArmJoints; ++two)
      if (!model.neighbours(one, two) && !bodies_apart(a, b, one, two, 2.0 * bend)) return false;
  return true;
}

// Brackets of the hip, where they have boxes.
bool Judge::Inside::brackets_apart(const Snapshot& a, const Snapshot& b, const Rates* rates) const {
  const std::array<Lanes, kLinks> bend = rates ? bends_from_torso(legs, *rates, all(1.0)) : std::array<Lanes, kLinks>{};
  for (const Side side : {Side::kRight, Side::kLeft}) {
    const std::size_t bracket = leg_joint(side, 0) + 1;
    if (model.bodies[bracket].boxes.empty()) continue;
    const auto bracket_bend = [&](Side of_side) {
      const double yaw = rates ? of(rates->yaw, of_side) : 0.0;
      return bracket_reach * yaw * yaw;
    };
    for (std::size_t body = 0; body < kBodies; ++body) {
      if (model.neighbours(bracket, body) || model.bodies[body].boxes.empty()) continue;
      double its = 0.0;
      if (body <= kArmJoints)
        its = rates ? arm * rates->arms * rates->arms : 0.0;
      else if (body > leg_joint(Side::kLeft, 0) + 1)
        its = of(bend[(body - leg_joint(Side::kRight, 1) - 1) / 2], static_cast<Side>(side_of(body)));
      else
        its = bracket_bend(static_cast<Side>(side_of(body)));
      if (!bodies_apart(a, b, bracket, body, bracket_bend(side) + its)) return false;
    }
  }
  return true;
}

bool Judge::Inside::self_apart(const Snapshot& a, const Snapshot& b, const Rates* rates) const {
  return folds_apart(a, b, rates) && legs_apart(a, b, rates) && upper_apart(a, b, rates) &&
         (!bracket_boxes || brackets_apart(a, b, rates));
}

}  // namespace foothold::bioloid
