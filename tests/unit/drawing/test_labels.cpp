// Where labels go, and the grid that finds things near a place.
#include "labels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "screen_grid.hpp"

namespace foothold::drawing {
namespace {

constexpr Rectangle kArea{0.0, 0.0, 400.0, 300.0};

Box2 box_of(const Label& label, LabelSize size) {
  const Vector2d half(label_width(label, size) / 2.0, size.height / 2.0);
  return {label.at - half, label.at + half};
}

// Points so near each other that labels at their best places would cover one another.
TEST(Labels, OfCrowdedPointsDoNotCoverEachOther) {
  std::vector<Label> labels;
  for (int i = 0; i < 12; ++i) labels.push_back({std::to_string(i), {200.0 + 3.0 * i, 150.0, 0.0}, {}});
  const LabelSize size = label_size(labels.size());
  place_labels(labels, size, kArea);
  for (std::size_t i = 0; i < labels.size(); ++i)
    for (std::size_t k = i + 1; k < labels.size(); ++k)
      EXPECT_FALSE(box_of(labels[i], size).meets(box_of(labels[k], size))) << i << " and " << k;
}

TEST(Labels, StayInsideTheirView) {
  std::vector<Label> labels;
  for (const double x : {0.0, 400.0})
    for (const double y : {0.0, 300.0}) labels.push_back({"12", {x, y, 0.0}, {}});
  const LabelSize size = label_size(labels.size());
  place_labels(labels, size, kArea);
  for (const Label& label : labels) {
    const Box2 box = box_of(label, size);
    EXPECT_TRUE(box.low.x() >= 0.0 && box.low.y() >= 0.0 && box.high.x() <= 400.0 && box.high.y() <= 300.0) << label.at.transpose();
  }
}

TEST(Labels, LoneLabelIsCloseToItsPoint) {
  std::vector<Label> labels{{"7", {200.0, 150.0, 0.0}, {}}};
  place_labels(labels, label_size(1), kArea);
  EXPECT_LT((labels[0].at - Vector2d(200.0, 150.0)).norm(), 20.0);
  EXPECT_GT((labels[0].at - Vector2d(200.0, 150.0)).norm(), 8.0) << "must not cover its point";
}

TEST(ScreenGrid, FindsWhatMeetsABoxAndNothingElse) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> place(-50.0, 550.0), width(0.0, 60.0);
  const auto some_box = [&] {
    const Vector2d low(place(random), place(random));
    return Box2{low, low + Vector2d(width(random), width(random))};
  };
  // The grid is told of less than the things span, and of fewer than come.
  ScreenGrid grid({{0.0, 0.0}, {400.0, 400.0}}, 50);
  std::vector<Box2> boxes;
  for (std::size_t i = 0; i < 300; ++i) {
    boxes.push_back(some_box());
    grid.insert(i, boxes.back());
  }
  for (int run = 0; run < 200; ++run) {
    const Box2 query = some_box();
    std::vector<std::size_t> expected;
    for (std::size_t i = 0; i < boxes.size(); ++i)
      if (boxes[i].meets(query)) expected.push_back(i);
    EXPECT_EQ(grid.near(query), expected);
  }
}

TEST(ScreenGrid, OneWithoutExtentWorks) {
  ScreenGrid grid({{5.0, 5.0}, {5.0, 5.0}}, 0);
  grid.insert(0, {{5.0, 5.0}, {5.0, 5.0}});
  EXPECT_EQ(grid.near({{0.0, 0.0}, {10.0, 10.0}}), (std::vector<std::size_t>{0}));
}

}  // namespace
}  // namespace foothold::drawing
