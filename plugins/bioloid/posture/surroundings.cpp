// What a posture or a motion has to keep against the ground: balance, soles; all seen from the support sole's frame.
#include <algorithm>
#include <cmath>

#include "bioloid/posture/inside.hpp"
#include "bioloid/posture/planes.hpp"

namespace foothold::bioloid {
namespace {

double square(double v) { return v * v; }

}  // namespace

Isometry3d Judge::Inside::body_frame(const Snapshot& at, std::size_t body) const {
  if (body > kArmJoints + 2)
    return frame_of(legs, at.stand, static_cast<Side>((body - 1) % 2), (body - body_of(Side::kRight, 0)) / 2);
  if (body <= kArmJoints) return at.upper->frames[body];
  const JointModel& yaw = model.joints[body - 1];
  return kinematics::displacement({yaw.axis, yaw.origin}, at.joints[static_cast<int>(body - 1)]) * Eigen::Translation3d(yaw.origin);
}

Isometry3d Judge::Inside::swing_sole(const Snapshot& at) const {
  const Side swing = other(ground.support.foot);
  Isometry3d out = Isometry3d::Identity();
  Eigen::Matrix3d turn;
  turn << at.stand.foot_x.at(swing), at.stand.foot_y.at(swing), at.stand.foot_z.at(swing);
  out.linear() = at.sole_turn.transpose() * turn;
  out.translation() = at.sole_turn.transpose() * (at.stand.sole.at(swing) - at.sole);
  return out;
}

Bends Judge::Inside::bends_of(const Snapshot& a, const Rates& r) const {
  const Side s = ground.support.foot, w = other(s);
  const auto of_support = [&](Lanes v) { return of(v, s); };
  const auto of_swing = [&](Lanes v) { return of(v, w); };
  // The chain from the support sole: ankle roll, the pitches back to the hip block, hip roll, yaw; the swing leg's the other way.
  const double e = of_support(r.ankle), whole = of_support(r.pitch[2]);
  const double shin = e + std::abs(whole - of_support(r.pitch[1])), thigh = e + std::abs(whole - of_support(r.pitch[0]));
  const double hip = e + std::abs(whole), bracket = hip + of_support(r.roll), torso = bracket + std::abs(of_support(r.yaw));
  const double swing_bracket = bracket + std::abs(of_swing(r.yaw) - of_support(r.yaw)),
               swing_hip = swing_bracket + of_swing(r.roll);
  std::array<double, 3> swing;
  for (std::size_t k = 0; k < 3; ++k) swing[k] = swing_hip + std::abs(of_swing(r.pitch[k]));
  const double foot = swing[2] + of_swing(r.ankle);

  const auto set = [](Lanes& v, Side side, double value) { v[index_of(side)] = value; };
  Bends out{};
  const auto& box = legs.boxes;
  const double to_knee = legs.shin_length * square(shin), to_hip = to_knee + legs.thigh_length * square(thigh);
  set(out.from_sole[kFoot], s, 0.0);
  set(out.from_sole[kAnkleBlock], s, of_support(box[kAnkleBlock].reach) * square(e));
  set(out.from_sole[kShin], s, of_support(box[kShin].reach_back) * square(shin));
  set(out.from_sole[kThigh], s, to_knee + of_support(box[kThigh].reach_back) * square(thigh));
  set(out.from_sole[kHipBlock], s, to_hip + of_support(box[kHipBlock].reach) * square(hip));
  out.upper = to_hip + (model.hip(s).norm() + a.upper->reach + (r.arms > 0.0 ? 2.0 * arm : 0.0)) * square(torso + r.arms);
  const double from_hip = to_hip + legs.hips_apart * square(torso);
  const double from_knee = from_hip + legs.thigh_length * square(swing[0]),
               from_ankle = from_knee + legs.shin_length * square(swing[1]);
  set(out.from_sole[kHipBlock], w, from_hip + of_swing(box[kHipBlock].reach) * square(swing_hip));
  set(out.from_sole[kThigh], w, from_hip + of_swing(box[kThigh].reach) * square(swing[0]));
  set(out.from_sole[kShin], w, from_knee + of_swing(box[kShin].reach) * square(swing[1]));
  set(out.from_sole[kAnkleBlock], w, from_ankle + of_swing(box[kAnkleBlock].reach) * square(swing[2]));
  set(out.from_sole[kFoot], w, from_ankle + of_swing(box[kFoot].reach) * square(foot));
  out.sole = from_ankle + legs.sole_reach * square(foot);
  out.turn = square(foot);

  const Weights& m = weights[index_of(s)];
  out.balance = m.ankle * square(e) + m.shin * square(shin) + m.thigh * square(thigh) + m.hip * square(hip) +
                m.bracket * square(bracket) + (m.torso + a.upper->moment / mass).norm() * square(torso) +
                m.swing_bracket * square(swing_bracket) + m.swing_hip * square(swing_hip) + m.swing_thigh * square(swing[0]) +
                m.swing_shin * square(swing[1]) + m.swing_ankle * square(swing[2]) + m.swing_foot * square(foot);
  if (r.arms > 0.0) out.balance += arms_mass / mass * arm * (square(torso) + square(torso + r.arms));
  return out;
}

bool Judge::Inside::balanced(const Snapshot& a, const Snapshot& b, const Bends* bends) const {
  const double needed = demands.balance + (bends ? 0.125 * bends->balance : 0.0);
  for (const Ground::Edge& edge : ground.edges) {
    const double at_a = edge.inward.dot(a.com.head<2>()) - edge.offset, at_b = edge.inward.dot(b.com.head<2>()) - edge.offset;
    if (!(std::min(at_a, at_b) >= needed)) return false;
  }
  return ground.edges.size() >= 3;
}

bool Judge::Inside::keeps_place(const Snapshot& a, const Snapshot& b, const Bends* bends) const {
  if (!ground.support.both) return true;
  const double stray = bends ? 0.125 * bends->sole : 0.0, turn = bends ? 0.125 * bends->turn : 0.0;
  const Isometry3d& place = ground.support.second;
  for (const Snapshot* at : {&a, &b}) {
    const Isometry3d sole = swing_sole(*at);
    if (!((sole.translation() - place.translation()).norm() + stray <= demands.slip)) return false;
    // A turn by t is 2 sin(t/2) away from none, as matrices by their greatest stretch; their difference's Frobenius norm is sqrt(2)
    // times that. Chords of matrices stay within the ends' distances.
    const double off = (sole.linear() - place.linear()).norm() / std::sqrt(2.0);
    if (!(2.0 * std::asin(std::min(1.0, 0.5 * (off + turn))) <= demands.slip)) return false;
    if (&a == &b) break;
  }
  return true;
}

bool Judge::Inside::above_ground(const Snapshot& a, const Snapshot& b, const Bends* bends, unsigned touching) const {
  const bool moving = bends != nullptr;
  const Side swing = other(ground.support.foot);
  // Heights over the sole of everything but the feet and the ankle blocks, which stand on the feet's plates: spheres first.
  const auto lowest = [&](const Snapshot& at) {
    const Vector3d up = at.sole_turn.col(2);
    const double sole = up.dot(at.sole);
    const Along n = along(legs, at.stand, in_both(up));
    const auto least = [&](bool spheres) {
      Lanes out = all(1e9);
      for (std::size_t k = kHipBlock; k < kAnkleBlock; ++k) {
        const Lanes extent = spheres ? legs.boxes[k].radius : extent_along(legs, at.stand, n, k);
        const Lanes bottom = centre_along(at.stand, n, k) - extent;
        out = smaller(out, moving ? bottom - 0.125 * bends->from_sole[k] : bottom);
      }
      return std::min(out[0], out[1]) - sole;
    };
    double out = least(true);
    if (out < demands.clearance) out = least(false);
    // Torso and arms: a sphere round the pelvis; part by part only near the ground.
    const double stray = moving ? 0.125 * bends->upper : 0.0;
    if (-at.upper->reach - stray < sole + demands.clearance)
      for (const Upper::Part& part : at.upper->parts) out = std::min(out, least_along(part.box, up) - stray - sole);
    return out;
  };
  if (!(lowest(a) >= demands.clearance) || (moving && !(lowest(b) >= demands.clearance))) return false;
  if (ground.support.both) return true;
  // The swing sole's corners.
  const auto corners = [&](const Snapshot& at) {
    const Vector3d up = at.sole_turn.col(2);
    const double x = 0.5 * model.sole_length * up.dot(at.stand.foot_x.at(swing)),
                 y = 0.5 * model.sole_width * up.dot(at.stand.foot_y.at(swing));
    const double centre = up.dot(at.stand.sole.at(swing) - at.sole);
    return std::array<double, 4>{centre + x + y, centre + x - y, centre - x + y, centre - x - y};
  };
  const auto from = corners(a), to = moving ? corners(b) : from;
  if (!moving) return *std::min_element(from.begin(), from.end()) >= -demands.ground;
  const double floor = touching ? -demands.ground : 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    if (!(std::min(from[k], to[k]) >= floor)) return false;
    if (((touching & kTouchesAtA) && from[k] > demands.ground) || ((touching & kTouchesAtB) && to[k] > demands.ground))
      return false;
    // (1 - t) from + t to - t (1 - t) / 2 bend >= floor: true where the parabola's least lies at an end or above the floor.
    const double bend = bends->sole, slope = to[k] - from[k];
    if (std::abs(slope) >= 0.5 * bend) continue;
    const double t = 0.5 - slope / bend;
    if (!(from[k] + t * slope - 0.5 * t * (1.0 - t) * bend >= floor)) return false;
  }
  return true;
}

}  // namespace foothold::bioloid
