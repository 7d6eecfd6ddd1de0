// Meshes: a box gives a beam's faces in every format, and what is no sound surface is refused.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <fstream>

#include "foothold/errors.hpp"
#include "geometry/region.hpp"
#include "truss/layout.hpp"
#include "truss/merge_coplanar.hpp"

namespace foothold::truss {
namespace {

using Triangle = std::array<Vector3d, 3>;

std::string text(const Vector3d& v) {
  char out[100];
  std::snprintf(out, sizeof(out), "%.9g %.9g %.9g", v.x(), v.y(), v.z());
  return out;
}

std::string as_stl(const std::vector<Triangle>& triangles) {
  std::string out = "solid s\n";
  for (const Triangle& t : triangles) {
    out += "facet normal 0 0 0\nouter loop\n";
    for (const Vector3d& v : t) out += "vertex " + text(v) + "\n";
    out += "endloop\nendfacet\n";
  }
  return out + "endsolid s\n";
}

std::string as_obj(const std::vector<Triangle>& triangles) {
  std::string out;
  for (const Triangle& t : triangles)
    for (const Vector3d& v : t) out += "v " + text(v) + "\n";
  for (std::size_t k = 0; k < triangles.size(); ++k)
    out += "f " + std::to_string(3 * k + 1) + " " + std::to_string(3 * k + 2) + " " + std::to_string(3 * k + 3) + "\n";
  return out;
}

std::string as_ply(const std::vector<Triangle>& triangles) {
  std::string out = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(3 * triangles.size()) +
                    "\nproperty float x\nproperty float y\nproperty float z\nelement face " + std::to_string(triangles.size()) +
                    "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Triangle& t : triangles)
    for (const Vector3d& v : t) out += text(v) + "\n";
  for (std::size_t k = 0; k < triangles.size(); ++k)
    out += "3 " + std::to_string(3 * k) + " " + std::to_string(3 * k + 1) + " " + std::to_string(3 * k + 2) + "\n";
  return out;
}

// A file that is gone after the test.
struct MeshFile {
  MeshFile(const std::string& content, const std::string& ending)
      : path(testing::TempDir() + "foothold_mesh_" + std::to_string(getpid()) + "." + ending) {
    std::ofstream(path, std::ios::binary) << content;
  }
  ~MeshFile() { std::remove(path.c_str()); }
  std::string path;
};

// Each face of the truss without holes as a fan of `cuts` x `cuts` rectangles.
std::vector<Triangle> triangles_of(const Truss& truss, int cuts) {
  std::vector<Triangle> out;
  for (const Face& face : truss.faces) {
    const Vector2d origin = face.outline[0], x = (face.outline[1] - origin) / cuts, y = (face.outline[3] - origin) / cuts;
    const auto at = [&](int i, int j) -> Vector3d {
      const Vector2d p = origin + i * x + j * y;
      return face.frame * Vector3d(p.x(), p.y(), 0.0);
    };
    for (int i = 0; i < cuts; ++i)
      for (int j = 0; j < cuts; ++j) {
        out.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        out.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
  }
  return out;
}

const Truss kBeam = build({"", {{"b", {0.1, 0.2, 0.3}, {1.0, 1.2, 0.9}, 0.15, 0.2, {0, 0, 1}}}, {}});

void expect_beam(const Truss& mesh) {
  ASSERT_EQ(mesh.faces.size(), 6u);
  for (std::size_t f = 0; f < 6; ++f) {
    const Face &got = mesh.faces[f], &wanted = kBeam.faces[f];  // in the order of their first triangles
    EXPECT_TRUE(got.frame.linear().col(2).isApprox(wanted.frame.linear().col(2), 1e-6));
    ASSERT_EQ(got.outline.size(), 4u);
    EXPECT_TRUE(got.holes.empty());
    EXPECT_NEAR(geometry::signed_area(got.outline), geometry::signed_area(wanted.outline), 1e-6);
    for (const Vector2d& v : got.outline) {
      const Vector3d local = wanted.frame.inverse() * (got.frame * Vector3d(v.x(), v.y(), 0.0));
      double nearest = 1e9;
      for (const Vector2d& w : wanted.outline) nearest = std::min(nearest, (local - Vector3d(w.x(), w.y(), 0.0)).norm());
      EXPECT_LT(nearest, 1e-6);
    }
  }
  ASSERT_EQ(mesh.solids.size(), 6u);  // one convex piece each
  for (const Solid& solid : mesh.solids) EXPECT_EQ(solid.kind, Solid::Kind::kPolygon);
}

TEST(Mesh, OfABoxHasTheBeamsFacesInEveryFormat) {
  const std::vector<Triangle> triangles = triangles_of(kBeam, 1);
  expect_beam(read_mesh(MeshFile(as_stl(triangles), "stl").path));
  expect_beam(read_mesh(MeshFile(as_obj(triangles), "obj").path));
  expect_beam(read_mesh(MeshFile(as_ply(triangles), "ply").path));
}

TEST(Mesh, IsTheSameAfterOneThatWasRefused) {
  const std::string good = as_stl(triangles_of(kBeam, 1)), bad = "ply\nformat ascii 1.0\nelement vertex 1\nend_header\n0\n";
  expect_beam(merge_coplanar(mesh::parse_triangles(good, "stl")));
  EXPECT_THROW(mesh::parse_triangles(bad, "ply"), InvalidScene);
  EXPECT_THROW(mesh::parse_triangles("", "obj"), InvalidScene);
  expect_beam(merge_coplanar(mesh::parse_triangles(good, "stl")));
}

TEST(Mesh, OfAFinelyCutBoxHasTheBeamsFaces) { expect_beam(read_mesh(MeshFile(as_stl(triangles_of(kBeam, 5)), "STL").path)); }

TEST(Mesh, KeepsTheHolesOfAFace) {
  // A square of 3 x 3 fields without the one in the middle.
  std::vector<Triangle> triangles;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      if (i == 1 && j == 1) continue;
      triangles.push_back({Vector3d(i, j, 0), Vector3d(i + 1, j, 0), Vector3d(i + 1, j + 1, 0)});
      triangles.push_back({Vector3d(i, j, 0), Vector3d(i + 1, j + 1, 0), Vector3d(i, j + 1, 0)});
    }
  const Truss truss = read_mesh(MeshFile(as_obj(triangles), "obj").path);
  ASSERT_EQ(truss.faces.size(), 1u);
  EXPECT_EQ(truss.faces[0].outline.size(), 4u);
  ASSERT_EQ(truss.faces[0].holes.size(), 1u);
  EXPECT_NEAR(geometry::signed_area(truss.faces[0].holes[0]), -1.0, 1e-9);
  double area = 0.0;
  for (const Solid& solid : truss.solids) area += geometry::signed_area(solid.polygon);
  EXPECT_NEAR(area, 8.0, 1e-6);
}

TEST(Mesh, PartsFacesThatMeetInOneVertex) {
  // Two fields of a chess board: no edge in common.
  std::vector<Triangle> triangles;
  for (int i = 0; i < 2; ++i) {
    triangles.push_back({Vector3d(i, i, 0), Vector3d(i + 1, i, 0), Vector3d(i + 1, i + 1, 0)});
    triangles.push_back({Vector3d(i, i, 0), Vector3d(i + 1, i + 1, 0), Vector3d(i, i + 1, 0)});
  }
  const Truss truss = read_mesh(MeshFile(as_stl(triangles), "stl").path);
  ASSERT_EQ(truss.faces.size(), 2u);
  for (const Face& face : truss.faces) EXPECT_NEAR(geometry::signed_area(face.outline), 1.0, 1e-6);
}

TEST(Mesh, DoesNotMergeFacesThatAreAlmostCoplanar) {
  const double lift = 1e-5;
  const Truss truss = read_mesh(MeshFile(as_obj({{Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(0, 1, 0)},
                                                 {Vector3d(1, 0, 0), Vector3d(1, 1, lift), Vector3d(0, 1, 0)}}),
                                         "obj")
                                    .path);
  EXPECT_EQ(truss.faces.size(), 2u);
}

void expect_refused(const std::string& content, const std::string& ending, const std::string& field, const std::string& message) {
  const MeshFile file(content, ending);
  try {
    read_mesh(file.path);
    ADD_FAILURE() << "not refused: " << message;
  } catch (const InvalidScene& fault) {
    EXPECT_EQ(fault.field(), field);
    EXPECT_NE(std::string(fault.what()).find(message), std::string::npos) << fault.what();
  }
}

TEST(Mesh, RefusesWhatIsNoSoundSurface) {
  const Vector3d a(0, 0, 0), b(1, 0, 0), c(0, 1, 0), d(0, 0, 1), e(0, -1, 0);
  expect_refused(as_obj({{a, b, c}, {a, b, Vector3d(2, 0, 0)}}), "obj", "triangles[1]", "is degenerate");
  expect_refused(as_obj({{a, b, c}, {a, b, a}}), "obj", "triangles[1]", "is degenerate");
  expect_refused(as_obj({{a, b, c}, {b, a, d}, {a, b, e}}), "obj", "triangles[2]", "an edge has two triangles at the most");
  expect_refused(as_obj({{a, b, c}, {a, b, d}}), "obj", "triangles[1]", "disagree about the outer side");
  expect_refused(as_obj({{a, b, Vector3d(0, 20000, 0)}}), "obj", "triangles[0]", "beyond 10000 m");
  std::string circle, corners = "f";
  for (int k = 0; k <= 1000; ++k) {
    circle += "v " + text(Vector3d(100.0 * std::cos(k * 6.28 / 1001), 100.0 * std::sin(k * 6.28 / 1001), 0.0)) + "\n";
    corners += " " + std::to_string(k + 1);
  }
  expect_refused(circle + corners + "\n", "obj", "triangles[0]", "more than 1000 corners");
  expect_refused("nothing", "obj", "", "");
  expect_refused("", "stl", "", "");
  expect_refused("v 0 0 0\n", "dae", "", "a mesh is a file .stl, .obj or .ply, is 'dae'");
  EXPECT_THROW(read_mesh("/nowhere/mesh.stl"), InvalidScene);
}

// Whatever stands in the file: faces or a refusal.
TEST(Mesh, SurvivesFilesThatAreCutOffOrChanged) {
  const std::vector<Triangle> triangles = triangles_of(kBeam, 1);
  std::uint64_t state = 1;
  for (const auto& [content, ending] : std::vector<std::pair<std::string, std::string>>{
           {as_stl(triangles), "stl"}, {as_obj(triangles), "obj"}, {as_ply(triangles), "ply"}})
    for (int round = 0; round < 60; ++round) {
      std::string changed = content;
      state = state * 6364136223846793005u + 1442695040888963407u;
      const std::size_t at = (state >> 33) % changed.size();
      if (round % 2 == 0)
        changed.resize(at);
      else
        changed[at] = static_cast<char>(state >> 25);
      const MeshFile file(changed, ending);
      try {
        EXPECT_FALSE(read_mesh(file.path).faces.empty());
      } catch (const InvalidScene& fault) {
        EXPECT_NE(std::string(fault.what()), "");
      }
    }
}

}  // namespace
}  // namespace foothold::truss
