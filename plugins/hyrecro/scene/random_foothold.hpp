// Starts and goals for tests and benches.
#pragma once

#include <optional>
#include <random>

#include "hyrecro/route/route.hpp"

namespace foothold::hyrecro {

// A foothold whose whole plate lies on its face: faces by their area, then place and heading evenly (to a millionth of a metre and
// a radian). Empty if 10,000 tries find none, as where all faces are narrower than the plate. The same from the same draws on every
// machine. Any thread.
std::optional<Foothold> random_foothold(const Model& model, const truss::Truss& truss, std::mt19937_64& random);

}  // namespace foothold::hyrecro
