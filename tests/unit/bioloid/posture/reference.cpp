// The figures from their definitions.
#include "reference.hpp"

#include <algorithm>
#include <limits>

#include "contact/support_polygon.hpp"

namespace foothold::bioloid::testing {
namespace {

using collision::Box;

std::vector<std::pair<std::size_t, Box>> boxes_of(const Model& model, const Joints& joints, const Isometry3d& torso) {
  const auto frames = body_frames(model, joints);
  std::vector<std::pair<std::size_t, Box>> out;
  for (std::size_t b = 0; b < kBodies; ++b)
    for (const BodyBox& box : model.bodies[b].boxes)
      out.push_back({b, {torso * frames[b] * Eigen::Translation3d(box.centre), box.half}});
  return out;
}

Box box_of(const Prism& prism) {
  const auto& p = prism.polygon;
  const Eigen::Vector2d along = p[1] - p[0], across = p[3] - p[0];
  Box out;
  out.pose.translate(Vector3d(0.5 * (p[0].x() + p[2].x()), 0.5 * (p[0].y() + p[2].y()), 0.5 * prism.height));
  out.pose.rotate(Eigen::AngleAxisd(std::atan2(along.y(), along.x()), Vector3d::UnitZ()));
  out.half = 0.5 * Vector3d(along.norm(), across.norm(), prism.height);
  return out;
}

double lowest(const Box& box) {
  return box.pose.translation().z() - (box.pose.linear().transpose() * Vector3d::UnitZ()).cwiseAbs().dot(box.half);
}

}  // namespace

Figures figures(const Model& model, const Joints& joints, const Support& support, const std::vector<Prism>& prisms) {
  const Isometry3d torso = sole_in_torso(model, support.foot, joints).inverse();  // in the support sole's frame
  const Isometry3d swing = torso * sole_in_torso(model, other(support.foot), joints);
  const auto bodies = boxes_of(model, joints, torso);
  Figures out;
  out.within_limits = within_limits(model, joints);
  out.self = out.obstacles = out.bodies = out.sole = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const auto& [body, box] = bodies[i];
    for (std::size_t j = i + 1; j < bodies.size(); ++j)
      if (!model.neighbours(body, bodies[j].first)) out.self = std::min(out.self, collision::distance(box, bodies[j].second));
    if (body <= leg_joint(Side::kLeft, 3) + 1) out.bodies = std::min(out.bodies, lowest(box));
    for (const Prism& prism : prisms)
      out.obstacles = std::min(out.obstacles, collision::distance(Box{support.at * box.pose, box.half}, box_of(prism)));
  }
  std::vector<Vector3d> contacts;
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5}) {
      const Vector3d corner(x * model.sole_length, y * model.sole_width, 0.0);
      contacts.push_back(corner);
      if (support.both) contacts.push_back(support.second * corner);
      out.sole = std::min(out.sole, (swing * corner).z());
    }
  out.balance = contact::projected_margin(contact::support_polygon(contacts), torso * centre_of_mass(model, joints));
  if (support.both) {
    const double turn = Eigen::AngleAxisd(support.second.linear().transpose() * swing.linear()).angle();
    out.slip = std::max((swing.translation() - support.second.translation()).norm(), turn);
  }
  return out;
}

double room(const Figures& f, const Demands& demands, bool both) {
  double least = std::min(
      {f.self - demands.clearance, f.obstacles - demands.clearance, f.bodies - demands.clearance, f.balance - demands.balance});
  least = std::min(least, both ? demands.slip - f.slip : f.sole + demands.ground);
  return f.within_limits ? least : -1.0;
}

std::optional<Joints> standing(const Model& model, Side support, const Isometry3d& pelvis, const Isometry3d& second) {
  Joints joints = model.carrying;
  if (!reach(model, support, pelvis.inverse(), joints) || !reach(model, other(support), pelvis.inverse() * second, joints))
    return {};
  return within_limits(model, joints) ? std::optional(joints) : std::nullopt;
}

Isometry3d pose(double x, double y, double z, double yaw, double pitch, double roll) {
  Isometry3d out = Isometry3d::Identity();
  out.translate(Vector3d(x, y, z));
  out.rotate(Eigen::AngleAxisd(yaw, Vector3d::UnitZ()) * Eigen::AngleAxisd(pitch, Vector3d::UnitY()) *
             Eigen::AngleAxisd(roll, Vector3d::UnitX()));
  return out;
}

Joints walking(const Model& model, Side support, Draw& draw, double wild) {
  const double side = support == Side::kRight ? 1.0 : -1.0;  // towards the other foot
  for (;;) {
    const double w = wild * 0.6;
    const Isometry3d pelvis =
        pose(draw(-0.01, 0.03), side * draw(-0.015, 0.02), draw(0.188, 0.204), draw(-w, w), draw(-w, w), draw(-w, w));
    const Isometry3d second = pose(draw(-0.06, 0.06), side * draw(0.065 - 0.02 * wild, 0.1), draw(0.0, 0.02 + 0.03 * wild),
                                   draw(-w, w), 0.5 * draw(-w, w), 0.5 * draw(-w, w));
    if (const auto found = standing(model, support, pelvis, second)) return *found;
  }
}

}  // namespace foothold::bioloid::testing
