// Proves that the robot is free of collisions on a straight piece of a motion.
#pragma once

#include "hyrecro/check/clear.hpp"
#include "hyrecro/check/piece.hpp"

namespace foothold::hyrecro {

// As path.hpp says. Throws Refusal with the time of the first collision found; lowers `least` to what was seen. Any thread.
void judge_free(const Setting& setting, const Piece& piece, Clearance& least);

inline constexpr double kProof = 1e-4;  // m, see path.hpp

}  // namespace foothold::hyrecro
