// Which bodies of the octopod must be free of the terrain, how far from it they are, and how far they can get between two postures.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "octopod/check/nearby.hpp"
#include "octopod/check/skeleton.hpp"

namespace foothold::octopod {

// 0, 1: modules' bodies; 2, 3: necks; 4 + 2 k, 5 + 2 k: femur and tibia (without the foot) of leg k.
inline constexpr int kBodies = 4 + 2 * kLegs;
std::string body_name(int body);

// m, from the nearest triangle, 0 where they meet; looked for up to `reach` (m), which is what comes back if nothing is nearer.
double body_distance(const Model& model, const Skeleton& at, int body, std::span<const Triangle> triangles, double reach);

// A posture as the motion gives it, and what is linear in it between two of them: base (its rotation about a fixed axis) and
// joints.
struct Pose {
  Isometry3d base = Isometry3d::Identity();
  std::vector<double> joints;  // 27
};
Pose between(const Pose& a, const Pose& b, double part);

// What a whole way from one posture to the next moves at most. Rates are constant on it, so for a chain of links r_j after turns by
// w_1 .. w_j (rad, all the way) a point's way is not longer than its base's plus sum |r_j| (|w_1| + .. + |w_j|), and its second
// derivative not greater than sum |r_j| (|w_1| + .. + |w_j|)^2.
struct Ways {
  explicit Ways(const Model& model, const Pose& from, const Pose& to);

  double of_body(int body) const;  // m, of any point of it
  double of_foot(int leg) const;   // m, of any point from ankle to sole

  // m: so far a point can be off the straight line between its two ends (an eighth of the second derivative).
  double bulge_of_foot(int leg) const;
  double bulge_of_centre_of_mass() const;

 private:
  // From the module's origin out to the leg's links, with the turns that move them.
  struct Chain {
    double way = 0.0, bend = 0.0;  // of the module's origin: m, and m (second derivative)
    double turn = 0.0;             // rad, of the module
  };
  double out_to(int leg, int links, bool squared) const;

  const Model* model_;
  std::array<Chain, 2> modules_;
  std::array<std::array<double, 3>, kLegs> turns_;  // rad, of the legs' joints
};

}  // namespace foothold::octopod
