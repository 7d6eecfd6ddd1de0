// Simple polygons in the plane and the distances between them. Metres; free functions of values; any thread.
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

namespace foothold::geometry {

using Eigen::Vector2d;

// Vertices in order, the first not repeated. Simple and counter-clockwise unless said otherwise.
using Polygon = std::vector<Vector2d>;

double signed_area(std::span<const Vector2d> polygon);  // m^2, positive: counter-clockwise
double distance(const Vector2d& point, const Vector2d& a, const Vector2d& b);
// 0 if the segments touch.
double distance(const Vector2d& a, const Vector2d& b, const Vector2d& c, const Vector2d& d);
bool contains(std::span<const Vector2d> polygon, const Vector2d& point);  // on the edge: either
// Between the filled polygons; 0 if they touch or one holds the other.
double distance(std::span<const Vector2d> a, std::span<const Vector2d> b);
// Between a filled polygon and a segment.
double distance(std::span<const Vector2d> polygon, const Vector2d& a, const Vector2d& b);
// Between a filled polygon and a point.
double distance(std::span<const Vector2d> polygon, const Vector2d& point);

// Two edges that touch though they are not neighbours, or neighbours that fold back: the index of the later one's first vertex.
std::optional<std::size_t> first_crossing(std::span<const Vector2d> polygon);

// A circle round all vertices: centre of the bounding box and the greatest distance from it.
struct Circle {
  Vector2d centre = Vector2d::Zero();
  double radius = 0.0;
};
Circle circle_round(std::span<const Vector2d> points);

}  // namespace foothold::geometry
