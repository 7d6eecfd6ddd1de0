#include "ground.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "foothold/robot_file.hpp"

namespace foothold::hyrecro {
namespace {

double nearest(const truss::Solid& solid, const auto& body) {
  if (solid.kind == truss::Solid::Kind::kBox) return collision::distance(body, collision::Box{solid.pose, solid.half});
  std::vector<Vector3d> vertices;
  for (const Vector2d& vertex : solid.polygon) vertices.push_back(solid.pose * Vector3d(vertex.x(), vertex.y(), 0.0));
  return collision::distance(body, collision::Patch{vertices});
}

// Corners inside, and none of the face's own corners within the plate.
bool lies_on(const truss::Face& face, const Foothold& foothold) {
  const Eigen::Rotation2Dd turn(foothold.heading);
  const Vector2d half = 0.5 * robot().plate.head<2>();
  Polygon plate;
  for (const Vector2d& sign : {Vector2d(-1, -1), Vector2d(1, -1), Vector2d(1, 1), Vector2d(-1, 1)})
    plate.push_back(foothold.at + turn * half.cwiseProduct(sign));
  std::vector<Polygon> rings{face.outline};
  rings.insert(rings.end(), face.holes.begin(), face.holes.end());
  for (std::size_t r = 0; r < rings.size(); ++r)
    for (const Vector2d& corner : plate) {
      double off = 1.0;
      for (std::size_t k = 0; k < rings[r].size(); ++k)
        off = std::min(off, geometry::distance(corner, rings[r][k], rings[r][(k + 1) % rings[r].size()]));
      if (off > 1e-9 && geometry::contains(rings[r], corner) != (r == 0)) return false;
    }
  for (const Polygon& ring : rings)
    for (const Vector2d& vertex : ring) {
      const Vector2d seen = (turn.inverse() * (vertex - foothold.at)).cwiseAbs();
      if ((half - seen).minCoeff() > 1e-9) return false;
    }
  return true;
}

}  // namespace

const Model& robot() {
  static const Model model = Model::from_model(load_robot_model(FOOTHOLD_CONFIG_DIR "/robots/hyrecro.yaml"));
  return model;
}

std::shared_ptr<const PlanarWorkspace> shared_workspace() {
  static const auto workspace =
      std::make_shared<const PlanarWorkspace>(*PlanarWorkspace::make(robot(), 0.01, std::numbers::pi / 36.0, kClearance));
  return workspace;
}

std::unique_ptr<PreparedTruss> prepared(truss::Truss truss, double step) {
  SamplingOptions options;
  options.step = step;
  auto scene = std::make_unique<PreparedTruss>(robot(), std::move(truss), options, kClearance);
  scene->workspace = shared_workspace();
  return scene;
}

std::unique_ptr<PreparedTruss> prepared(const std::string& text, double step) { return prepared(truss::parse_truss(text), step); }

std::unique_ptr<PreparedTruss> shipped(const std::string& name) {
  return prepared(truss::read_truss(FOOTHOLD_CONFIG_DIR "/scenes/" + name + ".yaml"));
}

int face_named(const PreparedTruss& scene, const std::string& name) {
  for (std::size_t k = 0; k < scene.truss.faces.size(); ++k)
    if (scene.truss.faces[k].name == name) return static_cast<int>(k);
  return -1;
}

Foothold stand(const PreparedTruss& scene, const Vector3d& at, const Vector3d& normal, const Vector3d& forward) {
  Isometry3d pose = Isometry3d::Identity();
  pose.linear() << forward, normal.cross(forward), normal;
  pose.translation() = at;
  const std::optional<Foothold> found = foothold_at(scene.truss, pose, 1e-6);
  EXPECT_TRUE(found) << "no face at " << at.transpose();
  return found.value_or(Foothold{});
}

void expect_stands(const PreparedTruss& scene, const Route& route) {
  Foothold holding = route.start;
  for (std::size_t k = 0; k < route.strides.size(); ++k) {
    const Stride& stride = route.strides[k];
    EXPECT_TRUE(within_limits(robot(), stride.coordinates)) << k;
    const Isometry3d base = pose_of(scene.truss, holding), reached = base * forward(robot(), stride.coordinates);
    const Isometry3d wanted = pose_of(scene.truss, stride.to);
    EXPECT_LT((reached.translation() - wanted.translation()).norm(), 1e-6) << k;
    EXPECT_LT(Eigen::AngleAxisd(reached.linear().transpose() * wanted.linear()).angle(), 1e-6) << k;
    EXPECT_TRUE(lies_on(scene.truss.faces[static_cast<std::size_t>(stride.to.face)], stride.to)) << k;
    const Bodies bodies = bodies_at(robot(), stride.coordinates, base);
    EXPECT_GE(self_distance(bodies), kClearance - 1e-9) << k;
    for (const truss::Solid& solid : scene.truss.solids) {
      for (const collision::Capsule& leg : bodies.leg) EXPECT_GE(nearest(solid, leg), kClearance - 1e-9) << k << " " << solid.name;
      EXPECT_GE(nearest(solid, bodies.hip), kClearance - 1e-9) << k << " " << solid.name;
      for (const collision::Box& plate : bodies.plate) EXPECT_GT(nearest(solid, plate), 0.0) << k << " " << solid.name;
    }
    holding = stride.to;
  }
}

std::size_t transitions_of(const Route& route) {
  std::size_t count = 0;
  int face = route.start.face;
  for (const Stride& stride : route.strides) {
    count += stride.to.face != face;
    face = stride.to.face;
  }
  return count;
}

}  // namespace foothold::hyrecro
