// Vertices that are one, triangles that share an edge.
#include "mesh/joining.hpp"

#include <algorithm>
#include <cmath>

#include "foothold/errors.hpp"

namespace foothold::mesh {
namespace {

constexpr double kCell = 64.0 * kSame;  // m: so that few vertices are near a cell's side

std::uint64_t hash(const std::array<std::int64_t, 3>& cell) {
  std::uint64_t out = 0;
  for (const std::int64_t c : cell) out = (out ^ static_cast<std::uint64_t>(c)) * 0x9E3779B97F4A7C15u + (out >> 29);
  return out;
}

std::array<std::int64_t, 3> cell_of(const Vector3d& v) {
  std::array<std::int64_t, 3> out;
  for (std::size_t k = 0; k < 3; ++k) out[k] = static_cast<std::int64_t>(std::floor(v[static_cast<Eigen::Index>(k)] / kCell));
  return out;
}

}  // namespace

int Welder::weld(const Vector3d& v) {
  const auto low = cell_of(v - Vector3d::Constant(kSame)), high = cell_of(v + Vector3d::Constant(kSame));
  for (std::int64_t x = low[0]; x <= high[0]; ++x)
    for (std::int64_t y = low[1]; y <= high[1]; ++y)
      for (std::int64_t z = low[2]; z <= high[2]; ++z) {
        const auto [begin, end] = cells_.equal_range(hash({x, y, z}));
        for (auto at = begin; at != end; ++at)
          if ((vertices_[static_cast<std::size_t>(at->second)] - v).norm() <= kSame) return at->second;
      }
  vertices_.push_back(v);
  cells_.emplace(hash(cell_of(v)), static_cast<int>(vertices_.size()) - 1);
  return static_cast<int>(vertices_.size()) - 1;
}

void demand_height(const TriangleMesh& mesh, std::size_t k) {
  const auto& corner = mesh.triangles[k];
  const auto at = [&](std::size_t c) { return mesh.vertices[static_cast<std::size_t>(corner[c % 3])]; };
  const double area = (at(1) - at(0)).cross(at(2) - at(0)).norm();
  double longest = 0.0;
  for (std::size_t c = 0; c < 3; ++c) longest = std::max(longest, (at(c + 1) - at(c)).norm());
  if (!(area > kLeastHeight * longest)) throw InvalidScene(triangle(k), "is degenerate: its corners lie on one line within 1e-6 m");
}

void find_neighbours(TriangleMesh& mesh) {
  struct Side {
    int low, high;  // vertices
    std::uint32_t triangle, corner;
  };
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::uint32_t k = 0; k < mesh.triangles.size(); ++k)
    for (std::uint32_t c = 0; c < 3; ++c) {
      const int a = mesh.triangles[k][c], b = mesh.triangles[k][(c + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), k, c});
    }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return a.low != b.low ? a.low < b.low : a.high != b.high ? a.high < b.high : a.triangle < b.triangle;
  });
  mesh.neighbours.assign(mesh.triangles.size(), {-1, -1, -1});
  for (std::size_t first = 0, end = 0; first < sides.size(); first = end) {
    while (end < sides.size() && sides[end].low == sides[first].low && sides[end].high == sides[first].high) ++end;
    if (end - first == 1) continue;
    const Side &s = sides[first], &t = sides[first + 1];
    if (end - first > 2)
      throw InvalidScene(triangle(sides[first + 2].triangle), "shares an edge with " + triangle(s.triangle) + " and " +
                                                                  triangle(t.triangle) + ": an edge has two triangles at the most");
    if (mesh.triangles[s.triangle][s.corner] == mesh.triangles[t.triangle][t.corner])
      throw InvalidScene(triangle(t.triangle),
                         "and its neighbour " + triangle(s.triangle) +
                             " disagree about the outer side: they run along their common edge in the same direction");
    mesh.neighbours[s.triangle][s.corner] = static_cast<int>(t.triangle);
    mesh.neighbours[t.triangle][t.corner] = static_cast<int>(s.triangle);
  }
}

TriangleMesh joined(const std::vector<Vector3d>& vertices, const std::vector<std::array<int, 3>>& triangles) {
  TriangleMesh out;
  Welder welder(out.vertices);
  std::vector<int> number;
  number.reserve(vertices.size());
  for (const Vector3d& v : vertices) number.push_back(welder.weld(v));
  const auto at = [&](int v) { return number[static_cast<std::size_t>(v)]; };
  for (const auto& [a, b, c] : triangles) {
    out.triangles.push_back({at(a), at(b), at(c)});
    demand_height(out, out.triangles.size() - 1);
  }
  find_neighbours(out);
  return out;
}

}  // namespace foothold::mesh
