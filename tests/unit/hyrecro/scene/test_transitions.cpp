// Transition footholds: counts computed by hand, and what must hold for every one.
#include <gtest/gtest.h>

#include <algorithm>

#include "samples.hpp"
#include "truss/generate.hpp"

namespace foothold::hyrecro {
namespace {

const Model kModel = shipped_model();

std::size_t count(const Transitions& transitions, bool convex) {
  return static_cast<std::size_t>(std::count_if(transitions.all().begin(), transitions.all().end(),
                                                [&](const TransitionFoothold& t) { return t.convex == convex; }));
}

// What the definition demands of each foothold.
void expect_sound(const truss::Truss& truss, const Transitions& transitions, const SamplingOptions& options) {
  std::size_t of_faces = 0;
  for (std::size_t f = 0; f < truss.faces.size(); ++f) {
    of_faces += transitions.of_face(static_cast<int>(f)).size();
    for (const int k : transitions.of_face(static_cast<int>(f)))
      EXPECT_EQ(transitions.all()[static_cast<std::size_t>(k)].foothold.face, static_cast<int>(f));
  }
  EXPECT_EQ(of_faces, transitions.all().size());
  for (const TransitionFoothold& t : transitions.all()) {
    const truss::Face& face = truss.faces[static_cast<std::size_t>(t.foothold.face)];
    const truss::Face& other = truss.faces[static_cast<std::size_t>(t.towards)];
    ASSERT_TRUE(plate_on_face(kModel, face, t.foothold)) << face.name;
    EXPECT_TRUE(t.pose.isApprox(pose_of(truss, t.foothold), 1e-12));
    // From the sole along its X axis to the other face's plane: forward, or backward if it heads away.
    const Vector3d normal = other.frame.linear().col(2), x = t.pose.linear().col(0);
    const double ahead = normal.dot(other.frame.translation() - t.pose.translation()) / normal.dot(x);
    std::vector<double> distances = t.convex ? options.also_convex : options.also_concave;
    distances.push_back(t.convex ? options.convex : options.concave);
    const bool known =
        std::any_of(distances.begin(), distances.end(), [&](double d) { return std::abs(std::abs(ahead) - d) < 1e-7; });
    EXPECT_TRUE(known) << face.name << " to " << other.name << ": " << ahead;
    EXPECT_TRUE(ahead > 0.0 || options.both_headings);
    // Straight towards the line in which the planes meet.
    EXPECT_NEAR(x.dot(face.frame.linear().col(2).cross(normal).normalized()), 0.0, 1e-9);
    EXPECT_EQ(normal.dot(t.pose.translation() - other.frame.translation()) > 0.0, !t.convex);
    // A partner stands across, no farther along the line than the hip axes are apart.
    const Vector3d line = face.frame.linear().col(2).cross(normal).normalized();
    const auto& partners = transitions.of_face(t.towards);
    EXPECT_TRUE(std::any_of(partners.begin(), partners.end(), [&](int k) {
      const TransitionFoothold& p = transitions.all()[static_cast<std::size_t>(k)];
      return p.towards == t.foothold.face && p.convex == t.convex &&
             std::abs(line.dot(p.pose.translation() - t.pose.translation())) < kModel.hip_distance + options.step;
    })) << face.name;
  }
}

TEST(Transitions, OfOneBeamAreThoseCountedByHand) {
  const truss::Truss truss = truss::build({"", {{"b", {0, 0, 0}, {1, 0, 0}, 0.15, 0.15, {0, 0, 1}}}, {}});
  const SamplingOptions options;
  const Transitions transitions(kModel, truss, options);
  // 4 long edges, on either side 0.05 to 0.95 m every 0.05; 8 short edges, on either side -0.025 and +0.025.
  EXPECT_EQ(transitions.all().size(), 4u * 2u * 19u + 8u * 2u * 2u);
  EXPECT_EQ(count(transitions, false), 0u);
  expect_sound(truss, transitions, options);
}

TEST(Transitions, OfTheCrossedBeamsAreThoseCountedByHand) {
  const truss::Truss truss = shipped_scene("truss-crossed-beams");
  const SamplingOptions options;
  const Transitions transitions(kModel, truss, options);
  // Concave: above the crossing on both sides, two on the long beam and two on the short one; below, the short one's arm of 0.275 m
  // leaves no room.
  EXPECT_EQ(count(transitions, false), 2u * 4u);
  // Convex, the long beam's four long edges: before the crossing 30 on the whole side and 29 on the cut one, behind it 10 and 9.
  // The short beam's: above 13 and 12, below 7 and 6. Eight short edges of either with 2 and 2.
  EXPECT_EQ(count(transitions, true), 4u * (30u + 29u + 10u + 9u) + 4u * (13u + 12u + 7u + 6u) + 2u * 8u * 4u);
  expect_sound(truss, transitions, options);
}

TEST(Transitions, HeadAwayAsWellIfAsked) {
  const truss::Truss truss = shipped_scene("truss-crossed-beams");
  SamplingOptions options;
  const std::size_t towards = Transitions(kModel, truss, options).all().size();
  options.both_headings = true;
  const Transitions transitions(kModel, truss, options);
  EXPECT_EQ(transitions.all().size(), 2u * towards);
  expect_sound(truss, transitions, options);
}

TEST(Transitions, StandAtFurtherDistancesIfAsked) {
  const truss::Truss truss = shipped_scene("truss-crossed-beams");
  SamplingOptions options;
  options.also_convex = {0.05};
  options.also_concave = {0.2};
  const Transitions transitions(kModel, truss, options);
  // At 0.2 m the arm below the crossing has room, too, both at its end and on the long beam at 0.2 and 0.25 m.
  EXPECT_EQ(count(transitions, false), 2u * 8u + 2u * 6u);
  expect_sound(truss, transitions, options);
}

TEST(Transitions, CanBeFarFromTheLineInWhichThePlanesMeet) {
  // Two plates with a gap where they would meet: a wall that begins 0.15 m above a floor that ends 0.1 m before it.
  const truss::Truss truss = truss::build({"",
                                           {},
                                           {{"floor", {{0.1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.1, 1, 0}}, {0, 0, 1}},
                                            {"wall", {{0, 0, 0.15}, {0, 1, 0.15}, {0, 1, 1}, {0, 0, 1}}, {1, 0, 0}}}});
  const Transitions transitions(kModel, truss, {});
  EXPECT_EQ(count(transitions, false), 2u * 19u);
  EXPECT_EQ(count(transitions, true), 0u);
  expect_sound(truss, transitions, {});
}

TEST(Transitions, LeadNowhereBetweenFacesThatDoNotSeeEachOther) {
  // The wall looks the other way.
  const truss::Truss truss = truss::build({"",
                                           {},
                                           {{"floor", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {0, 0, 1}},
                                            {"wall", {{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}}, {-1, 0, 0}}}});
  EXPECT_TRUE(Transitions(kModel, truss, {}).all().empty());
}

TEST(Transitions, OfPlatesThatFallAwayFromASharedEdgeAreConvex) {
  const truss::Truss truss = truss::build({"",
                                           {},
                                           {{"roof", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {0, 0, 1}},
                                            {"side", {{0, 0, 0}, {0, 1, 0}, {0, 1, -1}, {0, 0, -1}}, {-1, 0, 0}}}});
  const Transitions transitions(kModel, truss, {});
  EXPECT_EQ(count(transitions, true), 2u * 19u);
  EXPECT_EQ(count(transitions, false), 0u);
  expect_sound(truss, transitions, {});
}

TEST(Transitions, NearAPointAreThoseThatAreNear) {
  const truss::Truss truss = shipped_scene("truss-crossed-beams");
  const Transitions transitions(kModel, truss, {});
  std::mt19937_64 random(9);
  for (int round = 0; round < 200; ++round) {
    const Vector3d point(uniform(random, 0, 2), uniform(random, -0.3, 0.3), uniform(random, -0.4, 0.7));
    const double radius = uniform(random, 0.05, 0.8);
    const int face = static_cast<int>(random() % truss.faces.size());
    const std::vector<int> near = transitions.near(point, radius, face);
    std::vector<int> expected;
    const auto distance = [&](int k) { return (transitions.all()[static_cast<std::size_t>(k)].pose.translation() - point).norm(); };
    for (int k = 0; k < static_cast<int>(transitions.all().size()); ++k)
      if (distance(k) < radius && transitions.all()[static_cast<std::size_t>(k)].foothold.face != face) expected.push_back(k);
    EXPECT_TRUE(std::is_sorted(near.begin(), near.end(), [&](int a, int b) { return distance(a) < distance(b) - 1e-12; }));
    std::vector<int> sorted = near;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(sorted, expected);
  }
}

TEST(Transitions, OfGeneratedTrussesAreSound) {
  std::size_t convex = 0, concave = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const auto family = static_cast<truss::Family>(seed % 3);
    const truss::Truss truss = truss::build(truss::generate(family, seed, 2 + static_cast<int>(seed)));
    SamplingOptions options;
    options.step = 0.1;
    const Transitions transitions(kModel, truss, options);
    convex += count(transitions, true);
    concave += count(transitions, false);
    expect_sound(truss, transitions, options);
  }
  EXPECT_GT(convex, 5000u);
  EXPECT_GT(concave, 300u);
}

TEST(Transitions, AreTheSameEveryTime) {
  const truss::Truss truss = truss::build(truss::generate(truss::Family::kBridge, 2, 20));
  const Transitions once(kModel, truss, {}), again(kModel, truss, {});
  ASSERT_EQ(once.all().size(), again.all().size());
  for (std::size_t k = 0; k < once.all().size(); ++k) EXPECT_TRUE(once.all()[k].pose.matrix() == again.all()[k].pose.matrix());
}

TEST(Transitions, OfAnEmptySceneAreNone) {
  const Transitions transitions(kModel, truss::Truss{}, {});
  EXPECT_TRUE(transitions.all().empty());
  EXPECT_TRUE(transitions.near(Vector3d::Zero(), 1.0, -1).empty());
}

}  // namespace
}  // namespace foothold::hyrecro
