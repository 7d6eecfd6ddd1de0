// STL, OBJ and PLY give the terrain that they were written from; what is none is refused, whatever stands in the file.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>

#include "foothold/errors.hpp"
#include "terrains.hpp"

namespace foothold::terrain {
namespace {

std::string text(const Vector3d& v) {
  char out[100];
  std::snprintf(out, sizeof(out), "%.9g %.9g %.9g", v.x(), v.y(), v.z());
  return out;
}

std::string as_stl(const Terrain& terrain, double scale) {
  std::string out = "solid s\n";
  for (int t = 0; t < static_cast<int>(terrain.size()); ++t) {
    out += "facet normal 0 0 0\nouter loop\n";
    for (int k = 0; k < 3; ++k) out += "vertex " + text(scale * terrain.corner(t, k)) + "\n";
    out += "endloop\nendfacet\n";
  }
  return out + "endsolid s\n";
}

std::string as_obj(const Terrain& terrain) {
  std::string out;
  for (const Vector3d& v : terrain.vertices) out += "v " + text(v) + "\n";
  for (const auto& [a, b, c] : terrain.triangles)
    out += "f " + std::to_string(a + 1) + " " + std::to_string(b + 1) + " " + std::to_string(c + 1) + "\n";
  return out;
}

std::string as_ply(const Terrain& terrain) {
  std::string out = "ply\nformat ascii 1.0\nelement vertex " + std::to_string(terrain.vertices.size()) +
                    "\nproperty float x\nproperty float y\nproperty float z\nelement face " + std::to_string(terrain.size()) +
                    "\nproperty list uchar int vertex_indices\nend_header\n";
  for (const Vector3d& v : terrain.vertices) out += text(v) + "\n";
  for (const auto& [a, b, c] : terrain.triangles)
    out += "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
  return out;
}

// A file that is gone after the test.
struct File {
  File(const std::string& content, const std::string& ending)
      : path(testing::TempDir() + "foothold_terrain_" + std::to_string(getpid()) + "." + ending) {
    std::ofstream(path, std::ios::binary) << content;
  }
  ~File() { std::remove(path.c_str()); }
  std::string path;
};

TEST(TerrainMesh, IsTheSameInEveryFormat) {
  const Terrain wanted = ramps();
  for (const auto& [content, ending] : std::vector<std::pair<std::string, std::string>>{
           {as_stl(wanted, 1.0), "stl"}, {as_obj(wanted), "obj"}, {as_ply(wanted), "ply"}, {to_yaml(wanted), "yaml"}}) {
    const Terrain got = read_terrain(File(content, ending).path);
    ASSERT_EQ(got.size(), wanted.size()) << ending;
    EXPECT_EQ(got.vertices.size(), wanted.vertices.size()) << ending;
    EXPECT_EQ(got.adjacent, wanted.adjacent) << ending;
    for (int t = 0; t < 42; ++t) {
      EXPECT_LT((got.centroids[static_cast<std::size_t>(t)] - wanted.centroids[static_cast<std::size_t>(t)]).norm(), 1e-7)
          << ending;
      EXPECT_LT((got.normals[static_cast<std::size_t>(t)] - wanted.normals[static_cast<std::size_t>(t)]).norm(), 1e-6) << ending;
    }
  }
}

TEST(TerrainMesh, InMillimetresIsRefusedAndNeverScaled) {
  try {
    read_terrain(File(as_stl(ramps(), 1000.0), "stl").path);
    ADD_FAILURE();
  } catch (const InvalidScene& fault) {
    EXPECT_EQ(fault.field(), "vertices");
    EXPECT_NE(std::string(fault.what()).find("in mm?"), std::string::npos) << fault.what();
  }
}

TEST(TerrainMesh, RefusesFilesThatAreNone) {
  EXPECT_THROW(read_terrain("/nowhere/terrain.yaml"), InvalidScene);
  EXPECT_THROW(read_terrain("/nowhere/terrain.stl"), InvalidScene);
  EXPECT_THROW(read_terrain(File("v 0 0 0\n", "dae").path), InvalidScene);
  EXPECT_THROW(read_terrain(File("", "obj").path), InvalidScene);
}

// Whatever stands in the file: a terrain or a refusal.
TEST(TerrainMesh, SurvivesFilesThatAreCutOffOrChanged) {
  const Terrain terrain = ramps();
  std::mt19937_64 random(1);
  for (const auto& [content, ending] : std::vector<std::pair<std::string, std::string>>{
           {as_stl(terrain, 1.0), "stl"}, {as_obj(terrain), "obj"}, {as_ply(terrain), "ply"}, {to_yaml(terrain), "yaml"}})
    for (int round = 0; round < 60; ++round) {
      std::string changed = content;
      const std::size_t at = random() % changed.size();
      if (round % 2 == 0)
        changed.resize(at);
      else
        changed[at] = static_cast<char>(random());
      const File file(changed, ending);
      try {
        EXPECT_GT(read_terrain(file.path).size(), 0u);
      } catch (const InvalidScene& fault) {
        EXPECT_NE(std::string(fault.what()), "");
      }
    }
}

}  // namespace
}  // namespace foothold::terrain
