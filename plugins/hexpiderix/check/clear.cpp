#include "hexpiderix/check/clear.hpp"

#include <numbers>
#include <string>

#include "judge/refusal.hpp"

namespace foothold::hexpiderix {
namespace {

using collision::Box;
using collision::Capsule;
using judge::refuse;

// Three boxes over opposite sides make the hexagon.
std::array<Box, 3> thorax_boxes(const Model& model, const Isometry3d& base) {
  std::array<Box, 3> out;
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = {base * Eigen::AngleAxisd(std::numbers::pi / 6 + static_cast<double>(k) * std::numbers::pi / 3, Vector3d::UnitZ()),
              {model.thorax_width * std::numbers::sqrt3 / 4, model.thorax_width / 4, model.thorax_height / 2}};
  return out;
}

std::string named(std::size_t leg) { return "L" + std::to_string(leg + 1); }

}  // namespace

void judge_clear(const Model& model, const terrain::Surface& surface, const Isometry3d& base, const Skeleton& at, Legs supports,
                 double clearance, const char* which) {
  // A body that is just as far away as it must be is.
  const double least = std::max(0.0, clearance - 1e-9);
  const double radius = model.leg_radius;
  const std::array<Box, 3> thorax = thorax_boxes(model, base);
  for (const Box& box : thorax)
    if (surface.nearer(box, least) || surface.under(box.pose.translation()))
      refuse(which, ": the thorax is ", surface.distance(box), " m from the terrain, at least ", clearance, " m are demanded");
  for (std::size_t leg = 0; leg < kLegs; ++leg) {
    const Skeleton::Limb& limb = at.limbs[leg];
    const Vector3d ankle = limb.foot + model.toe * (limb.knee - limb.foot).normalized();
    const Capsule femur{limb.hip, limb.knee, radius}, tibia{limb.knee, ankle, radius};
    for (const Capsule& link : {femur, tibia})
      if (surface.nearer(link, least) || surface.under(link.a))
        refuse(which, ": leg ", named(leg), " is ", surface.distance(link), " m from the terrain, at least ", clearance,
               " m are demanded");
    if (!supports[leg] && surface.under(limb.foot + judge::kPoseTolerance * Vector3d::UnitZ()))
      refuse(which, ": foot ", named(leg), " swings under the terrain");
    const Capsule whole{limb.knee, limb.foot, radius};
    for (const Box& box : thorax)
      if (collision::nearer(whole, box, least)) refuse(which, ": leg ", named(leg), " touches the thorax");
    for (std::size_t other = leg + 1; other < kLegs; ++other) {
      const Capsule links[2] = {{at.limbs[other].hip, at.limbs[other].knee, radius},
                                {at.limbs[other].knee, at.limbs[other].foot, radius}};
      for (const Capsule& a : {femur, whole})
        for (const Capsule& b : links)
          if (collision::nearer(a, b, least))
            refuse(which, ": legs ", named(leg), " and ", named(other), " are ", collision::distance(a, b), " m apart, at least ",
                   clearance, " m are demanded");
    }
  }
}

}  // namespace foothold::hexpiderix
