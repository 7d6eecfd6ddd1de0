// Does the free sole leave its old face, and meet its new one, along the normal?
#pragma once

#include <vector>

#include "hyrecro/check/clear.hpp"
#include "hyrecro/check/piece.hpp"

namespace foothold::hyrecro {

enum class Line { kLeaves, kMeets };

// From the motion's begin on (kLeaves), or from its end back (kMeets), until the free sole is `lift` above `contact` for the first
// time, it is neither aside nor below nor turned by more than the tolerance; proved over the whole way to half of it more. Throws
// Refusal. Any thread.
void judge_line(const Setting& setting, const std::vector<Piece>& pieces, const Isometry3d& contact, Line line);

}  // namespace foothold::hyrecro
