// Pair by pair: segments, and boxes by their edges.
#include "octopod/check/itself.hpp"

#include <algorithm>
#include <cmath>

namespace foothold::octopod {
namespace {

constexpr double kLook = 0.1;       // m: farther away than that nothing matters
constexpr double kRounding = 1e-9;  // m

int leg_of(int body) { return (body - 4) / 2; }
// Bodies and necks: 0 or 1; femurs and tibiae: their leg's.
int module_of_body(int body) { return body < 4 ? body % 2 : module_of(leg_of(body)); }
bool is_femur(int body) { return body >= 4 && body % 2 == 0; }

// a < b.
bool hang_together(int a, int b) {
  if (a < 4 && b >= 4) return is_femur(b) && module_of_body(a) == module_of_body(b);
  if (a >= 4) return leg_of(a) == leg_of(b);
  return (a >= 2 && b >= 2) || (a < 2 && b == a + 2);
}

struct Rod {
  Vector3d from, to;
  double radius = 0.0;
};

Rod rod_of(const Model& model, const Skeleton& at, int body) {
  if (body < 4) {
    const Isometry3d& module = at.module[static_cast<std::size_t>(body - 2)];
    return {module * Vector3d((body == 2 ? -0.5 : 0.5) * model.body.x(), 0.0, 0.0), at.joint, model.neck_radius};
  }
  const Skeleton::Limb& limb = at.limbs[static_cast<std::size_t>(leg_of(body))];
  if (is_femur(body)) return {limb.hip, limb.knee, model.leg_radius};
  return {limb.knee, limb.foot, model.leg_radius};
}

// No point of a body is farther from its middle than that.
std::pair<Vector3d, double> ball_of(const Model& model, const Skeleton& at, int body) {
  if (body < 2) return {at.module[static_cast<std::size_t>(body)].translation(), 0.5 * model.body.norm()};
  const Rod rod = rod_of(model, at, body);
  return {0.5 * (rod.from + rod.to), 0.5 * (rod.to - rod.from).norm() + rod.radius};
}

}  // namespace

const std::array<Parts, kPairs>& parts_apart() {
  static const std::array<Parts, kPairs> all = [] {
    std::array<Parts, kPairs> out;
    std::size_t count = 0;
    for (int a = 0; a < kBodies; ++a)
      for (int b = a + 1; b < kBodies; ++b)
        if (!hang_together(a, b)) out.at(count++) = {a, b};
    return out;
  }();
  return all;
}

double parts_distance(const Model& model, const Skeleton& at, const Parts& parts, double reach) {
  const auto [middle_a, radius_a] = ball_of(model, at, parts.a);
  const auto [middle_b, radius_b] = ball_of(model, at, parts.b);
  if ((middle_a - middle_b).norm() - radius_a - radius_b >= reach) return reach;
  const Vector3d half = 0.5 * model.body;
  if (parts.b < 2) return std::min(reach, distance(at.module[0], half, at.module[1], half));
  const Rod b = rod_of(model, at, parts.b);
  if (parts.a < 2) {
    const double away = distance(at.module[static_cast<std::size_t>(parts.a)], half, b.from, b.to);
    return std::clamp(away - b.radius, 0.0, reach);
  }
  const Rod a = rod_of(model, at, parts.a);
  return std::clamp(distance(a.from, a.to, b.from, b.to) - a.radius - b.radius, 0.0, reach);
}

double judge_apart(const Setting& setting, const Skeleton& at, const std::string& where) {
  double least = kLook;
  for (const Parts& parts : parts_apart()) {
    const double away = parts_distance(setting.model, at, parts, kLook);
    if (!(away > 0.0)) refuse(where, ": ", body_name(parts.a), " touches ", body_name(parts.b));
    if (!(away >= setting.options.clearance - kRounding))
      refuse(where, ": ", body_name(parts.a), " is ", away, " m from ", body_name(parts.b), ", ", setting.options.clearance,
             " m must be kept");
    least = std::min(least, away);
  }
  return least;
}

}  // namespace foothold::octopod
