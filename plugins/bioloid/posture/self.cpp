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
  for (const Fold& fold : kFolds) {
    const Lanes bend = rates ? bend_of(legs, *rates, fold) : all(0.0), needed = demands.clearance + 0.125 * bend;
    // Circles round both, seen along the pitch axes from the first of the two; then rectangles; then boxes.
    const Plane2 from = offset(a.stand, fold);
    const Lanes between = legs.boxes[fold.a].flat_radius + legs.boxes[fold.b].flat_radius + needed;
    Lanes room = root(from.x * from.x + from.z * from.z);
    if (rates) {
      const Plane2 to = offset(b.stand, fold);
      const Lanes x = to.x - from.x, z = to.z - from.z;
      room = 0.5 * (room + root(to.x * to.x + to.z * to.z) - root(x * x + z * z));
    }
    if (both_above(room - between, 0.0)) continue;
    const Flat a_one = flat(legs, a.stand, fold.a), a_two = flat(legs, a.stand, fold.b);
    room = rates ? gap(a_one, a_two, flat(legs, b.stand, fold.a), flat(legs, b.stand, fold.b)) : gap(a_one, a_two);
    for (const Side side : {Side::kRight, Side::kLeft})
      if (!(of(room, side) >= of(needed, side)) &&
          !bodies_apart(a, b, body_of(side, fold.a), body_of(side, fold.b), of(bend, side)))
        return false;
  }
  return true;
}

bool Judge::Inside::legs_apart(const Snapshot& a, const Snapshot& b, const Rates* rates, bool& clear_of_far_arms) const {
  Lanes3 n = a.stand.y_axis;
  if (rates) n = n + b.stand.y_axis;
  n = {n.x + swapped(n.x), n.y + swapped(n.y), n.z + swapped(n.z)};
  const double length = std::sqrt(dot(n, n)[0]), clearance = demands.clearance * length;
  const Along at_a = along(legs, a.stand, n), at_b = rates ? along(legs, b.stand, n) : at_a;
  std::array<Lanes, kLinks> bend{};
  if (rates) {
    // Turns about axes at a small angle to n move points along n little; the pitch axes turn by no more than yaw and roll do.
    const double per_length = 1.0 / length;
    const Lanes along_a = per_length * at_a.y, along_b = per_length * at_b.y;
    const Lanes sine = root(larger(all(0.0), larger(1.0 - along_a * along_a, 1.0 - along_b * along_b)));
    bend = bends_from_torso(legs, *rates, smaller(all(1.0), sine + 0.5 * (magnitude(rates->yaw) + rates->roll)));
  }
  // How far each leg reaches to its inner side.
  std::array<Lanes, kLinks> reaches;
  Lanes inner = all(-1e9);
  for (std::size_t k = 0; k < kLinks; ++k) {
    reaches[k] = kInward * centre_along(a.stand, at_a, k) + extent_along(legs, a.stand, at_a, k);
    if (rates) {
      const Lanes there = kInward * centre_along(b.stand, at_b, k) + extent_along(legs, b.stand, at_b, k);
      reaches[k] = larger(reaches[k], there) + (0.125 * length) * bend[k];
    }
    inner = larger(inner, reaches[k]);
  }
  const Upper& u = *a.upper;
  const Lanes arms = kInward * dot(n, u.arm_centre) + magnitude(dot(n, u.arm_axes[0])) + magnitude(dot(n, u.arm_axes[1])) +
                     magnitude(dot(n, u.arm_axes[2]));
  clear_of_far_arms = both_above(-(arms + swapped(inner)), clearance);
  if (length > 0.1 && -(inner[0] + inner[1]) >= clearance) return true;
  // Link by link: the same direction, then spheres, then boxes.
  if (rates) bend = bends_from_torso(legs, *rates, all(1.0));
  std::array<Lanes3, kLinks> from, to;
  for (std::size_t k = 0; k < kLinks; ++k) {
    from[k] = centre_of(legs, a.stand, k);
    to[k] = rates ? centre_of(legs, b.stand, k) : from[k];
  }
  for (std::size_t i = 0; i < kLinks; ++i)
    for (std::size_t j = 0; j < kLinks; ++j) {
      if (length > 0.1 && -(reaches[i][0] + reaches[j][1]) >= clearance) continue;
      const double both = bend[i][0] + bend[j][1];
      const Vector3d first = from[i].at(Side::kRight) - from[j].at(Side::kLeft),
                     last = to[i].at(Side::kRight) - to[j].at(Side::kLeft);
      const double least = 0.5 * (first.norm() + last.norm() - (last - first).norm());
      if (least >= legs.boxes[i].radius[0] + legs.boxes[j].radius[1] + demands.clearance + 0.125 * both) continue;
      if (!bodies_apart(a, b, body_of(Side::kRight, i), body_of(Side::kLeft, j), both)) return false;
    }
  return true;
}

bool Judge::Inside::upper_apart(const Snapshot& a, const Snapshot& b, const Rates* rates, bool clear_of_far_arms) const {
  const bool arms_move = rates && rates->arms > 0.0;
  if (!a.upper->apart || !b.upper->apart) return false;
  const std::array<Lanes, kLinks> bend = rates ? bends_from_torso(legs, *rates, all(1.0)) : std::array<Lanes, kLinks>{};
  // The torso: spheres round the links stay below it.
  const auto heights = [&](const Snapshot& at, std::size_t k) {
    return legs.hip.z + at.stand.y_axis.z * at.stand.along_y[k] + at.stand.z_axis.z * at.stand.centre[k].z;
  };
  Lanes top = all(-1e9);
  for (std::size_t k = kThigh; k < kLinks; ++k) {
    const Lanes height = rates ? larger(heights(a, k), heights(b, k)) + 0.125 * bend[k] : heights(a, k);
    top = larger(top, height + legs.boxes[k].radius);
  }
  if (!both_above(a.upper->lowest - top, demands.clearance) && !against_legs(a, b, 0, 0, bend, 0.0)) return false;
  if (!arms_move) {
    // A plane beside each arm: hip block and thigh as boxes, what is farther down as spheres; the other leg all as spheres.
    const auto beside = [&](const Lanes3& n, Lanes offset, std::size_t as_boxes) {
      const Along at_a = along(legs, a.stand, n), at_b = rates ? along(legs, b.stand, n) : at_a;
      Lanes most = all(-1e9);
      for (std::size_t k = 0; k < kLinks; ++k) {
        const auto reaches = [&](const Snapshot& at, const Along& to) {
          return centre_along(at.stand, to, k) + (k < as_boxes ? extent_along(legs, at.stand, to, k) : legs.boxes[k].radius);
        };
        most = larger(most, rates ? larger(reaches(a, at_a), reaches(b, at_b)) + 0.125 * bend[k] : reaches(a, at_a));
      }
      return both_above(offset - most, demands.clearance);
    };
    const Lanes3& n = a.upper->arm_plane;
    const Lanes offset = a.upper->arm_offset;
    if (beside(n, offset, kShin) &&
        (clear_of_far_arms || beside({swapped(n.x), swapped(n.y), swapped(n.z)}, swapped(offset), kHipBlock)))
      return true;
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
  bool clear_of_far_arms = false;
  return folds_apart(a, b, rates) && legs_apart(a, b, rates, clear_of_far_arms) && upper_apart(a, b, rates, clear_of_far_arms) &&
         (!bracket_boxes || brackets_apart(a, b, rates));
}

}  // namespace foothold::bioloid
