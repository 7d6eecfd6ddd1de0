// Closed-form collision of spheres, capsules, boxes and convex plane polygons. Metres; free functions of values; any thread.
#pragma once

#include <Eigen/Geometry>
#include <span>

namespace foothold::collision {

using Eigen::Isometry3d;
using Eigen::Vector3d;

struct Capsule {
  Vector3d a = Vector3d::Zero(), b = Vector3d::Zero();  // the axis' ends; equal: a sphere
  double radius = 0.0;
};

struct Box {
  Isometry3d pose = Isometry3d::Identity();  // centre and axes
  Vector3d half = Vector3d::Zero();          // half edges
};

// A convex plane polygon without thickness, vertices in order, in the world. Borrowed.
struct Patch {
  std::span<const Vector3d> vertices;
};

// Distances between the filled shapes: 0 if they touch or overlap; else the exact distance (error below 1e-9 m).
double distance(const Capsule& a, const Capsule& b);
double distance(const Capsule& a, const Box& b);
double distance(const Box& a, const Box& b);
double distance(const Capsule& a, const Patch& b);
double distance(const Box& a, const Patch& b);

// True if the shapes are nearer than `clearance` (m, >= 0). Faster than the distance.
bool nearer(const Capsule& a, const Capsule& b, double clearance);
bool nearer(const Capsule& a, const Box& b, double clearance);
bool nearer(const Box& a, const Box& b, double clearance);
bool nearer(const Capsule& a, const Patch& b, double clearance);
bool nearer(const Box& a, const Patch& b, double clearance);

}  // namespace foothold::collision
