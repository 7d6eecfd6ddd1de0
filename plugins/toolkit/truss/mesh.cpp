// Triangles to faces.
#include "truss/truss.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include "geometry/triangulation.hpp"
#include "truss/merge_coplanar.hpp"

namespace foothold::truss {
namespace {

using mesh::TriangleMesh;

constexpr double kPlanar = 1e-6;          // m
constexpr std::size_t kFewCorners = 100;  // beyond, a face's triangles are its solids rather than pieces cut anew
constexpr double kStraight = 1e-7;        // m: corners this near to their neighbours' line are none

Vector3d area_of(const TriangleMesh& mesh, std::size_t k) {
  const auto& c = mesh.triangles[k];
  const auto at = [&](std::size_t i) { return mesh.vertices[static_cast<std::size_t>(c[i])]; };
  return 0.5 * (at(1) - at(0)).cross(at(2) - at(0));
}

// Which face each triangle belongs to; faces are grown from the greatest triangles and numbered by their first ones.
std::vector<int> grown_faces(const TriangleMesh& mesh) {
  const std::size_t count = mesh.triangles.size();
  std::vector<Vector3d> areas;
  for (std::size_t k = 0; k < count; ++k) areas.push_back(area_of(mesh, k));
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return areas[a].norm() > areas[b].norm(); });
  std::vector<int> face(count, -1);
  int faces = 0;
  for (const std::size_t seed : order) {
    if (face[seed] >= 0) continue;
    const Vector3d normal = areas[seed].normalized();
    const Vector3d& at = mesh.vertices[static_cast<std::size_t>(mesh.triangles[seed][0])];
    const auto in_plane = [&](std::size_t k) {
      return areas[k].dot(normal) > 0.0 && std::all_of(mesh.triangles[k].begin(), mesh.triangles[k].end(), [&](int v) {
               return std::abs(normal.dot(mesh.vertices[static_cast<std::size_t>(v)] - at)) <= kPlanar;
             });
    };
    std::vector<std::size_t> open{seed};
    face[seed] = faces;
    while (!open.empty()) {
      const std::size_t k = open.back();
      open.pop_back();
      for (const int n : mesh.neighbours[k])
        if (n >= 0 && face[static_cast<std::size_t>(n)] < 0 && in_plane(static_cast<std::size_t>(n))) {
          face[static_cast<std::size_t>(n)] = faces;
          open.push_back(static_cast<std::size_t>(n));
        }
    }
    ++faces;
  }
  std::vector<int> number(static_cast<std::size_t>(faces), -1);
  int next = 0;
  for (int& f : face) {
    if (number[static_cast<std::size_t>(f)] < 0) number[static_cast<std::size_t>(f)] = next++;
    f = number[static_cast<std::size_t>(f)];
  }
  return face;
}

Polygon without_straight_corners(Polygon polygon) {
  for (std::size_t k = 0; k < polygon.size() && polygon.size() > 3;) {
    const std::size_t n = polygon.size();
    if (geometry::distance(polygon[k], polygon[(k + n - 1) % n], polygon[(k + 1) % n]) <= kStraight)
      polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(k));
    else
      ++k;
  }
  return polygon;
}

// Closed ways along directed edges (from each vertex to its successors) that keep the face to their left.
std::vector<Polygon> loops(std::multimap<int, int> edges, const std::map<int, Vector2d>& at) {
  std::vector<Polygon> out;
  while (!edges.empty()) {
    const int first = edges.begin()->first;
    int before = first, here = edges.begin()->second;
    edges.erase(edges.begin());
    Polygon loop{at.at(first)};
    while (here != first) {
      loop.push_back(at.at(here));
      // Where several ways leave, the face's corner ends at the first one clockwise from where we came.
      const auto [begin, end] = edges.equal_range(here);
      auto best = begin;
      double least = INFINITY;
      const Vector2d back = at.at(before) - at.at(here);
      for (auto edge = begin; edge != end; ++edge) {
        const Vector2d way = at.at(edge->second) - at.at(here);
        double turn = std::atan2(way.x() * back.y() - way.y() * back.x(), way.dot(back));
        if (turn <= 0.0) turn += 2.0 * std::numbers::pi;
        if (turn < least) {
          least = turn;
          best = edge;
        }
      }
      before = here;
      here = best->second;
      edges.erase(best);
    }
    out.push_back(without_straight_corners(std::move(loop)));
  }
  return out;
}

struct Part {
  std::vector<std::size_t> triangles;
};

// One face of the mesh with its solids; in pieces only where it hangs together by single vertices.
void add_face(const TriangleMesh& mesh, const std::vector<int>& face_of, const Part& part, const std::string& name, Truss& truss) {
  Vector3d area = Vector3d::Zero(), centre = Vector3d::Zero();
  for (const std::size_t k : part.triangles) {
    area += area_of(mesh, k);
    for (const int v : mesh.triangles[k])
      centre += mesh.vertices[static_cast<std::size_t>(v)] / (3.0 * static_cast<double>(part.triangles.size()));
  }
  Face face;
  face.name = name;
  const Vector3d normal = area.normalized(), x = axis_in(normal);
  face.frame = Isometry3d::Identity();
  face.frame.linear() << x, normal.cross(x), normal;
  face.frame.translation() = centre;
  const Isometry3d into = face.frame.inverse();
  std::map<int, Vector2d> at;
  std::multimap<int, int> border;
  for (const std::size_t k : part.triangles)
    for (std::size_t c = 0; c < 3; ++c) {
      const int a = mesh.triangles[k][c], n = mesh.neighbours[k][c];
      at[a] = (into * mesh.vertices[static_cast<std::size_t>(a)]).head<2>();
      if (n < 0 || face_of[static_cast<std::size_t>(n)] != face_of[k]) border.emplace(a, mesh.triangles[k][(c + 1) % 3]);
    }
  std::vector<Polygon> outlines, holes;
  for (Polygon& loop : loops(std::move(border), at))
    (geometry::signed_area(loop) > 0.0 ? outlines : holes).push_back(std::move(loop));
  const auto add_solid = [&](Polygon piece) {
    truss.solids.push_back({name, Solid::Kind::kPolygon, face.frame, Vector3d::Zero(), std::move(piece)});
  };
  const bool simple = holes.empty() && std::all_of(outlines.begin(), outlines.end(),
                                                   [](const Polygon& outline) { return outline.size() <= kFewCorners; });
  if (simple)
    for (const Polygon& outline : outlines)
      for (Polygon& piece : geometry::convex_pieces(outline)) add_solid(std::move(piece));
  else
    for (const std::size_t k : part.triangles)
      add_solid({at.at(mesh.triangles[k][0]), at.at(mesh.triangles[k][1]), at.at(mesh.triangles[k][2])});
  for (std::size_t o = 0; o < outlines.size(); ++o) {
    Face piece = face;
    if (outlines.size() > 1) piece.name += "." + std::to_string(o + 1);
    for (const Polygon& hole : holes)
      if (outlines.size() == 1 || geometry::contains(std::span<const Vector2d>(outlines[o]), hole[0])) piece.holes.push_back(hole);
    piece.outline = std::move(outlines[o]);
    truss.faces.push_back(std::move(piece));
  }
}

}  // namespace

Truss merge_coplanar(const TriangleMesh& mesh) {
  const std::vector<int> face_of = grown_faces(mesh);
  std::vector<Part> parts(static_cast<std::size_t>(*std::max_element(face_of.begin(), face_of.end())) + 1);
  for (std::size_t k = 0; k < face_of.size(); ++k) parts[static_cast<std::size_t>(face_of[k])].triangles.push_back(k);
  Truss truss;
  for (std::size_t f = 0; f < parts.size(); ++f) add_face(mesh, face_of, parts[f], "face " + std::to_string(f + 1), truss);
  return truss;
}

Truss read_mesh(const std::string& path) { return merge_coplanar(mesh::read_triangles(path)); }

}  // namespace foothold::truss
