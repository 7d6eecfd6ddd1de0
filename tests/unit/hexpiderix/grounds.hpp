// Grounds for tests of Hex-piderix, as text of terrain files.
#pragma once

#include <cmath>
#include <sstream>
#include <string>

#include "hexpiderix/ground.hpp"

namespace foothold::hexpiderix::testing {

// A strip that falls by `first` up to x = 0 and by `second` behind it, both along +x; turned about z by `direction`.
inline std::string bent_ground(double first, double second, double direction) {
  std::ostringstream out;
  out.precision(17);
  out << "kind: terrain\nvertices: [";
  const double xs[] = {-2.5, 0.0, 2.5};
  bool comma = false;
  for (const double x : xs)
    for (const double y : {-2.5, 2.5}) {
      const double z = x < 0.0 ? -x * std::tan(first) : -x * std::tan(second);
      out << (comma ? ", " : "") << "[" << x * std::cos(direction) - y * std::sin(direction) << ", "
          << x * std::sin(direction) + y * std::cos(direction) << ", " << z << "]";
      comma = true;
    }
  out << "]\ntriangles: [[0, 2, 3], [0, 3, 1], [2, 4, 5], [2, 5, 3]]\n";
  return out.str();
}

inline Vector3d on(const Ground& ground, double x, double y) { return {x, y, ground.surface().height(x, y).value()}; }

}  // namespace foothold::hexpiderix::testing
