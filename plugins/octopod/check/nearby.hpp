// The judge's own view of the terrain: the triangles round a robot, and distances from them, one by one and without a tree; and
// distances between the robot's own parts.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "terrain/terrain.hpp"

namespace foothold::octopod {

using Eigen::Isometry3d;
using Eigen::Vector3d;

struct Triangle {
  std::array<Vector3d, 3> corners;     // m
  Vector3d normal = Vector3d::Zero();  // unit, outwards, from the corners
  Eigen::AlignedBox3d bounds;          // m
  bool ground = false;
};

// Triangles whose bounds touch `region`, from the terrain's corners alone.
std::vector<Triangle> triangles_in(const terrain::Terrain& terrain, const Eigen::AlignedBox3d& region);

double distance(const Vector3d& point, const Triangle& triangle);                 // m
double distance(const Vector3d& a, const Vector3d& b, const Triangle& triangle);  // m, from the segment; 0 where it meets it
double distance(const Isometry3d& box, const Vector3d& half,
                const Triangle& triangle);  // m, from the filled box; 0 where they meet

double distance(const Vector3d& a, const Vector3d& b, const Vector3d& c, const Vector3d& d);  // m, between segments a-b and c-d
// m, from the filled box to the segment, and between filled boxes; 0 where they meet.
double distance(const Isometry3d& box, const Vector3d& half, const Vector3d& a, const Vector3d& b);
double distance(const Isometry3d& a, const Vector3d& half_a, const Isometry3d& b, const Vector3d& half_b);

}  // namespace foothold::octopod
