// Who stands where during a step, as its contacts say.
#pragma once

#include <optional>

#include "bioloid/model/model.hpp"

namespace foothold::bioloid::check {

// The foot that stands all along, and the other one's places: none, if it is in the air before or after.
struct Feet {
  Side standing = Side::kRight;
  Isometry3d at = Isometry3d::Identity();  // of the standing sole, in the world
  std::optional<Isometry3d> from, to;      // of the other, seen from the standing one
  bool moves = false;                      // else the other stands all along too
};

// Throws judge::Refusal.
Feet feet_of(const Step& step, const Posture& before);

}  // namespace foothold::bioloid::check
