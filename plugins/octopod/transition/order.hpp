// The order of lifting legs and moving bodies. Private to transition/.
#pragma once

#include <memory>

#include "contact/equilibrium.hpp"
#include "octopod/transition/passage.hpp"

namespace foothold::octopod {

// A move: a leg that swings over while the bodies rest, or the bodies that go on (leg -1) to `phase`.
struct Move {
  int leg = -1;
  int phase = 0;  // of the bodies, after it
};

// Moves from the first posture to the second, all stances proved to be in equilibrium. Empty if none is found: then `failure`
// (which may be null) tells what stopped the farthest order.
std::optional<std::vector<Move>> find_order(Passage& passage, contact::Equilibrium& equilibrium, TransitionFailure* failure);

// The feet on the ground, legs of `moved` on their new footholds, `lifted` (-1: none) in the air.
struct Stance {
  std::array<contact::Contact, kLegs> contacts;
  std::size_t count = 0;
  std::span<const contact::Contact> span() const { return {contacts.data(), count}; }
};
Stance stance(const Passage& passage, unsigned moved, int lifted);

}  // namespace foothold::octopod
