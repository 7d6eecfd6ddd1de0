// The X axis of a face that brings none along.
#include "truss/truss.hpp"

namespace foothold::truss {

// World X pressed into the plane, or world Y where X is (nearly) the normal.
Vector3d axis_in(const Vector3d& normal) {
  const Vector3d along = std::abs(normal.x()) < 0.9 ? Vector3d::UnitX() : Vector3d::UnitY();
  return (along - along.dot(normal) * normal).normalized();
}

}  // namespace foothold::truss
