// Terrain files: what they give, and that each fault is refused with its field and line.
#include <gtest/gtest.h>

#include "foothold/errors.hpp"
#include "terrain/terrain.hpp"

namespace foothold::terrain {
namespace {

// The vertices stand in line 2, the triangles in line 3.
std::string file(const std::string& vertices, const std::string& triangles) {
  return "kind: terrain\nvertices: " + vertices + "\ntriangles: " + triangles + "\n";
}
const std::string kSquare = "[[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]";
const std::string kHalves = "[[0, 1, 2], [0, 2, 3]]";

void expect_refused(const std::string& text, const std::string& field, const std::string& message) {
  try {
    parse_terrain(text);
    ADD_FAILURE() << "not refused: " << text;
  } catch (const InvalidScene& fault) {
    EXPECT_EQ(fault.field(), field) << text;
    EXPECT_EQ(std::string(fault.what()).substr(0, message.size()), message) << text;
  }
}

TEST(TerrainFile, GivesTrianglesThatFaceUp) {
  const Terrain terrain = parse_terrain(file(kSquare, kHalves));
  ASSERT_EQ(terrain.size(), 2u);
  for (std::size_t t = 0; t < 2; ++t) {
    EXPECT_EQ(terrain.normals[t], Vector3d::UnitZ());
    EXPECT_EQ(terrain.ground[t], 1);
    EXPECT_EQ(terrain.origins[t], static_cast<int>(t));
  }
  EXPECT_TRUE(terrain.centroids[0].isApprox(Vector3d(2.0 / 3.0, 1.0 / 3.0, 0.0)));
  EXPECT_EQ(std::vector<int>(terrain.neighbours(0).begin(), terrain.neighbours(0).end()), std::vector<int>{1});
  EXPECT_EQ(std::vector<int>(terrain.neighbours(1).begin(), terrain.neighbours(1).end()), std::vector<int>{0});
}

TEST(TerrainFile, TurnsAnOpenPartThatFacesDown) {
  const Terrain terrain = parse_terrain(file(kSquare, "[[0, 2, 1], [0, 3, 2]]"));
  EXPECT_EQ(terrain.normals[0], Vector3d::UnitZ());
  EXPECT_EQ(terrain.neighbours(0).size(), 1u);
}

// A solid, as CAD programs write it, either side out: its top is ground, its bottom and walls are not.
TEST(TerrainFile, TurnsASolidInsideOut) {
  const std::string corners = "[[0,0,0],[1,0,0],[1,1,0],[0,0,1]]";
  for (const std::string triangles : {"[[0,2,1],[0,1,3],[1,2,3],[2,0,3]]", "[[0,1,2],[0,3,1],[1,3,2],[2,3,0]]"}) {
    const Terrain terrain = parse_terrain(file(corners, triangles));
    EXPECT_EQ(terrain.normals[0], -Vector3d::UnitZ());
    EXPECT_EQ(terrain.ground, (std::vector<std::uint8_t>{0, 0, 1, 0}));
  }
}

TEST(TerrainFile, JoinsVerticesWithinAMicrometre) {
  const Terrain terrain =
      parse_terrain(file("[[0,0,0],[1,0,0],[1,1,0],[0,0,0.0000005],[1,1,0],[0,1,0]]", "[[0, 1, 2], [3, 4, 5]]"));
  EXPECT_EQ(terrain.vertices.size(), 4u);
  EXPECT_EQ(terrain.neighbours(0).size(), 1u);
}

TEST(TerrainFile, RefusesWhatIsNoTerrain) {
  expect_refused("kind: [", "", "line ");
  expect_refused("[]", "", "line 1: must be a map");
  expect_refused("vertices: []", "kind", "line 1: is missing");
  expect_refused("kind: truss", "kind", "line 1: must be terrain, is 'truss'");
  expect_refused("kind: terrain\nfaces: []", "faces", "line 2: is not a known key");
  expect_refused("kind: terrain", "vertices", "line 1: is missing");
  expect_refused("kind: terrain\nvertices: 3", "vertices", "line 2: must be a list");
  expect_refused(file("[]", kHalves), "vertices", "line 2: is empty");
  expect_refused("kind: terrain\nvertices: " + kSquare, "triangles", "line 1: is missing");
  expect_refused(file(kSquare, "[]"), "triangles", "line 3: is empty");
  expect_refused("kind: terrain\ndescription: []\nvertices: " + kSquare + "\ntriangles: " + kHalves, "description",
                 "line 2: must be a word");
}

TEST(TerrainFile, RefusesVerticesAndTrianglesWithTheFieldAtFault) {
  expect_refused(file("[[0, 0]]", kHalves), "vertices[0]", "line 2: must be [x, y, z] in m");
  expect_refused(file("[[0, 0, x]]", kHalves), "vertices[0][2]", "line 2: must be a number in m");
  expect_refused(file("[[0, 0, 0],\n [0, .nan, 0]]", kHalves), "vertices[1][1]", "line 3: must be finite");
  expect_refused(file("[[0, .inf, 0]]", kHalves), "vertices[0][1]", "line 2: must be finite");
  expect_refused(file(kSquare, "[[0, 1]]"), "triangles[0]", "line 3: must be the indices of three vertices");
  expect_refused(file(kSquare, "[[0, 1, 2],\n [0, 1, 4]]"), "triangles[1][2]",
                 "line 4: must be the index of one of the 4 vertices, is 4");
  expect_refused(file(kSquare, "[[0, 1, -1]]"), "triangles[0][2]", "line 3: must be the index of one of");
  expect_refused(file(kSquare, "[[0, 1, 1.5]]"), "triangles[0][2]", "line 3: must be the index of a vertex");
}

TEST(TerrainFile, RefusesWhatIsNoSoundSurface) {
  expect_refused(file(kSquare, "[[0, 1, 2],\n [0, 1, 1]]"), "triangles[1]", "line 4: is degenerate");
  expect_refused(file("[[0,0,0],[1,0,0],[2,0,0.0000001]]", "[[0, 1, 2]]"), "triangles[0]", "line 3: is degenerate");
  expect_refused(file("[[0,0,0],[1,0,0],[0,1,0],[0,0,1],[0,-1,0]]", "[[0, 1, 2],\n [1, 0, 3],\n [0, 1, 4]]"), "triangles[2]",
                 "line 5: shares an edge with triangles[0] and triangles[1]: an edge has two triangles at the most");
  expect_refused(file(kSquare, "[[0, 1, 2],\n [0, 3, 2]]"), "triangles[1]",
                 "line 4: and its neighbour triangles[0] disagree about the outer side");
  expect_refused(file("[[0,0,0],[0,1,0],[0,0,1]]", "[[0, 1, 2]]"), "triangles", "line 3: none faces up (z)");
}

TEST(TerrainFile, RefusesAnExtentThatSpeaksOfAnotherUnit) {
  expect_refused(file("[[0,0,0],[2000,0,0],[0,2000,0]]", "[[0, 1, 2]]"), "vertices",
                 "line 2: the terrain is 2e+03 m long, more than 1000 m: are its coordinates in mm?");
  expect_refused(file("[[0,0,0],[0.002,0,0],[0,0.002,0]]", "[[0, 1, 2]]"), "vertices",
                 "line 2: the terrain is 0.002 m long, less than 0.01 m: are its coordinates in km?");
}

TEST(TerrainFile, ReadsBackWhatIsWritten) {
  const Terrain terrain = parse_terrain(file("[[0,0,0],[1,0,0.1],[1,1,0.3333333333333333],[0,1,1e-5]]", kHalves));
  Terrain named = terrain;
  named.description = "a \"slope\"";
  const Terrain back = parse_terrain(to_yaml(named));
  EXPECT_EQ(back.description, named.description);
  EXPECT_EQ(back.vertices, terrain.vertices);
  EXPECT_EQ(back.triangles, terrain.triangles);
}

}  // namespace
}  // namespace foothold::terrain
