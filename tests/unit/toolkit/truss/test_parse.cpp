// Truss files: what they give, and that each fault is refused with its field and line.
#include <gtest/gtest.h>

#include "foothold/errors.hpp"
#include "truss/layout.hpp"

namespace foothold::truss {
namespace {

// Line 2 is the item's.
std::string with_beam(const std::string& item) { return "kind: truss\nbeams: [" + item + "]\n"; }
std::string with_face(const std::string& item) { return "kind: truss\nfaces: [" + item + "]\n"; }
const std::string kBeam = "{name: b, from: [0, 0, 0], to: [2, 0, 0], profile: {width: 0.2, height: 0.1}}";
const std::string kFace = "{name: f, polygon: [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], normal: [0, 0, 1]}";

struct Refusal {
  std::string text, field, message;
};

void expect_refused(const Refusal& refusal) {
  try {
    parse_truss(refusal.text);
    ADD_FAILURE() << "not refused: " << refusal.text;
  } catch (const InvalidScene& fault) {
    EXPECT_EQ(fault.field(), refusal.field) << refusal.text;
    EXPECT_EQ(std::string(fault.what()).substr(0, refusal.message.size()), refusal.message) << refusal.text;
  }
}

TEST(TrussFile, GivesABeamItsSixFacesAndItsBox) {
  const Truss truss = parse_truss(with_beam(kBeam));
  ASSERT_EQ(truss.solids.size(), 1u);
  EXPECT_TRUE(truss.solids[0].half.isApprox(Vector3d(1.0, 0.1, 0.05)));
  EXPECT_TRUE(truss.solids[0].pose.translation().isApprox(Vector3d(1.0, 0.0, 0.0)));
  const std::vector<std::pair<std::string, Vector3d>> sides{{"b/top", {0, 0, 1}},    {"b/bottom", {0, 0, -1}},
                                                            {"b/left", {0, 1, 0}},   {"b/right", {0, -1, 0}},
                                                            {"b/begin", {-1, 0, 0}}, {"b/end", {1, 0, 0}}};
  ASSERT_EQ(truss.faces.size(), sides.size());
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const Face& face = truss.faces[k];
    EXPECT_EQ(face.name, sides[k].first);
    EXPECT_EQ(face.solid, 0);
    EXPECT_TRUE(face.frame.linear().col(2).isApprox(sides[k].second, 1e-12)) << face.name;
    EXPECT_NEAR(face.frame.linear().determinant(), 1.0, 1e-12);
    EXPECT_GT(geometry::signed_area(face.outline), 0.0);
    for (const Vector2d& v : face.outline) {
      const Vector3d local = truss.solids[0].pose.inverse() * (face.frame * Vector3d(v.x(), v.y(), 0.0));
      EXPECT_TRUE(local.cwiseAbs().isApprox(truss.solids[0].half, 1e-12)) << face.name;
    }
  }
}

TEST(TrussFile, GivesAFaceCounterClockwiseSeenAgainstItsNormal) {
  const Truss truss =
      parse_truss(with_face("{name: f, polygon: [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], normal: [0, 0, -1]}"));
  ASSERT_EQ(truss.faces.size(), 1u);
  EXPECT_TRUE(truss.faces[0].frame.linear().col(2).isApprox(-Vector3d::UnitZ()));
  EXPECT_NEAR(geometry::signed_area(truss.faces[0].outline), 1.0, 1e-12);
  EXPECT_EQ(truss.faces[0].solid, -1);
  ASSERT_EQ(truss.solids.size(), 1u);
  EXPECT_EQ(truss.solids[0].kind, Solid::Kind::kPolygon);
}

TEST(TrussFile, CutsAFaceThatIsNotConvexIntoConvexSolids) {
  const Truss truss = parse_truss(
      with_face("{name: f, polygon: [[0, 0, 0], [2, 0, 0], [2, 1, 0], [1, 1, 0], [1, 2, 0], [0, 2, 0]], normal: [0, 0, 1]}"));
  double area = 0.0;
  for (const Solid& solid : truss.solids) area += geometry::signed_area(solid.polygon);
  EXPECT_NEAR(area, 3.0, 1e-12);
  EXPECT_GT(truss.solids.size(), 1u);
}

TEST(TrussFile, RefusesWhatIsNoTruss) {
  expect_refused({"kind: [", "", "line "});
  expect_refused({"[]", "", "line 1: must be a map"});
  expect_refused({"beams: []", "kind", "line 1: is missing"});
  expect_refused({"kind: plane", "kind", "line 1: must be truss, is 'plane'"});
  expect_refused({"kind: truss\nbeam: []", "beam", "line 2: is not a known key"});
  expect_refused({"kind: truss\nkind: truss", "kind", "line 2: is given twice"});
  expect_refused({"kind: truss", "beams", "line 1: is missing or empty, and so is faces"});
  expect_refused({"kind: truss\nbeams: 3", "beams", "line 2: must be a list"});
  expect_refused({"kind: truss\ndescription: []\nbeams: [" + kBeam + "]", "description", "line 2: must be a word"});
}

TEST(TrussFile, RefusesBeamsWithTheFieldAtFault) {
  const std::string from = "from: [0, 0, 0]", to = "to: [2, 0, 0]", profile = "profile: {width: 0.2, height: 0.1}";
  const auto beam = [](const std::string& rest) { return with_beam("{name: b, " + rest + "}"); };
  const auto given = [&](const std::string& more) { return beam(from + ", " + to + ", " + profile + ", " + more); };
  expect_refused({with_beam("3"), "beams[0]", "line 2: must be a map"});
  expect_refused({with_beam("{" + from + "}"), "beams[0].name", "line 2: is missing"});
  expect_refused({with_beam("{name: '', " + from + "}"), "beams[0].name", "line 2: must not be empty"});
  expect_refused({with_beam("{name: a/b, " + from + "}"), "beams[0].name", "line 2: must not hold '/' or '.'"});
  expect_refused({with_beam(kBeam + ",\n " + kBeam), "beams[1].name", "line 3: 'b' is given twice"});
  expect_refused({with_beam(kBeam) + "faces: [{name: b}]", "faces[0].name", "line 3: 'b' is given twice"});
  expect_refused({beam(to + ", " + profile), "beams[0].from", "line 2: is missing"});
  expect_refused({beam(from + ", " + profile), "beams[0].to", "line 2: is missing"});
  expect_refused({beam(from + ", " + to), "beams[0].profile", "line 2: is missing"});
  expect_refused({beam("from: [0, 0], " + to), "beams[0].from", "line 2: must be [x, y, z] in m"});
  expect_refused({beam("from: [0, x, 0], " + to), "beams[0].from[1]", "line 2: must be a number in m"});
  expect_refused({beam("from: [0, 0, .nan], " + to), "beams[0].from[2]", "line 2: must be finite"});
  expect_refused({beam("from: [0, 0, 20000], " + to), "beams[0].from[2]", "line 2: must be within 10000 m"});
  expect_refused({beam(from + ", to: [0, 0, 0], " + profile), "beams[0].to", "line 2: is where the beam begins"});
  expect_refused({beam(from + ", " + to + ", profile: {width: 0.2}"), "beams[0].profile.height", "line 2: is missing"});
  expect_refused({beam(from + ", " + to + ", profile: {width: 0, height: 1}"), "beams[0].profile.width", "line 2: must be 1e-6 m"});
  expect_refused(
      {beam(from + ", " + to + ", profile: {width: -1, height: 1}"), "beams[0].profile.width", "line 2: must be 1e-6 m"});
  expect_refused({beam(from + ", " + to + ", profile: 3"), "beams[0].profile", "line 2: must be a map"});
  expect_refused({given("up: [1, 0, 0]"), "beams[0].up", "line 2: must not point along the beam"});
  expect_refused({given("up: [0, 0, 0]"), "beams[0].up", "line 2: must not be zero"});
  expect_refused({given("colour: red"), "beams[0].colour", "line 2: is not a known key"});
}

TEST(TrussFile, RefusesFacesWithTheFieldAtFault) {
  const auto face = [](const std::string& polygon, const std::string& normal) {
    return with_face("{name: f, polygon: " + polygon + ", normal: " + normal + "}");
  };
  const std::string square = "[[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]", up = "[0, 0, 1]";
  EXPECT_NO_THROW(parse_truss(with_face(kFace)));
  expect_refused({with_face("{name: f}"), "faces[0].polygon", "line 2: is missing"});
  expect_refused({with_face("{name: f, polygon: " + square + "}"), "faces[0].normal", "line 2: is missing"});
  expect_refused({face("3", up), "faces[0].polygon", "line 2: must be a list of vertices"});
  expect_refused({face("[[0, 0, 0], [1, 0, 0]]", up), "faces[0].polygon", "line 2: must have three vertices at least, has 2"});
  std::string many = "[[0, 0, 0]";
  for (int k = 0; k < 1000; ++k) many += ", [" + std::to_string(k) + ", 1, 0]";
  expect_refused({face(many + "]", up), "faces[0].polygon", "line 2: must have 1000 vertices at most, has 1001"});
  expect_refused({face("[[0, 0, 0], [1, 0], [1, 1, 0]]", up), "faces[0].polygon[1]", "line 2: must be [x, y, z]"});
  expect_refused(
      {face("[[0, 0, 0], [0, 0, 0], [1, 1, 0]]", up), "faces[0].polygon[1]", "line 2: is the same as the vertex before it"});
  expect_refused({face("[[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 0, 0]]", up), "faces[0].polygon[3]", "line 2: repeats the first"});
  expect_refused({face("[[0, 0, 0], [1, 0, 0], [2, 0, 0]]", up), "faces[0].polygon", "line 2: has no area"});
  expect_refused({face("[[0, 0, 0], [1, 0, 0], [1, 1, 0.001], [0, 1, 0]]", up), "faces[0].polygon[0]", "line 2: is 0.000"});
  expect_refused({face(square, "[0, 0, 1.1]"), "faces[0].normal", "line 2: must be of length 1, is 1.1"});
  expect_refused({face(square, "[0, 1, 0]"), "faces[0].normal", "line 2: is not perpendicular"});
  expect_refused(
      {face("[[0, 0, 0], [2, 0, 0], [0, 1, 0], [1, 1, 0], [1, -1, 0]]", up), "faces[0].polygon[3]", "line 2: begins an edge"});
}

TEST(TrussFile, ReadsBackWhatIsWritten) {
  const Layout layout{"a \"name\" \\ with signs",
                      {{"b 1", {0.1, 1.0 / 3.0, 0}, {2, 1e-5, 3}, 0.15, 0.2, {0, 0, 1}}},
                      {{"wall", {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}}, {0, -1, 0}}}};
  const Layout back = parse_layout(to_yaml(layout));
  EXPECT_EQ(back.description, layout.description);
  ASSERT_EQ(back.beams.size(), 1u);
  EXPECT_EQ(back.beams[0].name, "b 1");
  EXPECT_EQ(back.beams[0].from, layout.beams[0].from);
  EXPECT_EQ(back.beams[0].to, layout.beams[0].to);
  EXPECT_EQ(back.beams[0].width, 0.15);
  EXPECT_EQ(back.beams[0].height, 0.2);
  EXPECT_EQ(back.beams[0].up, layout.beams[0].up);
  ASSERT_EQ(back.plates.size(), 1u);
  EXPECT_EQ(back.plates[0].polygon, layout.plates[0].polygon);
  EXPECT_EQ(back.plates[0].normal, layout.plates[0].normal);
}

TEST(TrussFile, RefusesAFileThatIsNotThere) { EXPECT_THROW(read_truss("/nowhere/truss.yaml"), InvalidScene); }

}  // namespace
}  // namespace foothold::truss
