// Constants of the legs and their closed form forward.
#include "bioloid/posture/legs.hpp"

#include <algorithm>
#include <cmath>

namespace foothold::bioloid {
namespace {

struct Hull {
  Vector3d centre = Vector3d::Zero(), half = Vector3d::Zero();
  double reach = 0.0, reach_back = 0.0;
};

Hull hull_of(const Body& body, const Vector3d& next) {
  Hull out;
  if (body.boxes.empty()) return {Vector3d::Zero(), Vector3d::Zero(), 0.0, next.norm()};
  Eigen::AlignedBox3d bounds;
  for (const BodyBox& box : body.boxes) {
    bounds.extend(box.centre - box.half);
    bounds.extend(box.centre + box.half);
  }
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3d at = bounds.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner));
    out.reach = std::max(out.reach, at.norm());
    out.reach_back = std::max(out.reach_back, (at - next).norm());
  }
  out.centre = bounds.center();
  out.half = 0.5 * bounds.sizes();
  return out;
}

}  // namespace

Legs::Legs(const Model& model) {
  constexpr Side kRight = Side::kRight, kLeft = Side::kLeft;
  for (std::size_t k = 0; k < kLegJoints; ++k) signs[k] = Lanes{model.sign(kRight, k), model.sign(kLeft, k)};
  hip = lanes(model.hip(kRight), model.hip(kLeft));
  sole = lanes(model.sole(kRight), model.sole(kLeft));
  const Vector3d &thigh = model.leg().thigh, &shin = model.leg().shin;
  thigh_x = all(thigh.x());
  thigh_z = all(thigh.z());
  shin_x = all(shin.x());
  shin_z = all(shin.z());
  thigh_length = thigh.norm();
  shin_length = shin.norm();
  sole_reach = Vector3d(std::abs(model.ankle_to_sole.x()) + 0.5 * model.sole_length,
                        std::abs(model.ankle_to_sole.y()) + 0.5 * model.sole_width, model.ankle_to_sole.z())
                   .norm();
  hips_apart = (model.hip(kRight) - model.hip(kLeft)).norm();
  for (std::size_t k = 0; k < kLinks; ++k) {
    const Vector3d next = k == kThigh ? thigh : k == kShin ? shin : Vector3d(0, 0, 0);
    const Hull right = hull_of(model.bodies[body_of(kRight, k)], next), left = hull_of(model.bodies[body_of(kLeft, k)], next);
    LinkBox& box = boxes[k];
    box.centre = lanes(right.centre, left.centre);
    box.half = lanes(right.half, left.half);
    box.reach = Lanes{right.reach, left.reach};
    box.reach_back = Lanes{right.reach_back, left.reach_back};
    for (const Side side : {kRight, kLeft}) {
      const Vector3d half = box.half.at(side);
      box.radius[index_of(side)] = half.norm();
      box.flat_radius[index_of(side)] = k == kFoot ? half.norm() : std::hypot(half.x(), half.z());
    }
  }
  // What of the moment turns with each link: its own mass at its centre, and all masses beyond it at its far end.
  std::array<Vector3d, 2> bracket, still, block, upper, lower, ankle, foot;
  for (const Side side : {kRight, kLeft}) {
    const std::size_t s = index_of(side);
    const auto body = [&](std::size_t k) -> const Body& { return model.bodies[leg_joint(side, k) + 1]; };
    const auto own = [&](std::size_t k) -> Vector3d { return body(k).mass * body(k).centre_of_mass; };
    double mass = 0.0;
    for (std::size_t k = 0; k < kLegJoints; ++k) mass += body(k).mass;
    const double below_ankle = body(4).mass + body(5).mass;
    bracket[s] = own(0);
    still[s] = mass * model.hip(side);
    block[s] = own(1);
    upper[s] = own(2) + (body(3).mass + below_ankle) * thigh;
    lower[s] = own(3) + below_ankle * shin;
    ankle[s] = own(4);
    foot[s] = own(5);
  }
  const auto across = [](const std::array<Vector3d, 2>& v, int axis) { return Lanes{v[0][axis], v[1][axis]}; };
  bracket_moment = lanes(bracket[0], bracket[1]);
  still_moment = lanes(still[0], still[1]);
  hip_x = across(block, 0);
  hip_z = across(block, 2);
  thigh_mx = across(upper, 0);
  thigh_mz = across(upper, 2);
  shin_mx = across(lower, 0);
  shin_mz = across(lower, 2);
  ankle_mx = across(ankle, 0);
  ankle_mz = across(ankle, 2);
  along_y = across(block, 1) + across(upper, 1) + across(lower, 1) + across(ankle, 1);
  foot_moment = lanes(foot[0], foot[1]);
}

void evaluate(const Legs& legs, const Joints& joints, Stand& out) {
  std::array<Lanes, kLegJoints> angle;
  for (std::size_t k = 0; k < kLegJoints; ++k) {
    std::memcpy(&angle[k], joints.data() + leg_joint(Side::kRight, k), sizeof(Lanes));
    angle[k] *= legs.signs[k];
  }
  Lanes sy, cy, sr, cr;
  sine_and_cosine(angle[0], sy, cy);
  sine_and_cosine(angle[1], sr, cr);
  sine_and_cosine(angle[2], out.sine[0], out.cosine[0]);
  sine_and_cosine(angle[2] + angle[3], out.sine[1], out.cosine[1]);
  sine_and_cosine(angle[2] + angle[3] + angle[4], out.sine[2], out.cosine[2]);
  sine_and_cosine(angle[5], out.roll_sine, out.roll_cosine);
  const Lanes zero = all(0.0), s4 = out.roll_sine, c4 = out.roll_cosine;
  out.x_axis = {cy, sy, zero};
  out.y_axis = {-sy * cr, cy * cr, sr};
  out.z_axis = {sy * sr, -cy * sr, cr};

  // In the leg's plane: (along x, along z) of a link to (X, Z).
  const auto turned = [&](std::size_t pitch, Lanes x, Lanes z) {
    return Plane2{out.cosine[pitch] * x + out.sine[pitch] * z, out.cosine[pitch] * z - out.sine[pitch] * x};
  };
  const Plane2 knee = turned(0, legs.thigh_x, legs.thigh_z), shin = turned(1, legs.shin_x, legs.shin_z);
  const Plane2 ankle{knee.x + shin.x, knee.z + shin.z};
  const auto& box = legs.boxes;
  const auto place = [&](std::size_t link, const Plane2& from, const Plane2& by, Lanes y) {
    out.centre[link] = {from.x + by.x, from.z + by.z};
    out.along_y[link] = y;
  };
  out.centre[kHipBlock] = {box[0].centre.x, box[0].centre.z};
  out.along_y[kHipBlock] = box[0].centre.y;
  place(kThigh, {zero, zero}, turned(0, box[1].centre.x, box[1].centre.z), box[1].centre.y);
  place(kShin, knee, turned(1, box[2].centre.x, box[2].centre.z), box[2].centre.y);
  place(kAnkleBlock, ankle, turned(2, box[3].centre.x, box[3].centre.z), box[3].centre.y);
  const Lanes3& foot = box[4].centre;
  place(kFoot, ankle, turned(2, foot.x, c4 * foot.z + s4 * foot.y), c4 * foot.y - s4 * foot.z);

  const Lanes c3 = out.cosine[2], s3 = out.sine[2];
  const Lanes3 &x = out.x_axis, &y = out.y_axis, &z = out.z_axis;
  out.foot_x = {c3 * x.x - s3 * z.x, c3 * x.y - s3 * z.y, -s3 * z.z};
  const Lanes3 up{s3 * x.x + c3 * z.x, s3 * x.y + c3 * z.y, c3 * z.z};
  out.foot_y = c4 * y + s4 * up;
  out.foot_z = c4 * up - s4 * y;
  const Plane2 sole = turned(2, legs.sole.x, c4 * legs.sole.z + s4 * legs.sole.y);
  const Lanes sole_x = ankle.x + sole.x, sole_z = ankle.z + sole.z, sole_y = c4 * legs.sole.y - s4 * legs.sole.z;
  out.sole = {legs.hip.x + sole_x * x.x + sole_y * y.x + sole_z * z.x, legs.hip.y + sole_x * x.y + sole_y * y.y + sole_z * z.y,
              legs.hip.z + sole_y * y.z + sole_z * z.z};

  const Plane2 m1 = turned(0, legs.thigh_mx, legs.thigh_mz), m2 = turned(1, legs.shin_mx, legs.shin_mz);
  const Lanes3& m = legs.foot_moment;
  const Plane2 m3 = turned(2, legs.ankle_mx + m.x, legs.ankle_mz + c4 * m.z + s4 * m.y);
  const Lanes mx = legs.hip_x + m1.x + m2.x + m3.x, mz = legs.hip_z + m1.z + m2.z + m3.z, my = legs.along_y + c4 * m.y - s4 * m.z;
  const Lanes3 &still = legs.still_moment, &bracket = legs.bracket_moment;
  out.moment = {still.x + cy * bracket.x - sy * bracket.y + mx * x.x + my * y.x + mz * z.x,
                still.y + sy * bracket.x + cy * bracket.y + mx * x.y + my * y.y + mz * z.y,
                still.z + bracket.z + my * y.z + mz * z.z};
}

Isometry3d frame_of(const Legs& legs, const Stand& at, Side side, std::size_t link) {
  const Vector3d x = at.x_axis.at(side), y = at.y_axis.at(side), z = at.z_axis.at(side);
  Isometry3d out = Isometry3d::Identity();
  Eigen::Matrix3d turn;
  if (link == kFoot)
    turn << at.foot_x.at(side), at.foot_y.at(side), at.foot_z.at(side);
  else if (link == kHipBlock)
    turn << x, y, z;
  else {
    const double s = of(at.sine[link - 1], side), c = of(at.cosine[link - 1], side);
    turn << c * x - s * z, y, s * x + c * z;
  }
  out.linear() = turn;
  const auto& box = legs.boxes[link];
  const Vector3d centre = of(at.centre[link].x, side) * x + of(at.along_y[link], side) * y + of(at.centre[link].z, side) * z;
  out.translation() = legs.hip.at(side) + centre - turn * box.centre.at(side);
  return out;
}

}  // namespace foothold::bioloid
