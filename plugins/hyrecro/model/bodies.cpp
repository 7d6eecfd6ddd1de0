#include "hyrecro/model/bodies.hpp"

#include <algorithm>

namespace foothold::hyrecro {

// The plates without their skin reach from `skin` to their thickness above the sole.
Bodies bodies_at(const Model& model, const Coordinates& coordinates, const Isometry3d& sole0) {
  const Frames at = frames(model, coordinates);
  Bodies out;
  const double thickness = model.plate.z() - model.skin;
  for (std::size_t j = 0; j < 2; ++j) {
    out.plate[j].pose = sole0 * at.sole[j];
    out.plate[j].pose.translation() += (model.skin + 0.5 * thickness) * out.plate[j].pose.linear().col(2);
    out.plate[j].half = 0.5 * Vector3d(model.plate.x(), model.plate.y(), thickness);
    const Vector3d along = (at.upper_pin[j] - at.ankle_pin[j]).normalized();
    out.leg[j] = {sole0 * Vector3d(at.ankle_pin[j] + model.leg_begin * along), sole0 * at.upper_pin[j], model.leg_radius};
  }
  out.hip = {sole0 * at.hip, 0.5 * model.hip_plate};
  return out;
}

bool free_of_itself(const Bodies& b, double clearance) {
  using collision::nearer;
  return !nearer(b.leg[0], b.leg[1], clearance) && !nearer(b.leg[0], b.plate[1], clearance) &&
         !nearer(b.leg[1], b.plate[0], clearance) && !nearer(b.plate[0], b.plate[1], clearance) &&
         !nearer(b.plate[0], b.hip, clearance) && !nearer(b.plate[1], b.hip, clearance);
}

double self_distance(const Bodies& b) {
  using collision::distance;
  return std::min({distance(b.leg[0], b.leg[1]), distance(b.leg[0], b.plate[1]), distance(b.leg[1], b.plate[0]),
                   distance(b.plate[0], b.plate[1]), distance(b.plate[0], b.hip), distance(b.plate[1], b.hip)});
}

}  // namespace foothold::hyrecro
