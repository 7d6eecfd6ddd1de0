#include "hexpiderix/ground.hpp"

#include <Eigen/Eigenvalues>
#include <utility>

namespace foothold::hexpiderix {

Ground::Ground(terrain::Terrain terrain) : terrain_(std::move(terrain)), surface_(terrain_) {}

std::vector<Shape> Ground::shapes() const {
  std::vector<Shape> out;
  out.reserve(terrain_.size());
  for (int t = 0; t < static_cast<int>(terrain_.size()); ++t) {
    Shape piece{Shape::Kind::kPolygon, "terrain", Isometry3d::Identity(), Vector3d::Zero(), {}};
    for (int k = 0; k < 3; ++k) piece.vertices.push_back(terrain_.corner(t, k));
    out.push_back(std::move(piece));
  }
  return out;
}

std::optional<Footing> footing(const terrain::Surface& surface, const Vector3d& place, const Vector3d& down, double reach) {
  const auto hit = surface.ray(place - reach * down, down, 2.0 * reach);
  if (!hit || !surface.terrain().ground[static_cast<std::size_t>(hit->triangle)]) return std::nullopt;
  return Footing{hit->point, surface.terrain().normals[static_cast<std::size_t>(hit->triangle)]};
}

Plane plane_through(const Footholds& footholds) {
  Vector3d mean = Vector3d::Zero();
  const auto count = static_cast<double>(footholds.supports.count());
  for (std::size_t leg = 0; leg < kLegs; ++leg)
    if (footholds.supports[leg]) mean += footholds.points[leg] / count;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (std::size_t leg = 0; leg < kLegs; ++leg) {
    if (!footholds.supports[leg]) continue;
    const Vector3d from = footholds.points[leg] - mean;
    spread += from * from.transpose();
  }
  const Vector3d normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
  return {mean, normal.z() < 0.0 ? Vector3d(-normal) : normal};
}

}  // namespace foothold::hexpiderix
