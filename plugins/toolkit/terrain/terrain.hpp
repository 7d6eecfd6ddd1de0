// Rough terrain as triangles, for robots that walk on it: read from files, checked, cut finer.
//
//   kind: terrain
//   description: a step                     # for people; may be left out
//   vertices: [[0, 0, 0], [1, 0, 0], ...]   # m; z is up
//   triangles: [[0, 1, 2], ...]             # indices of vertices, from 0
//
// or STL, OBJ, PLY in metres, z up. Nothing is scaled: a file in millimetres is refused, since it is too large.
//
// What is ground. Neighbours must agree about their outer side (refused otherwise). Each connected part is then turned as a whole:
// a part with a border so that its area seen from above is positive, a closed one so that its volume is. Triangles whose normal
// points upwards (z > kLeastUp) are ground; vertical and downward ones (walls, overhangs, the bottom of a solid) are obstacles:
// they bound where bodies may be, but no foot and no node of a search is ever put on them.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.hpp"

namespace foothold::terrain {

using Eigen::Vector3d;

inline constexpr double kLeastUp = 1e-6;           // z of a ground triangle's unit normal, at least
inline constexpr double kLeastExtent = 0.01;       // m: the longest side of the bounds of any terrain, at least
inline constexpr double kGreatestExtent = 1000.0;  // m: and at most

// Immutable after making; vectors of triangles are in the same order.
struct Terrain {
  std::string description;
  std::vector<Vector3d> vertices;             // m
  std::vector<std::array<int, 3>> triangles;  // corners, counter-clockwise seen from outside (ground: from above)
  std::vector<Vector3d> normals;              // unit, outwards (ground: upwards)
  std::vector<Vector3d> centroids;            // m
  std::vector<std::uint8_t> ground;           // 1: feet may stand on it; 0: an obstacle
  std::vector<int> origins;                   // of which triangle of the file it is a part
  std::vector<int> adjacent;                  // by triangle: those that share an edge, or a part of one, with it; ascending
  std::vector<std::uint32_t> adjacent_begin;  // where a triangle's begin in `adjacent`; one more than triangles

  std::size_t size() const { return triangles.size(); }
  // Three at most for a terrain as read or cut by the longest side; more where midpoint subdivision left a coarse triangle beside
  // finer ones. A border has none.
  std::span<const int> neighbours(int triangle) const {
    const auto t = static_cast<std::size_t>(triangle);
    return std::span<const int>(adjacent).subspan(adjacent_begin[t], adjacent_begin[t + 1] - adjacent_begin[t]);
  }
  const Vector3d& corner(int triangle, int k) const {
    return vertices[static_cast<std::size_t>(triangles[static_cast<std::size_t>(triangle)][static_cast<std::size_t>(k)])];
  }
};

// By the ending of the file's name: .yaml as above, .stl, .obj, .ply. Vertices nearer than 1e-6 m are one. Throws InvalidScene,
// whose field is such as "triangles[3]" (of a yaml file, the message begins with the line), for files that cannot be read, unknown
// keys, numbers that are not finite, bounds longer than kGreatestExtent or shorter than kLeastExtent (a wrong unit), degenerate
// triangles (a height below 1e-6 m), indices out of range, edges of more than two triangles, neighbours that disagree about the
// outer side, no ground at all, more than a million triangles. Any thread.
Terrain read_terrain(const std::string& path);
// `text` is what a yaml file would hold.
Terrain parse_terrain(const std::string& text);
// Turns, normals, ground, adjacency and the checks of the extent. Throws InvalidScene as above.
Terrain make_terrain(mesh::TriangleMesh mesh, std::string description = "");
// What parse_terrain() reads back as the same terrain (numbers read back exactly).
std::string to_yaml(const Terrain& terrain);

// The paper proposes, for slivers, to part the longest side in N and join the parts to the opposite corner; halves, again and again
// at what is then the longest side, never bring the least angle below half of what it was.
enum class Split : std::uint8_t {
  kMidpoint,     // the paper's: 1 -> 4 by the midpoints of the sides, each triangle for itself
  kSlivers,      // the same, but triangles whose longest side is more than kSliver times their height are halved at that side
  kLongestSide,  // Rivara 1984: halves at the longest side, neighbours first where theirs is longer; no vertex hangs on a side
};
inline constexpr double kSliver = 4.0;
inline constexpr double kLeastBound = 1e-3;  // m

// Cuts each triangle until its circumradius (m) is below `bound`. The surface, its borders and its ground stay what they are;
// pieces of a triangle come in its place, in its order. Midpoint pieces of neighbours may differ in size: a vertex then hangs on a
// coarser triangle's side, and neighbours() tells all the finer ones across it. Throws std::invalid_argument for bounds below
// kLeastBound; InvalidScene if more than `most` triangles would come out, or a midpoint piece is too thin a sliver for the bound.
// Any thread. (Molla-Santamaria et al. 2023, section 3.)
Terrain subdivide(const Terrain& terrain, double bound, Split split = Split::kMidpoint, std::size_t most = 1000000);

double circumradius(const Terrain& terrain, int triangle);  // m
double slope(const Terrain& terrain, int triangle);         // rad, 0 level to pi upside down

}  // namespace foothold::terrain
