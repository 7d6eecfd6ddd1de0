// How fast the bodies can move at most while the joints move straight from one posture to another: what carries a distance at one
// point of a motion over to its neighbours.
#pragma once

#include <span>

#include "hyrecro/model/chain.hpp"

namespace foothold::hyrecro {

// Bounds over a whole straight piece of a motion: metres (radians) per piece, so that no point of a body goes farther than its rate
// times the part of the piece. Seen from the foot that holds.
struct Rates {
  double leg0 = 0.0, hip = 0.0, leg1 = 0.0, plate1 = 0.0;  // m; plate 0 does not move. Infinite: no bound
  // Of sole 1 against the straight line between two postures: its origin (m) and its rotation (rad) leave the mean of what they are
  // at the ends of a part h of the piece by at most this times h^2 / 8.
  double bend1 = 0.0, bend_turn1 = 0.0;
};

// One mechanism's bounds over the piece.
struct MechanismRates {
  double phi = 0.0, y = 0.0;                 // rad and m per piece
  double phi_bend = 0.0, y_bend = 0.0;       // their second derivatives
  double greatest_phi = 0.0, longest = 0.0;  // rad and m: of |phi| and of y
};
MechanismRates mechanism_rates(const kinematics::PlanarMechanism& mechanism, const kinematics::PlanarMechanism::Lengths& from,
                               const kinematics::PlanarMechanism::Lengths& to);

// Precondition: ten joints within their limits in `from` and in `to`. The derivation is in rates.cpp. Any thread.
Rates rates_between(const Model& model, std::span<const double> from, std::span<const double> to, Foot holds);

}  // namespace foothold::hyrecro
