// Both legs at once, seen from the torso: right in lane 0, left in lane 1. Private to posture/.
//
// A leg's three pitch axes are parallel: hip block, thigh, shin and ankle block move in one plane, which yaw and roll turn about
// the hip. X, Y, Z: the hip block's axes, Y along the pitch axes; a link turned by pitch t about Y has x = cos t X - sin t Z and z
// = sin t X + cos t Z. The foot turns about the ankle block's x besides.
#pragma once

#include <array>

#include "bioloid/posture/lanes.hpp"
#include "collision/distance.hpp"

namespace foothold::bioloid {

// A leg's links that have boxes, from the hip on. (The hip's bracket may have some too: see others.hpp.)
enum Link : std::size_t { kHipBlock, kThigh, kShin, kAnkleBlock, kFoot };
inline constexpr std::size_t kLinks = 5;
// Body of a link in Model::bodies.
constexpr std::size_t body_of(Side side, std::size_t link) { return leg_joint(side, link + 1) + 1; }

struct Plane2 {
  Lanes x, z;  // along X and Z, from the hip
};

struct Legs {
  explicit Legs(const Model& model);

  struct LinkBox {
    Lanes3 centre, half;  // round all boxes of the link, in its frame
    Lanes reach;          // from the link's joint to the farthest corner
    Lanes reach_back;     // from the next joint (towards the sole) to the farthest corner
  };
  std::array<Lanes, kLegJoints> signs;
  Lanes3 hip, sole;
  Lanes thigh_x, thigh_z, shin_x, shin_z;
  double thigh_length, shin_length, sole_reach, hips_apart;
  std::array<LinkBox, kLinks> boxes;

  // Masses times lengths, kg m: what each link's turn moves of the leg's centre of mass.
  Lanes3 bracket_moment, still_moment;  // still: of the hip
  Lanes hip_x, hip_z, thigh_mx, thigh_mz, shin_mx, shin_mz, ankle_mx, ankle_mz, along_y;
  Lanes3 foot_moment;
};

// Both legs in one posture.
struct Stand {
  Lanes3 x_axis, y_axis, z_axis;        // X, Y, Z
  std::array<Lanes, 3> sine, cosine;    // of the pitch of thigh, shin, ankle block
  Lanes roll_sine, roll_cosine;         // of the ankle
  std::array<Plane2, kLinks> centre;    // of the links' boxes
  std::array<Lanes, kLinks> along_y;    // of the same, along Y
  Lanes3 foot_x, foot_y, foot_z, sole;  // the sole's frame
  Lanes3 moment;                        // of the legs' masses about the pelvis, kg m
};

void evaluate(const Legs& legs, const Joints& joints, Stand& out);

// How far each link's box reaches along a direction of the torso's frame, not necessarily of length 1.
struct Spans {
  std::array<Lanes, kLinks> centre, extent;
};
FOOTHOLD_INLINE Spans spans(const Legs& legs, const Stand& at, const Lanes3& n) {
  Spans out;
  const Lanes nx = dot(n, at.x_axis), ny = dot(n, at.y_axis), nz = dot(n, at.z_axis), hip = dot(n, legs.hip), flat = magnitude(ny);
  for (std::size_t k = 0; k < kLinks; ++k) out.centre[k] = hip + nx * at.centre[k].x + nz * at.centre[k].z + ny * at.along_y[k];
  const auto& box = legs.boxes;
  out.extent[0] = box[0].half.x * magnitude(nx) + box[0].half.y * flat + box[0].half.z * magnitude(nz);
  Lanes x, z;
  for (std::size_t k = 1; k < 4; ++k) {
    x = at.cosine[k - 1] * nx - at.sine[k - 1] * nz;
    z = at.sine[k - 1] * nx + at.cosine[k - 1] * nz;
    out.extent[k] = box[k].half.x * magnitude(x) + box[k].half.y * flat + box[k].half.z * magnitude(z);
  }
  out.extent[4] = box[4].half.x * magnitude(x) + box[4].half.y * magnitude(at.roll_cosine * ny + at.roll_sine * z) +
                  box[4].half.z * magnitude(at.roll_cosine * z - at.roll_sine * ny);
  return out;
}

// A link's frame in the torso's.
Isometry3d frame_of(const Legs& legs, const Stand& at, Side side, std::size_t link);

}  // namespace foothold::bioloid
