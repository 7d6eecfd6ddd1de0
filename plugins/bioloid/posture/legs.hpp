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
    Lanes3 centre, half;        // round all boxes of the link, in its frame
    Lanes reach;                // from the link's joint to the farthest corner
    Lanes radius, flat_radius;  // round the box, in space and in the leg's plane however the ankle rolls
    Lanes reach_back;           // from the next joint (towards the sole) to the farthest corner
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

// A direction n of the torso's frame, not necessarily of length 1, against the legs' planes.
struct Along {
  Lanes x, y, z, hip;
};
FOOTHOLD_INLINE Along along(const Legs& legs, const Stand& at, const Lanes3& n) {
  return {dot(n, at.x_axis), dot(n, at.y_axis), dot(n, at.z_axis), dot(n, legs.hip)};
}
// Of a link's box along n: where its centre lies, and how far it reaches to either side.
FOOTHOLD_INLINE Lanes centre_along(const Stand& at, const Along& n, std::size_t link) {
  return n.hip + n.x * at.centre[link].x + n.z * at.centre[link].z + n.y * at.along_y[link];
}
FOOTHOLD_INLINE Lanes extent_along(const Legs& legs, const Stand& at, const Along& n, std::size_t link) {
  const Lanes3& half = legs.boxes[link].half;
  if (link == kHipBlock) return half.x * magnitude(n.x) + half.y * magnitude(n.y) + half.z * magnitude(n.z);
  const std::size_t pitch = link < kAnkleBlock ? link - 1 : 2;
  const Lanes x = at.cosine[pitch] * n.x - at.sine[pitch] * n.z, z = at.sine[pitch] * n.x + at.cosine[pitch] * n.z;
  if (link != kFoot) return half.x * magnitude(x) + half.y * magnitude(n.y) + half.z * magnitude(z);
  return half.x * magnitude(x) + half.y * magnitude(at.roll_cosine * n.y + at.roll_sine * z) +
         half.z * magnitude(at.roll_cosine * z - at.roll_sine * n.y);
}

// Of a link's box.
FOOTHOLD_INLINE Lanes3 centre_of(const Legs& legs, const Stand& at, std::size_t link) {
  return legs.hip + at.centre[link].x * at.x_axis + at.along_y[link] * at.y_axis + at.centre[link].z * at.z_axis;
}

// A link's frame in the torso's.
Isometry3d frame_of(const Legs& legs, const Stand& at, Side side, std::size_t link);

}  // namespace foothold::bioloid
