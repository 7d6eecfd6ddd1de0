// Random bodies for the tests: at any angle, and on a lattice so that edges are parallel and faces touch.
#pragma once

#include <random>
#include <vector>

#include "collision/distance.hpp"

namespace foothold::collision {

enum class Kind { kAnywhere, kLattice, kNearlyLattice };  // the last: turned and shifted by 1e-12 to 1e-4
inline constexpr Kind kKinds[]{Kind::kAnywhere, Kind::kLattice, Kind::kNearlyLattice};

class Pairs {
 public:
  explicit Pairs(Kind kind, unsigned seed = 1) : kind_(kind), random_(seed) {}
  Capsule capsule();                // one in eight is a sphere
  Box box();                        // some have no thickness
  std::vector<Vector3d> polygon();  // convex, 3 to 6 vertices
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  int integer(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
  Isometry3d pose();

 private:
  double length();  // m, up to 0.3
  Kind kind_;
  std::mt19937_64 random_;
};

}  // namespace foothold::collision
