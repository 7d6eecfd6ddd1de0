#include "hyrecro/optimal/strides.hpp"

#include "hyrecro/motion/lift.hpp"

namespace foothold::hyrecro {

Strides::Strides(const Model& model, const PreparedTruss& scene)
    : model_(model),
      scene_(scene),
      bounds_(model),
      level_(model, bounds_.shift()),
      reachability_(make_exact(model, scene.clearance)) {}

std::optional<Coordinates> Strides::level(const Foothold& from, const Foothold& to) const {
  const Eigen::Rotation2Dd back(-from.heading);
  const Isometry3d holding = pose_of(scene_.truss, from);
  std::optional<Coordinates> out;
  level_.any(back * (to.at - from.at), to.heading - from.heading, [&](const Coordinates& coordinates) {
    if (!fits(coordinates, holding)) return false;
    out = coordinates;
    return true;
  });
  return out;
}

bool Strides::fits(const Coordinates& coordinates, const Isometry3d& holding) const {
  if (lift_ != 0.0 && !(lifted(model_, coordinates, lift_) && lifted(model_, swapped(coordinates), lift_))) return false;
  const Bodies bodies = bodies_at(model_, coordinates, holding);
  return free_of_itself(bodies, scene_.clearance) && scene_.obstacles.free(bodies, scene_.clearance);
}

std::optional<Coordinates> Strides::exact(const Foothold& from, const Foothold& to) {
  const Isometry3d holding = pose_of(scene_.truss, from), free = pose_of(scene_.truss, to);
  return in_scene_.get(holding, free, [&]() -> std::optional<Coordinates> {
    const Isometry3d pose = holding.inverse(Eigen::Isometry) * free;
    const Reach reach = reachability_->reach(pose, [&](const Coordinates& coordinates) { return clear(coordinates, holding); });
    return reach.reachable && has_room(pose) ? reach.coordinates : std::nullopt;
  });
}

std::optional<Coordinates> Strides::alone(const Isometry3d& free_in_holding) {
  return alone_.get(Isometry3d::Identity(), free_in_holding, [&]() -> std::optional<Coordinates> {
    const Reach reach = reachability_->reach(free_in_holding, {});
    return reach.reachable && has_room(free_in_holding) ? reach.coordinates : std::nullopt;
  });
}

bool Strides::has_room(const Isometry3d& free_in_holding) {
  const Eigen::Translation3d up(0.0, 0.0, lift_);
  return lift_ == 0.0 || (reachability_->reach(free_in_holding * up, {}).reachable &&
                          reachability_->reach(free_in_holding.inverse(Eigen::Isometry) * up, {}).reachable);
}

bool Strides::clear(const Coordinates& coordinates, const Isometry3d& holding) const {
  return scene_.obstacles.free(bodies_at(model_, coordinates, holding), scene_.clearance);
}

bool Strides::on_face(const Foothold& foothold) const {
  return plate_on_face(model_, scene_.truss.faces[static_cast<std::size_t>(foothold.face)], foothold);
}

}  // namespace foothold::hyrecro
