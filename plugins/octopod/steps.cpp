// Steps of states.
#include "octopod/steps.hpp"

#include <cmath>
#include <cstdio>

namespace foothold::octopod {
namespace {

std::string shown(const char* form, double value) {
  char text[32];
  std::snprintf(text, sizeof text, form, value == 0.0 ? 0.0 : value);
  return text;
}

std::string shown_place(const Vector3d& at) {
  return "(" + shown("%.3f", at.x()) + ", " + shown("%.3f", at.y()) + ", " + shown("%.3f", at.z()) + ") m";
}

Isometry3d contact_frame(const Footing& foot, const Vector3d& ahead) {
  // An axis along the normal leaves forward open.
  Vector3d x = ahead - ahead.dot(foot.normal) * foot.normal;
  if (x.norm() < 1e-9) x = foot.normal.unitOrthogonal();
  x.normalize();
  Isometry3d out = Isometry3d::Identity();
  out.linear() << x, foot.normal.cross(x), foot.normal;
  out.translation() = foot.point;
  return out;
}

}  // namespace

Posture standing_posture(const Standing& standing) {
  Posture out = to_posture(standing.at);
  const Vector3d ahead[2] = {standing.at.front.linear().col(0), standing.rear.linear().col(0)};
  for (int k = 0; k < kLegs; ++k) {
    const auto leg = static_cast<std::size_t>(k);
    out.stance.push_back({limb(k), contact_frame(standing.feet[leg], ahead[module_of(k)]), ""});
  }
  return out;
}

Step to_stop(const Ground& ground, const Standing& stop, State state, double cost) {
  const Vector3d at = ground.place(node_of(state));
  Step out;
  out.label = "stop on the way over " + shown_place(at);
  out.after = standing_posture(stop);
  out.placed = out.after.stance;
  out.attributes = {{"stop before node", std::to_string(node_of(state))}};
  out.cost = cost;
  return out;
}

Step to_step(const Ground& ground, State state, double cost) {
  const Standing& standing = ground.standing(state).standing;
  const Vector3d at = ground.place(node_of(state));
  const double friction = ground.critical_friction(state);
  const std::string place = shown_place(at);
  Step out;
  out.label = "over " + place + (ground.stable(state) ? "" : ", UNSTABLE");
  out.after = standing_posture(standing);
  out.placed = out.after.stance;
  out.attributes = {{"node", std::to_string(node_of(state))},
                    {"orientation", std::to_string(orientation_of(state))},
                    {"slope", shown("%.2f", std::acos(std::min(1.0, ground.normal(node_of(state)).z())) * 180.0 / M_PI) + " deg"},
                    {"critical friction", std::isfinite(friction) ? shown("%.4f", friction) : "none is enough"},
                    {"stable", ground.stable(state) ? "yes" : "no"}};
  out.cost = cost;
  return out;
}

}  // namespace foothold::octopod
