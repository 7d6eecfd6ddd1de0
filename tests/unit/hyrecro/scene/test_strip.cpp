// Free stretches against the plate's own test, place by place.
#include <gtest/gtest.h>

#include <algorithm>

#include "hyrecro/scene/strip.hpp"
#include "samples.hpp"

namespace foothold::hyrecro {
namespace {

const Model kModel = shipped_model();

TEST(FreeStretches, HoldJustThePlacesWhereThePlateIsOnTheFace) {
  std::mt19937_64 random(8);
  int inside = 0, outside = 0;
  for (int round = 0; round < 400; ++round) {
    const truss::Face face = random_face(random);
    const double angle = uniform(random, -3.1, 3.1);
    Slider slider;
    slider.origin = {uniform(random, -0.6, 0.6), uniform(random, -0.6, 0.6)};
    slider.along = {std::cos(angle), std::sin(angle)};
    slider.low = -0.5 * kModel.plate.y();
    slider.high = 0.5 * kModel.plate.y();
    slider.half = 0.5 * kModel.plate.x();
    const std::vector<Stretch> stretches = free_stretches(FaceEdges(face), slider, {-2.0, 2.0});
    for (std::size_t k = 1; k < stretches.size(); ++k) EXPECT_LT(stretches[k - 1].end, stretches[k].begin);
    for (int trial = 0; trial < 400; ++trial) {
      const double t = uniform(random, -1.5, 1.5);
      const auto at_end = [&](const Stretch& s) { return std::abs(t - s.begin) < 1e-6 || std::abs(t - s.end) < 1e-6; };
      if (std::any_of(stretches.begin(), stretches.end(), at_end)) continue;  // either is right
      const bool within =
          std::any_of(stretches.begin(), stretches.end(), [&](const Stretch& s) { return t > s.begin && t < s.end; });
      EXPECT_EQ(plate_on_face(kModel, face, {0, slider.origin + t * slider.along, angle}), within)
          << "round " << round << " t " << t;
      (within ? inside : outside) += 1;
    }
    for (const Stretch& s : stretches)
      for (const double t : {s.begin, s.end})
        EXPECT_TRUE(plate_on_face(kModel, face, {0, slider.origin + t * slider.along, angle})) << "round " << round;
  }
  EXPECT_GT(inside, 10000);
  EXPECT_GT(outside, 10000);
}

TEST(FreeStretches, HoldOnePlaceWhereThePlateJustFits) {
  truss::Face face;
  face.frame = Isometry3d::Identity();
  face.outline = {{0, 0}, {0.1, 0}, {0.1, 0.1}, {0, 0.1}};
  const std::vector<Stretch> stretches = free_stretches(FaceEdges(face), {{0.0, 0.05}, {1.0, 0.0}, -0.05, 0.05, 0.05}, {-1.0, 1.0});
  ASSERT_EQ(stretches.size(), 1u);
  EXPECT_NEAR(stretches[0].begin, 0.05, 1e-9);
  EXPECT_NEAR(stretches[0].end, 0.05, 1e-9);
}

}  // namespace
}  // namespace foothold::hyrecro
