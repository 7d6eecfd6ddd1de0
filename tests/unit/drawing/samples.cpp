// Geometry by hand: nothing here plans.
#include "samples.hpp"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

namespace foothold::drawing::samples {
namespace {

using Eigen::Matrix3d;
using Eigen::Quaterniond;
using Eigen::Vector3d;

Vector3d eigen(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }
std::array<double, 3> array(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

msg::Vector3 message(const Vector3d& v) {
  msg::Vector3 m;
  m.x(v.x());
  m.y(v.y());
  m.z(v.z());
  return m;
}

msg::Pose pose_of(const Vector3d& at, const Matrix3d& turn) {
  const Quaterniond q(turn);
  msg::Pose p;
  p.position(message(at));
  p.orientation().w(q.w());
  p.orientation().x(q.x());
  p.orientation().y(q.y());
  p.orientation().z(q.z());
  return p;
}

msg::Summary summary(const std::string& robot, std::size_t steps) {
  msg::Summary s;
  s.robot(robot);
  s.steps(static_cast<std::uint32_t>(steps));
  s.cost(0.275e-3);
  s.lower_bound(0.275e-3);
  s.cost_unit("m");
  s.optimal(true);
  s.objective("least distance to the goal over all words of 7 cycles");
  s.plugin(robot);
  s.plugin_version("1.0.0");
  s.seed(7);
  return s;
}

Drawing finished(const std::string& robot, Drawing drawing) {
  drawing.robot = robot;
  drawing.state = msg::SUCCEEDED;
  drawing.summary = summary(robot, drawing.steps.size());
  return drawing;
}

}  // namespace

msg::Pose pose(double x, double y, double z, double yaw) {
  return pose_of({x, y, z}, Eigen::AngleAxisd(yaw, Vector3d::UnitZ()).toRotationMatrix());
}

msg::Pose pose_on(const std::array<double, 3>& at, const std::array<double, 3>& normal, const std::array<double, 3>& forward) {
  Matrix3d turn;
  turn.col(2) = eigen(normal).normalized();
  turn.col(1) = turn.col(2).cross(eigen(forward)).normalized();
  turn.col(0) = turn.col(1).cross(turn.col(2));
  return pose_of(eigen(at), turn);
}

msg::Shape box(const std::string& name, double x, double y, double z, double sx, double sy, double sz) {
  msg::Shape s;
  s.kind(msg::BOX);
  s.body(name);
  s.pose(pose(x, y, z));
  s.size(message({sx, sy, sz}));
  return s;
}

msg::Shape sphere(const std::string& name, double x, double y, double z, double radius) {
  msg::Shape s = box(name, x, y, z, radius, 0.0, 0.0);
  s.kind(msg::SPHERE);
  return s;
}

msg::Shape capsule(const std::string& name, const std::array<double, 3>& from, const std::array<double, 3>& to, double radius) {
  const Vector3d along = eigen(to) - eigen(from);
  msg::Shape s;
  s.kind(msg::CAPSULE);
  s.body(name);
  s.pose(pose_of((eigen(from) + eigen(to)) / 2.0, Quaterniond::FromTwoVectors(Vector3d::UnitZ(), along).toRotationMatrix()));
  s.size(message({radius, 0.0, along.norm()}));
  return s;
}

msg::Shape polygon(const std::string& name, const std::vector<std::array<double, 3>>& vertices) {
  msg::Shape s;
  s.kind(msg::POLYGON);
  s.body(name);
  s.pose(pose(0, 0, 0));
  for (const auto& v : vertices) s.vertices().push_back(message(eigen(v)));
  return s;
}

msg::Contact contact(const std::string& limb, const msg::Pose& frame, const std::string& face) {
  msg::Contact c;
  c.limb(limb);
  c.frame(frame);
  c.face(face);
  return c;
}

msg::Step step(std::uint32_t index, const msg::Pose& base) {
  msg::Step s;
  s.index(index);
  s.base(base);
  return s;
}

Drawing planar() {
  Drawing drawing;
  drawing.scene = {
      polygon("crate", {{0.05, 0.18, 0}, {0.16, 0.18, 0}, {0.16, 0.30, 0}, {0.05, 0.30, 0}}),
      polygon("corner", {{0.22, -0.02, 0}, {0.46, -0.02, 0}, {0.46, 0.20, 0}, {0.40, 0.20, 0}, {0.40, 0.05, 0}, {0.22, 0.05, 0}})};
  const auto rectangle = [](const std::string& name, double x, double y, double yaw, double half_x, double half_y) {
    const Eigen::Rotation2Dd turn(yaw);
    std::vector<std::array<double, 3>> corners;
    for (const auto& [a, b] : {std::pair{-half_x, -half_y}, {half_x, -half_y}, {half_x, half_y}, {-half_x, half_y}}) {
      const Eigen::Vector2d at = Eigen::Vector2d(x, y) + turn * Eigen::Vector2d(a, b);
      corners.push_back({at.x(), at.y(), 0.0});
    }
    return polygon(name, corners);
  };
  double x = 0.0, y = 0.0, yaw = 0.9;
  for (std::uint32_t i = 0; i < 12; ++i) {
    yaw += i % 4 == 1 ? -M_PI / 4 : i % 4 == 3 ? M_PI / 4 : 0.0;
    x += 0.046 * std::cos(yaw);
    y += 0.046 * std::sin(yaw);
    msg::Step s = step(i, pose(x, y, 0, yaw));
    s.placed({contact(i % 2 == 0 ? "B" : "A", pose(x, y, 0, yaw))});
    s.stance(s.placed());
    s.shapes({rectangle("A", x - 0.01 * std::cos(yaw), y - 0.01 * std::sin(yaw), yaw, 0.012, 0.055),
              rectangle("B", x + 0.02 * std::cos(yaw), y + 0.02 * std::sin(yaw), yaw + (i % 2) * M_PI / 4, 0.05, 0.01)});
    s.label("half cycle " + std::to_string(i));
    drawing.steps.push_back(s);
  }
  drawing.start.base({pose(0, 0, 0)});
  drawing.goal.base({pose(0.4, 0.4, 0)});
  return finished("planar", drawing);
}

Drawing biped(bool through) {
  Drawing drawing;
  // An upright beam and a level one that rests against it, both of 0.15 m square profile.
  drawing.scene = {box("level", 0.0, 0.0, 0.075, 2.0, 0.15, 0.15), box("upright", 0.325, 0.15, 0.5, 0.15, 0.15, 1.0)};
  constexpr double kSide = 0.25;  // of the upright's face towards -X
  struct Foot {
    std::array<double, 3> at, normal, forward;
    const char* face;
  };
  const std::vector<Foot> feet{{{-0.85, 0, 0.15}, {0, 0, 1}, {1, 0, 0}, "level.top"},
                               {{-0.6, 0, 0.15}, {0, 0, 1}, {1, 0, 0}, "level.top"},
                               {{-0.35, 0, 0.15}, {0, 0, 1}, {1, 0, 0}, "level.top"},
                               {{-0.1, 0, 0.15}, {0, 0, 1}, {1, 0.4, 0}, "level.top"},
                               {{kSide, 0.15, 0.45}, {-1, 0, 0}, {0, 0, 1}, "upright.left"},
                               {{kSide, 0.15, 0.6}, {-1, 0, 0}, {0, 0, 1}, "upright.left"},
                               {{kSide + 0.08, 0.225, 0.75}, {0, 1, 0}, {0, 0, 1}, "upright.back"}};
  const auto bodies = [](const Foot& a, const Foot& b, bool inside) {
    const auto above = [](const Foot& foot, double height) { return Vector3d(eigen(foot.at) + eigen(foot.normal) * height); };
    const Vector3d hip = (above(a, 0.28) + above(b, 0.28)) / 2.0 + (inside ? Vector3d(0.2, -0.1, -0.1) : Vector3d(0, 0, 0));
    std::vector<msg::Shape> shapes;
    for (const auto& [foot, name] : {std::pair{&a, std::string("A")}, std::pair{&b, std::string("B")}}) {
      msg::Shape plate = box(name + ".gripper", 0, 0, 0, 0.10, 0.10, 0.01);
      plate.pose(pose_on(array(above(*foot, 0.005)), foot->normal, foot->forward));
      const Vector3d ankle = above(*foot, 0.06);
      const Vector3d top = hip + (ankle - hip).normalized() * 0.05;
      shapes.push_back(plate);
      shapes.push_back(capsule(name + ".leg", array(ankle), array(top), 0.035));
    }
    shapes.push_back(box("hip", hip.x(), hip.y(), hip.z(), 0.18, 0.08, 0.03));
    return shapes;
  };
  for (std::uint32_t i = 0; i + 2 < feet.size(); ++i) {
    const Foot &held = feet[i + 1], &next = feet[i + 2];
    msg::Step s = step(i, pose_on(held.at, held.normal, held.forward));
    const auto foot_contact = [](const Foot& foot, bool left) {
      return contact(left ? "A" : "B", pose_on(foot.at, foot.normal, foot.forward), foot.face);
    };
    s.placed({foot_contact(next, i % 2 == 0)});
    s.stance({foot_contact(held, i % 2 != 0), foot_contact(next, i % 2 == 0)});
    s.shapes(bodies(held, next, through && i + 3 == feet.size()));
    drawing.steps.push_back(s);
  }
  drawing.start.contacts({contact("A", pose_on(feet[0].at, feet[0].normal, feet[0].forward)),
                          contact("B", pose_on(feet[1].at, feet[1].normal, feet[1].forward))});
  drawing.goal.contacts({contact("A", pose_on(feet.back().at, feet.back().normal, feet.back().forward))});
  return finished("biped", drawing);
}

Drawing tower() {
  Drawing drawing;
  const auto bar = [&](const std::string& name, const Vector3d& from, const Vector3d& to, double half) {
    const Vector3d along = (to - from).normalized();
    const Vector3d u =
        along.cross(Vector3d::UnitZ()).norm() > 0.1 ? along.cross(Vector3d::UnitZ()).normalized() : Vector3d::UnitX();
    const Vector3d v = along.cross(u);
    const auto corner = [&](const Vector3d& at, int k) {
      return array(at + half * ((k == 0 || k == 3 ? -1.0 : 1.0) * u + (k < 2 ? -1.0 : 1.0) * v));
    };
    for (int k = 0; k < 4; ++k)
      drawing.scene.push_back(polygon(name, {corner(from, k), corner(from, (k + 1) % 4), corner(to, (k + 1) % 4), corner(to, k)}));
    drawing.scene.push_back(polygon(name, {corner(from, 3), corner(from, 2), corner(from, 1), corner(from, 0)}));
    drawing.scene.push_back(polygon(name, {corner(to, 0), corner(to, 1), corner(to, 2), corner(to, 3)}));
  };
  const std::vector<Vector3d> feet{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const Vector3d bay(0, 0, 1.0);
  for (int level = 0; level < 3; ++level)
    for (std::size_t k = 0; k < 4; ++k) {
      const Vector3d low = feet[k] + level * bay, next = feet[(k + 1) % 4] + level * bay;
      bar("column", low, low + bay, 0.04);
      bar("ring", low + bay, next + bay, 0.03);
      bar("diagonal", low, next + bay, 0.02);
      bar("diagonal", next, low + bay, 0.02);
    }
  for (std::uint32_t i = 0; i < 4; ++i) {
    const double z = 0.4 + 0.5 * i;
    msg::Step s = step(i, pose(0.5, 0.5, z));
    const std::array<double, 3> foot{0.04, 0.3 + 0.1 * i, 1.0 + (i > 1 ? 1.0 : 0.0)};
    s.placed({contact(i % 2 == 0 ? "A" : "B", pose_on({foot[0] - 0.01, foot[1], foot[2]}, {1, 0, 0}, {0, 1, 0}), "ring")});
    s.stance(s.placed());
    s.shapes({box("body", 0.5, 0.5, z, 0.25, 0.25, 0.12), capsule("arm", {0.4, 0.5, z}, {foot[0] + 0.05, foot[1], foot[2]}, 0.03)});
    drawing.steps.push_back(s);
  }
  return finished("tower", drawing);
}

Drawing hexapod() {
  Drawing drawing;
  const auto height = [](double x, double y) {
    return 0.10 * std::sin(2.1 * x) * std::cos(1.7 * y) + 0.06 * x +
           0.12 * std::exp(-8 * ((x - 1) * (x - 1) + (y - 1.25) * (y - 1.25)));
  };
  constexpr int kCells = 24;
  constexpr double kCell = 2.0 / kCells;
  const auto corner = [&](int i, int k) { return std::array<double, 3>{i * kCell, k * kCell, height(i * kCell, k * kCell)}; };
  for (int i = 0; i < kCells; ++i)
    for (int k = 0; k < kCells; ++k) {
      drawing.scene.push_back(polygon("ground", {corner(i, k), corner(i + 1, k), corner(i + 1, k + 1)}));
      drawing.scene.push_back(polygon("ground", {corner(i, k), corner(i + 1, k + 1), corner(i, k + 1)}));
    }
  const auto foot_at = [&](double x, double y, double yaw, int leg) {
    const double angle = yaw + M_PI / 6 + leg * M_PI / 3;
    const double fx = x + 0.21 * std::cos(angle), fy = y + 0.21 * std::sin(angle);
    return Vector3d(fx, fy, height(fx, fy));
  };
  double x = 0.35, y = 0.35, yaw = 0.5;
  std::vector<Vector3d> feet;
  for (int leg = 0; leg < 6; ++leg) feet.push_back(foot_at(x, y, yaw, leg));
  for (std::uint32_t i = 0; i < 16; ++i) {
    x += 0.075 * std::cos(yaw);
    y += 0.075 * std::sin(yaw);
    yaw += 0.03;
    const double z = height(x, y) + 0.14;
    msg::Step s = step(i, pose(x, y, z, yaw));
    for (int leg = 0; leg < 6; ++leg) {
      const auto k = static_cast<std::size_t>(leg);
      const std::string name = "L" + std::to_string(leg + 1);
      const bool swings = leg % 2 == static_cast<int>(i % 2);
      if (swings) feet[k] = foot_at(x + 0.04 * std::cos(yaw), y + 0.04 * std::sin(yaw), yaw, leg);
      constexpr double h = 1e-4;
      const Vector3d slope(-(height(feet[k].x() + h, feet[k].y()) - feet[k].z()) / h,
                           -(height(feet[k].x(), feet[k].y() + h) - feet[k].z()) / h, 1.0);
      const msg::Contact c = contact(name, pose_on(array(feet[k]), array(slope), {1, 0, 0}), "ground");
      s.stance().push_back(c);
      if (swings) s.placed().push_back(c);
      const double angle = yaw + M_PI / 6 + leg * M_PI / 3;
      const Vector3d shoulder(x + 0.10 * std::cos(angle), y + 0.10 * std::sin(angle), z);
      const Vector3d knee = (shoulder + feet[k]) / 2.0 + Vector3d(0, 0, 0.08);
      s.shapes().push_back(capsule(name + ".femur", array(shoulder), array(knee), 0.012));
      s.shapes().push_back(capsule(name + ".tibia", array(knee), array(feet[k]), 0.009));
    }
    msg::Shape thorax = box("thorax", x, y, z, 0.2, 0.17, 0.04);
    thorax.pose(pose(x, y, z, yaw));
    s.shapes().push_back(thorax);
    drawing.steps.push_back(s);
  }
  drawing.start.base({pose(0.35, 0.35, height(0.35, 0.35) + 0.14)});
  drawing.goal.base({pose(x, y, height(x, y) + 0.14)});
  return finished("hexapod", drawing);
}

}  // namespace foothold::drawing::samples
