// How far a point of the robot may stray from the chord of its path while all joints move evenly. Private to posture/.
//
// With q(t) = a + t d a point at the end of links l_k, link k turned by R_k, has p'' = sum R_k'' l_k, and a link that is turned by
// angles of constant rates w_i one after the other has |R''| <= (sum |w_i|)^2; angles about parallel axes (a leg's pitch) count as
// one, with their signed sum. The point then strays by at most t (1 - t) / 2 |p''| <= |p''| / 8 from the chord. What this gives are
// the bounds on |p''|, m, called bends.
#pragma once

#include "bioloid/posture/legs.hpp"

namespace foothold::bioloid {

// Of a motion between two postures, in rad; yaw and pitch signed, pitch of the links against the hip block.
struct Rates {
  Rates(const Legs& legs, const Joints& a, const Joints& b);
  Lanes yaw, roll, ankle;
  std::array<Lanes, 3> pitch;
  double arms = 0.0;  // the greater of both arms' sums
};

// Masses times lengths over the whole mass, m, of what turns with each link, seen from a support sole: its own links, then the
// swing leg's, from foot to foot.
struct Weights {
  Weights() = default;
  Weights(const Model& model, Side support);
  double ankle = 0.0, shin = 0.0, thigh = 0.0, hip = 0.0, bracket = 0.0;
  Vector3d torso = Vector3d::Zero();  // without the moment of torso and arms about the pelvis
  double swing_bracket = 0.0, swing_hip = 0.0, swing_thigh = 0.0, swing_shin = 0.0, swing_ankle = 0.0, swing_foot = 0.0;
};

struct Bends {
  std::array<Lanes, kLinks> from_torso;  // of the links' points
  std::array<Lanes, kLinks> from_sole;   // the same, seen from the support sole
  double sole = 0.0;                     // of the swing sole's corners
  double turn = 0.0;                     // of the swing sole's rotation, rad^2: |R''|
  double upper = 0.0;                    // of torso and arms
  double balance = 0.0;                  // of the centre of mass
};

// Points of links seen from the torso along a direction at an angle of asin(`across`) or less to the pitch axes: turns about these
// move them less.
std::array<Lanes, kLinks> bends_from_torso(const Legs& legs, const Rates& rates, Lanes across);

}  // namespace foothold::bioloid
