#include "walk.hpp"

#include <cmath>
#include <numbers>

namespace foothold::hyrecro {
namespace {

constexpr double kLifted = 0.021;  // m

Level mixed(const Level& a, const Level& b, double part) {
  Level out;
  for (std::size_t j = 0; j < 2; ++j) {
    out.shift[j] = a.shift[j] + part * (b.shift[j] - a.shift[j]);
    out.height[j] = a.height[j] + part * (b.height[j] - a.height[j]);
    out.hip[j] = a.hip[j] + part * (b.hip[j] - a.hip[j]);
  }
  return out;
}

Level lifted(Level level, double by) {
  level.height[1] -= by;
  return level;
}

Posture posture(const Model& model, Foot holds, const Isometry3d& held, const Level& level) {
  const Coordinates c = coordinates_of(model, level);
  Posture out;
  out.joints = to_joints(model, c, holds);
  out.base = held * frames(model, c).hip;
  if (holds == Foot::kB) out.base = out.base * Eigen::AngleAxisd(std::numbers::pi, Vector3d::UnitZ());
  out.stance = {{name_of(holds), held, "floor/top"}, {name_of(other(holds)), held * forward(model, c), "floor/top"}};
  return out;
}

}  // namespace

truss::Truss floor_scene() {
  truss::Truss out;
  add_box(out, "floor", {0.0, 0.0, -0.1}, {1.5, 1.5, 0.1});
  truss::Face face;
  face.name = "floor/top";
  face.solid = 0;
  face.frame = Isometry3d::Identity();
  face.outline = {{-1.5, -1.5}, {1.5, -1.5}, {1.5, 1.5}, {-1.5, 1.5}};
  out.faces.push_back(face);
  return out;
}

void add_box(truss::Truss& truss, const std::string& name, const Vector3d& centre, const Vector3d& half) {
  truss::Solid solid;
  solid.name = name;
  solid.pose.translation() = centre;
  solid.half = half;
  truss.solids.push_back(solid);
}

Coordinates coordinates_of(const Model& model, const Level& level) {
  Coordinates out;
  for (std::size_t j = 0; j < 2; ++j) {
    // The mechanisms turn about -Y: a positive angle leans the leg towards -X.
    const double phi = -std::atan2(level.shift[j], level.height[j]);
    const double y = 0.5 * (std::hypot(level.shift[j], level.height[j]) + model.core);
    out.leg[j] = {phi, y, -phi, y};
  }
  out.hip = level.hip;
  return out;
}

bool possible(const Model& model, const Level& level) { return within_limits(model, coordinates_of(model, level), -1e-6); }

Walk walk(const Model& model, Foot holds, const Isometry3d& held, const Level& from, const Level& to, int pieces) {
  std::vector<Level> levels;
  constexpr int kRungs = 21;
  for (int k = 0; k <= kRungs; ++k) levels.push_back(lifted(from, kLifted * k / kRungs));
  for (int k = 1; k < pieces; ++k) levels.push_back(lifted(mixed(from, to, static_cast<double>(k) / pieces), kLifted));
  for (int k = kRungs; k >= 0; --k) levels.push_back(lifted(to, kLifted * k / kRungs));

  Walk out;
  out.before = posture(model, holds, held, from);
  out.step.after = posture(model, holds, held, to);
  out.step.placed = {out.step.after.stance[1]};
  for (const Level& level : levels) {
    const Posture at = posture(model, holds, held, level);
    out.step.motion.push_back({0.0, at.base, at.joints});
  }
  // The hips' wrapped angles, without leaps.
  for (std::size_t k = 1; k < out.step.motion.size(); ++k)
    for (const std::size_t hip : {8u, 9u}) {
      double& now = out.step.motion[k].joints[hip];
      const double last = out.step.motion[k - 1].joints[hip];
      now = last + std::remainder(now - last, 2.0 * std::numbers::pi);
    }
  double time = 0.0;
  for (std::size_t k = 1; k < out.step.motion.size(); ++k) {
    double needed = 1e-3;
    for (std::size_t j = 0; j < kJoints; ++j)
      needed = std::max(needed, std::fabs(out.step.motion[k].joints[j] - out.step.motion[k - 1].joints[j]) /
                                    (j < 8 ? model.actuator_speed : model.hip_speed));
    out.step.motion[k].time = time += needed;
  }
  return out;
}

Level Levels::level() {
  for (;;) {
    Level out;
    const double height = uniform(0.24, 0.33);
    for (std::size_t j = 0; j < 2; ++j)
      out.shift[j] = uniform(-0.15, 0.15), out.height[j] = height, out.hip[j] = uniform(-1.2, 1.2);
    if (possible(model_, out) && possible(model_, lifted(out, kLifted))) return out;
  }
}

Isometry3d Levels::foothold() {
  Isometry3d out = Isometry3d::Identity();
  out.translate(Vector3d(uniform(-0.5, 0.5), uniform(-0.5, 0.5), 0.0));
  out.rotate(Eigen::AngleAxisd(uniform(-3.0, 3.0), Vector3d::UnitZ()));
  return out;
}

std::string CheckOfWalks::reason_after(const std::function<void(Walk&)>& change) const {
  Walk changed = right_;
  change(changed);
  const StepVerdict is = verdict(changed);
  return is.accepted ? "accepted" : is.reason;
}

void CheckOfWalks::expect_reason(const char* part, const std::function<void(Walk&)>& change) const {
  const std::string reason = reason_after(change);
  EXPECT_NE(reason.find(part), std::string::npos) << "expected '" << part << "', got: " << reason;
}

}  // namespace foothold::hyrecro
