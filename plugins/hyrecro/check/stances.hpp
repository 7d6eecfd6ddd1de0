// Which foot holds and which one is placed.
#pragma once

#include "foothold/types.hpp"
#include "hyrecro/model/chain.hpp"

namespace foothold::hyrecro {

struct Stances {
  Foot holds = Foot::kA;
  const Contact* held = nullptr;    // as in the posture before
  const Contact* lifted = nullptr;  // the other foot's contact before; null: it was in the air
  const Contact* placed = nullptr;
};

// Exactly one foot is placed, the other one held before and does not move, and both and nothing else hold afterwards. Pointers into
// the arguments. Throws Refusal.
Stances judge_stances(const Step& step, const Posture& before);

}  // namespace foothold::hyrecro
