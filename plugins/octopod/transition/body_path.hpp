// Bodies between two postures: C straight, each module turning about one axis, both at constant speed. Values; any thread.
#pragma once

#include "octopod/posture/pair.hpp"

namespace foothold::octopod {

class BodyPath {
 public:
  BodyPath(const Pair& from, const Pair& to);
  Pair at(double part) const;                                                         // 0 to 1
  double way() const { return (to_.joint - from_.joint).norm(); }                     // m, of C
  double turn(int module) const { return angle_[static_cast<std::size_t>(module)]; }  // rad, in all

 private:
  Pair from_, to_;
  std::array<Vector3d, 2> axis_;  // in the module's frame
  std::array<double, 2> angle_{};
};

}  // namespace foothold::octopod
