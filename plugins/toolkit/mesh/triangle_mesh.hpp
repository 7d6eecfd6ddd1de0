// Triangles with shared vertices, as mesh files hold them after all that does not matter here is left out.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <string>
#include <vector>

namespace foothold::mesh {

using Eigen::Vector3d;

inline constexpr double kSame = 1e-6;         // m: vertices this near are one
inline constexpr double kLeastHeight = 1e-6;  // m, of a triangle
inline constexpr std::size_t kMostTriangles = 1000000;

struct TriangleMesh {
  std::vector<Vector3d> vertices;              // m
  std::vector<std::array<int, 3>> triangles;   // counter-clockwise seen from outside
  std::vector<std::array<int, 3>> neighbours;  // across the edge from corner k to k + 1; -1: none
};

// STL, OBJ or PLY; the format by the ending of the file's name. Throws InvalidScene for files that cannot be read, no or
// too many triangles (a million), numbers that are not finite or beyond 10 km, degenerate triangles (a height below 1e-6 m), edges
// of more than two triangles, neighbours whose outer sides disagree. Any thread.
TriangleMesh read_triangles(const std::string& path);
// `octets` is what a file of that format (stl, obj or ply) would hold.
TriangleMesh parse_triangles(const std::string& octets, const std::string& format);

// The same checks for triangles from elsewhere: vertices nearer than kSame become one, neighbours are found. Indices must be in
// range.
TriangleMesh joined(const std::vector<Vector3d>& vertices, const std::vector<std::array<int, 3>>& triangles);

}  // namespace foothold::mesh
