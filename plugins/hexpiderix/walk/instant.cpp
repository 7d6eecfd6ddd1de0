#include "hexpiderix/walk/instant.hpp"

#include "contact/nesm.hpp"
#include "hexpiderix/stance/bodies.hpp"

namespace foothold::hexpiderix {

bool place_feet(const Model& model, const Isometry3d& thorax, const std::array<Vector3d, kLegs>& feet, Coordinates& at,
                std::size_t& leg) {
  at.thorax = thorax;
  const Isometry3d to_thorax = thorax.inverse();
  for (leg = 0; leg < kLegs; ++leg) {
    const auto joints = reach(model, leg, to_thorax * feet[leg]);
    if (!joints) return false;
    at.legs[leg] = *joints;
  }
  return true;
}

double nesm_on(const Model& model, const Coordinates& at, const Footholds& feet, Legs supports, Vector3d& com) {
  com = at.thorax * centre_of_mass(model, at.legs);
  return contact::nesm(polygon_of(feet, supports), com).value;
}

std::string in_the_way(const Model& model, const terrain::Surface& surface, const Coordinates& at, double clearance) {
  for (std::size_t leg = 0; leg < kLegs; ++leg) {
    const LegPoints points = leg_points(model, leg, at.legs[leg]);
    const Vector3d hip = at.thorax * points.hip, knee = at.thorax * points.knee, ankle = at.thorax * ankle_of(model, points);
    const std::string name = "leg " + std::to_string(leg + 1);
    if (surface.under(knee)) return name + " in the ground";
    for (const collision::Capsule& link :
         {collision::Capsule{hip, knee, model.leg_radius}, collision::Capsule{knee, ankle, model.leg_radius}})
      if (surface.nearer(link, clearance)) return name + " and the ground";
  }
  const collision::Box thorax = thorax_box(model, at.thorax);
  if (surface.nearer(thorax, clearance) || surface.under(at.thorax.translation())) return "the thorax and the ground";
  const Contacting self = trouble_with_itself(model, at, clearance);
  if (self.fault == Evaluation::Fault::kLegOnLeg)
    return "leg " + std::to_string(self.leg + 1) + " and leg " + std::to_string(self.other + 1);
  if (self.fault == Evaluation::Fault::kLegOnThorax) return "leg " + std::to_string(self.leg + 1) + " and the thorax";
  return {};
}

}  // namespace foothold::hexpiderix
