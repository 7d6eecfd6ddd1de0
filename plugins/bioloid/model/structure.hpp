// What every file of a biped has to keep, wherever the numbers come from.
#pragma once

#include <string>

#include "bioloid/model/model.hpp"

namespace foothold::bioloid {

// Checks joints, bodies and soles against Bioloid's structure, moves the joints' origins to where the axes of hip and ankle meet (a
// body's frame may start anywhere on its joint's axis) and fills in what follows: leg, hips, signs, neighbours. Throws
// InvalidModel; the field is `entry` with the joint's name in place of "*".
void complete(Model& model, const std::string& entry);

}  // namespace foothold::bioloid
