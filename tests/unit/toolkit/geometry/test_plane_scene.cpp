// Plane scenes: what is refused, and with which field.
#include <gtest/gtest.h>

#include "foothold/errors.hpp"
#include "geometry/plane_scene.hpp"

namespace foothold::geometry {
namespace {

std::string with_polygon(const std::string& polygon) {
  return "kind: plane\nobstacles:\n  - {name: first, polygon: [[0, 0], [1, 0], [0, 1]]}\n  - name: second\n    polygon: " +
         polygon + "\n";
}

struct Refused {
  std::string field;
  std::string message;
};

Refused refused(const std::string& text) {
  try {
    parse_plane_scene(text);
  } catch (const InvalidScene& fault) {
    return {fault.field(), fault.what()};
  }
  return {"accepted", ""};
}

TEST(PlaneScene, ReadsNamedPolygonsCounterClockwise) {
  const PlaneScene scene = parse_plane_scene(
      "kind: plane\ndescription: two\nobstacles:\n"
      "  - {name: a, polygon: [[0, 0], [1, 0], [1, 1]]}\n"
      "  - {name: b, polygon: [[2, 2], [2, 3], [3, 3]]}\n");
  EXPECT_EQ(scene.description, "two");
  ASSERT_EQ(scene.obstacles.size(), 2u);
  EXPECT_EQ(scene.obstacles[1].name, "b");
  for (const Obstacle& obstacle : scene.obstacles) EXPECT_GT(signed_area(obstacle.polygon), 0.0);
  EXPECT_TRUE(parse_plane_scene("kind: plane\nobstacles: []\n").obstacles.empty());
}

TEST(PlaneScene, RefusesEveryBadPolygonByItsPath) {
  EXPECT_EQ(refused(with_polygon("[[0, 0], [1, 0], [1, .nan]]")).field, "obstacles[1].polygon[2][1]");
  EXPECT_EQ(refused(with_polygon("[[0, 0], [1, 0], [.inf, 1]]")).field, "obstacles[1].polygon[2][0]");
  EXPECT_EQ(refused(with_polygon("[[0, 0], [1, 0], [1, 2e4]]")).field, "obstacles[1].polygon[2][1]");
  EXPECT_EQ(refused(with_polygon("[[0, 0], [1, x], [1, 1]]")).field, "obstacles[1].polygon[1][1]");
  EXPECT_EQ(refused(with_polygon("[[0, 0], [1, 0]]")).field, "obstacles[1].polygon");
  EXPECT_EQ(refused(with_polygon("[[0, 0], [1, 0, 0], [1, 1]]")).field, "obstacles[1].polygon[1]");
  EXPECT_EQ(refused(with_polygon("[[0, 0], [1, 0], [1, 0], [1, 1]]")).field, "obstacles[1].polygon[2]");
  EXPECT_EQ(refused(with_polygon("[[0, 0], [1, 0], [1, 1], [0, 0]]")).field, "obstacles[1].polygon[3]");
  EXPECT_EQ(refused(with_polygon("[[0, 0], [1, 1], [2, 2]]")).field, "obstacles[1].polygon");
  EXPECT_EQ(refused(with_polygon("[[0, 0], [2, 2], [2, 0], [0, 2.5]]")).field, "obstacles[1].polygon[2]");
  EXPECT_EQ(refused(with_polygon("round")).field, "obstacles[1].polygon");
}

TEST(PlaneScene, RefusesWhatItDoesNotKnow) {
  EXPECT_EQ(refused("kind: truss\nobstacles: []\n").field, "kind");
  EXPECT_EQ(refused("obstacles: []\n").field, "kind");
  EXPECT_EQ(refused("kind: plane\n").field, "obstacles");
  EXPECT_EQ(refused("kind: plane\nobstacles: 3\n").field, "obstacles");
  EXPECT_EQ(refused("kind: plane\nwalls: []\nobstacles: []\n").field, "walls");
  EXPECT_EQ(refused("kind: plane\nobstacles: []\nkind: plane\n").field, "kind");
  EXPECT_EQ(refused("kind: plane\nobstacles: [{polygon: [[0, 0], [1, 0], [1, 1]]}]\n").field, "obstacles[0].name");
  EXPECT_EQ(refused("kind: plane\nobstacles: [{name: '', polygon: [[0, 0], [1, 0], [1, 1]]}]\n").field, "obstacles[0].name");
  EXPECT_EQ(refused("kind: plane\nobstacles: [{name: a}]\n").field, "obstacles[0].polygon");
  EXPECT_EQ(refused("kind: plane\nobstacles: [{name: a, polygon: [[0, 0], [1, 0], [1, 1]], depth: 2}]\n").field,
            "obstacles[0].depth");
  EXPECT_EQ(refused(with_polygon("[[0, 0], [1, 0], [1, 1]]\n  - {name: first, polygon: [[0, 0], [1, 0], [1, 1]]}")).field,
            "obstacles[2].name");
  EXPECT_EQ(refused("[]\n").field, "");
  EXPECT_EQ(refused("kind: [plane\n").field, "");
}

TEST(PlaneScene, TakesHeightsAboveTheGroundOnly) {
  const std::string obstacle = "kind: plane\nobstacles: [{name: a, polygon: [[0, 0], [1, 0], [1, 1]]";
  EXPECT_FALSE(parse_plane_scene(obstacle + "}]\n").obstacles[0].height);
  EXPECT_EQ(parse_plane_scene(obstacle + ", height: 0.02}]\n").obstacles[0].height, 0.02);
  for (const char* height : {"0", "-1", "high", ".inf"})
    EXPECT_EQ(refused(obstacle + ", height: " + height + "}]\n").field, "obstacles[0].height") << height;
}

TEST(PlaneScene, NamesTheLine) {
  EXPECT_EQ(refused(with_polygon("[[0, 0], [1, 0]]")).message.substr(0, 7), "line 5:");
  EXPECT_EQ(refused("kind: truss\nobstacles: []\n").message.substr(0, 7), "line 1:");
}

TEST(PlaneScene, SaysThatAFileCannotBeRead) { EXPECT_THROW(read_plane_scene("/nowhere/scene.yaml"), InvalidScene); }

}  // namespace
}  // namespace foothold::geometry
