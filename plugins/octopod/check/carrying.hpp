// The equilibrium of a motion, run by run: as long as the same feet stand on the same contacts.
//
// The places of the centre of mass (seen from above) where given contacts can hold the robot are a convex set. So whatever lies
// between places where they can needs no test: of all places of a run only those on their convex hull are judged.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "octopod/check/setting.hpp"

namespace foothold::octopod {

class Carrying {
 public:
  explicit Carrying(const Setting& setting) : setting_(&setting) {}

  // Over the piece of the motion from `begin` to `end` (s) these feet stand (0: in the air, else a number for its contact), and the
  // centre of mass goes from `from` to `to`, never farther than `bulge` (m) from the straight line. Refuses with the times.
  void add(double begin, double end, const std::array<std::uint8_t, kLegs>& feet, const Feet& contacts, const Vector3d& from,
           const Vector3d& to, double bulge);
  // Judges what has been added.
  void finish();

 private:
  void thin_out();
  void judge();

  const Setting* setting_;
  std::array<std::uint8_t, kLegs> feet_{};
  std::vector<contact::Contact> contacts_;
  std::vector<Vector3d> places_;
  double begin_ = 0.0, end_ = 0.0;
};

}  // namespace foothold::octopod
