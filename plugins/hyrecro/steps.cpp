// Steps of strides.
#include "hyrecro/steps.hpp"

#include <cstdio>
#include <numbers>

namespace foothold::hyrecro {
namespace {

std::string shown(const char* form, double value) {
  char text[32];
  std::snprintf(text, sizeof text, form, value == 0.0 ? 0.0 : value);
  return text;
}

const std::string& face_name(const truss::Truss& truss, const Foothold& at) {
  return truss.faces[static_cast<std::size_t>(at.face)].name;
}

double in_degrees(double angle) { return std::remainder(angle, 2.0 * std::numbers::pi) * 180.0 / std::numbers::pi; }

}  // namespace

Change change_of(const truss::Truss& truss, const Foothold& from, const Foothold& to) {
  if (from.face == to.face) return Change::kNone;
  const Isometry3d a = pose_of(truss, from), b = pose_of(truss, to);
  const double in_front = a.linear().col(2).dot(b.translation() - a.translation());
  // Two faces in one plane: neither.
  if (a.linear().col(2).dot(b.linear().col(2)) > 1.0 - 1e-9) return Change::kNone;
  return in_front > 0.0 ? Change::kConcave : Change::kConvex;
}

const char* name_of(Change change) {
  switch (change) {
    case Change::kConvex:
      return "convex";
    case Change::kConcave:
      return "concave";
    case Change::kNone:
      break;
  }
  return "none";
}

Contact to_contact(const truss::Truss& truss, const Grip& grip) {
  return {name_of(grip.foot), pose_of(truss, grip.at), face_name(truss, grip.at)};
}

Step to_step(const Model& model, const truss::Truss& truss, const Grip& holding, const Stride& stride, double cost) {
  const Grip placed{other(holding.foot), stride.to};
  const Isometry3d sole = pose_of(truss, holding.at);
  const Change change = change_of(truss, holding.at, stride.to);
  const std::string& face = face_name(truss, stride.to);
  Step out;
  out.label = std::string(name_of(placed.foot)) + " to " + face;
  if (change != Change::kNone) out.label += std::string(", ") + name_of(change) + " transition";
  out.placed = {to_contact(truss, placed)};
  out.after = posture_of(model, stride.coordinates, holding.foot, sole);
  out.after.stance = {to_contact(truss, holding), out.placed.front()};
  if (holding.foot == Foot::kB) std::swap(out.after.stance[0], out.after.stance[1]);
  out.attributes = {{"face", face},
                    {"place", "(" + shown("%.3f", stride.to.at.x()) + ", " + shown("%.3f", stride.to.at.y()) + ") m, " +
                                  shown("%.1f", in_degrees(stride.to.heading)) + " deg"},
                    {"transition", name_of(change)}};
  out.cost = cost;
  return out;
}

void add_motion(const Model& model, const truss::Truss& truss, const Grip& holding, const Motion& motion,
                const std::vector<double>& before, Step& step) {
  const Isometry3d sole = pose_of(truss, holding.at);
  std::vector<std::vector<double>> rows = joint_rows(model, motion, holding.foot, before);
  for (std::size_t k = 0; k < motion.points.size(); ++k)
    step.motion.push_back({motion.times[k], base_of(model, motion.points[k], holding.foot, sole), std::move(rows[k])});
  step.after.base = step.motion.back().base;
  step.after.joints = step.motion.back().joints;
}

}  // namespace foothold::hyrecro
