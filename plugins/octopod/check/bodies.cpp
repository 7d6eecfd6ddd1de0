// Bodies as boxes and capsules round the skeleton; bounds of their ways.
#include "octopod/check/bodies.hpp"

#include <algorithm>
#include <cmath>

namespace foothold::octopod {
namespace {

struct Segment {
  Vector3d from, to;
  double radius = 0.0;
};

Segment segment_of(const Model& model, const Skeleton& at, int body) {
  if (body < 4) {
    const Isometry3d& module = at.module[static_cast<std::size_t>(body - 2)];
    const double end = (body == 2 ? -0.5 : 0.5) * model.body.x();
    return {module * Vector3d(end, 0.0, 0.0), at.joint, model.neck_radius};
  }
  const Skeleton::Limb& limb = at.limbs[static_cast<std::size_t>((body - 4) / 2)];
  if (body % 2 == 0) return {limb.hip, limb.knee, model.leg_radius};
  return {limb.knee, limb.ankle, model.leg_radius};
}

double power(double turns, bool squared) { return squared ? turns * turns : turns; }

}  // namespace

std::string body_name(int body) {
  if (body < 2) return body == 0 ? "A body" : "B body";
  if (body < 4) return body == 2 ? "A neck" : "B neck";
  return limb((body - 4) / 2) + (body % 2 == 0 ? " femur" : " tibia");
}

double body_distance(const Model& model, const Skeleton& at, int body, std::span<const Triangle> triangles, double reach) {
  double least = reach;
  Eigen::AlignedBox3d bounds;
  if (body < 2) {
    const Isometry3d& module = at.module[static_cast<std::size_t>(body)];
    const Vector3d half = 0.5 * model.body, spread = module.linear().cwiseAbs() * half;
    bounds = {module.translation() - spread, module.translation() + spread};
    for (const Triangle& t : triangles)
      if (bounds.exteriorDistance(t.bounds) < least) least = std::min(least, distance(module, half, t));
    return least;
  }
  const Segment s = segment_of(model, at, body);
  bounds.extend(s.from).extend(s.to);
  for (const Triangle& t : triangles)
    if (bounds.exteriorDistance(t.bounds) < least + s.radius)
      least = std::min(least, std::max(0.0, distance(s.from, s.to, t) - s.radius));
  return least;
}

Pose between(const Pose& a, const Pose& b, double part) {
  Pose out;
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(a.base.linear().transpose() * b.base.linear()));
  out.base.linear() = a.base.linear() * Eigen::AngleAxisd(part * turn.angle(), turn.axis()).toRotationMatrix();
  out.base.translation() = a.base.translation() + part * (b.base.translation() - a.base.translation());
  for (std::size_t k = 0; k < a.joints.size(); ++k) out.joints.push_back(a.joints[k] + part * (b.joints[k] - a.joints[k]));
  return out;
}

Ways::Ways(const Model& model, const Pose& from, const Pose& to) : model_(&model) {
  const double turn = Eigen::AngleAxisd(Eigen::Matrix3d(from.base.linear().transpose() * to.base.linear())).angle();
  double ball = 0.0;
  for (std::size_t k = 24; k < kJoints; ++k) ball += std::abs(to.joints[k] - from.joints[k]);
  const double arm = model.arm(), way = (to.base.translation() - from.base.translation()).norm();
  modules_[0] = {way, 0.0, turn};
  modules_[1] = {way + arm * turn + arm * (turn + ball), arm * power(turn, true) + arm * power(turn + ball, true), turn + ball};
  for (std::size_t k = 0; k < kLegs; ++k)
    for (std::size_t j = 0; j < 3; ++j) turns_[k][j] = std::abs(to.joints[3 * k + j] - from.joints[3 * k + j]);
}

double Ways::out_to(int leg, int links, bool squared) const {
  const auto k = static_cast<std::size_t>(leg);
  const Chain& module = modules_[k / 4];
  double turns = module.turn;
  double sum = (squared ? module.bend : module.way) + model_->shoulders[k % 4].norm() * power(turns, squared);
  const double lengths[3] = {model_->coxa, model_->femur, model_->tibia};
  for (int j = 0; j < links; ++j) {
    turns += turns_[k][static_cast<std::size_t>(j)];
    sum += lengths[j] * power(turns, squared);
  }
  return sum;
}

double Ways::of_body(int body) const {
  if (body < 2)
    return modules_[static_cast<std::size_t>(body)].way + 0.5 * model_->body.norm() * modules_[static_cast<std::size_t>(body)].turn;
  if (body < 4) {
    const Chain& module = modules_[static_cast<std::size_t>(body - 2)];
    return module.way + model_->arm() * module.turn;
  }
  return out_to((body - 4) / 2, body % 2 == 0 ? 2 : 3, false);
}

double Ways::of_foot(int leg) const { return out_to(leg, 3, false); }

double Ways::bulge_of_foot(int leg) const { return 0.125 * out_to(leg, 3, true); }

double Ways::bulge_of_centre_of_mass() const {
  double sum = model_->body_mass * modules_[1].bend;
  for (int leg = 0; leg < kLegs; ++leg)
    sum += model_->femur_mass * out_to(leg, 2, true) + model_->tibia_mass * out_to(leg, 3, true);
  return 0.125 * sum / model_->mass();
}

}  // namespace foothold::octopod
