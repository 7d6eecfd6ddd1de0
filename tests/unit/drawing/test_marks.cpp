// Footholds, numbers, the base's way, start, goal and scale, by where they come to lie.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <set>

#include "reading.hpp"
#include "samples.hpp"

namespace foothold::drawing {
namespace {

using namespace samples;

std::multiset<std::string> labels_in(const Picture& picture, const char* view) {
  const auto texts = Picture::texts(picture.part(view), "text");
  return {texts.begin(), texts.end()};
}

TEST(Marks, EveryFootholdIsNumberedInBothViews) {
  for (const Drawing& drawing : {planar(), biped(false), hexapod()}) {
    const Picture picture(draw_svg(drawing, {}));
    std::multiset<std::string> expected;
    for (const msg::Step& one : drawing.steps)
      for (std::size_t i = 0; i < one.placed().size(); ++i) expected.insert(std::to_string(one.index()));
    for (std::size_t i = 0; i < drawing.start.contacts().size() + drawing.start.base().size(); ++i) expected.insert("S");
    for (std::size_t i = 0; i < drawing.goal.contacts().size() + drawing.goal.base().size(); ++i) expected.insert("G");
    EXPECT_EQ(labels_in(picture, "above"), expected) << drawing.robot;
    EXPECT_EQ(labels_in(picture, "oblique"), expected) << drawing.robot;
  }
}

TEST(Marks, AStepThatPlacesManyFeetHasOneNumberAndTheirNormals) {
  Drawing drawing;
  for (std::uint32_t i = 0; i < 3; ++i) {
    msg::Step one = step(i, pose(i, 0, 0.2));
    for (int k = 0; k < 8; ++k) one.placed().push_back(contact("A", pose(i + 0.1 * k, k % 2, 0)));
    one.stance(one.placed());
    drawing.steps.push_back(one);
  }
  const Picture picture(draw_svg(drawing, {}));
  EXPECT_EQ(labels_in(picture, "above"), (std::multiset<std::string>{"0", "1", "2"}));
  EXPECT_EQ(Picture::attributes(picture.part("oblique"), "az", "x1").size(), 24u);
  EXPECT_TRUE(Picture::attributes(picture.part("oblique"), "ax", "x1").empty());
}

TEST(Marks, PixelsOfKnownPointsAreInProportion) {
  // Four bases at the corners of a unit square: in the view from above the dots make a square, Y up.
  Drawing drawing;
  const std::array<std::array<double, 2>, 4> corners{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  for (std::uint32_t i = 0; i < 4; ++i) drawing.steps.push_back(step(i, pose(corners[i][0], corners[i][1], 0.0)));
  const Picture picture(draw_svg(drawing, {}));
  const auto x = Picture::attributes(picture.part("above"), "wp", "cx");
  const auto y = Picture::attributes(picture.part("above"), "wp", "cy");
  ASSERT_EQ(x.size(), 4u);
  const double scale = std::stod(x[1]) - std::stod(x[0]);
  EXPECT_GT(scale, 100.0);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(std::stod(x[i]), std::stod(x[0]) + scale * corners[i][0], 2e-3);
    EXPECT_NEAR(std::stod(y[i]), std::stod(y[0]) - scale * corners[i][1], 2e-3);
  }
  // Of the oblique view by hand: right is (sin 60, cos 60), up is (-cos 60, sin 60) sin 30.
  const auto ox = Picture::attributes(picture.part("oblique"), "wp", "cx");
  const auto oy = Picture::attributes(picture.part("oblique"), "wp", "cy");
  const double slanted = (std::stod(ox[1]) - std::stod(ox[0])) / (std::sqrt(3.0) / 2.0);
  EXPECT_GT(slanted, 100.0);
  for (std::size_t i = 0; i < 4; ++i) {
    const double right = std::sqrt(3.0) / 2.0 * corners[i][0] + 0.5 * corners[i][1];
    const double up = 0.5 * (-0.5 * corners[i][0] + std::sqrt(3.0) / 2.0 * corners[i][1]);
    EXPECT_NEAR(std::stod(ox[i]) - std::stod(ox[0]), slanted * right, 3e-3);
    EXPECT_NEAR(std::stod(oy[i]) - std::stod(oy[0]), -slanted * up, 3e-3);
  }
}

TEST(Marks, ScaleBarIsAsLongAsItSays) {
  Drawing drawing;
  drawing.steps = {step(0, pose(0, 0, 0)), step(1, pose(4, 0, 0))};
  const Picture picture(draw_svg(drawing, {}));
  const auto x = Picture::attributes(picture.part("above"), "wp", "cx");
  const double scale = (std::stod(x[1]) - std::stod(x[0])) / 4.0;
  double said = 0.0;
  for (const std::string& words : Picture::texts(picture.root(), "text"))
    if (words.ends_with(" m") && std::isdigit(static_cast<unsigned char>(words[0])) != 0) said = std::stod(words);
  ASSERT_GT(said, 0.0);
  bool found = false;
  for (const std::string& data : Picture::attributes(picture.root(), "il", "d")) {
    const auto numbers = numbers_in(data);
    if (numbers.size() == 8 && std::abs(numbers[4] - numbers[2] - said * scale) < 0.01) found = true;
  }
  EXPECT_TRUE(found) << said << " m at " << scale << " px per m";
}

TEST(Marks, FootholdUnderABeamIsDashedFromAbove) {
  Drawing drawing;
  drawing.scene = {box("beam", 0, 0, 0, 2.0, 0.2, 0.2)};
  for (std::uint32_t i = 0; i < 2; ++i) {
    const double side = i == 0 ? 1.0 : -1.0;  // step 0 on top, step 1 underneath
    drawing.steps.push_back(step(i, pose(0, 0, side * 0.3)));
    drawing.steps[i].placed({contact("A", pose_on({0.5 - i, 0, side * 0.1}, {0, 0, side}, {1, 0, 0}))});
  }
  const Picture picture(draw_svg(drawing, {}));
  const auto forward = Picture::attributes(picture.part("above"), "ax", "class");
  EXPECT_EQ(forward, (std::vector<std::string>{"ax", "ax d"}));
  EXPECT_EQ(Picture::attributes(picture.part("above"), "k", "class"), (std::vector<std::string>{"k", "k d"}));
}

TEST(Marks, BaseBehindTheSceneIsDashed) {
  Drawing drawing;
  drawing.scene = {box("bridge", 0, 0, 1.0, 0.5, 0.5, 0.1)};
  drawing.steps = {step(0, pose(-1, 0, 0)), step(1, pose(1, 0, 0))};
  const Picture picture(draw_svg(drawing, {}));
  const auto parts = Picture::attributes(picture.part("above"), "w", "class");
  EXPECT_EQ(parts, (std::vector<std::string>{"w", "w d", "w"}));
  // A quarter of the way lies under the bridge.
  const auto data = Picture::attributes(picture.part("above"), "w", "d");
  const auto length = [&](std::size_t i) {
    const auto numbers = numbers_in(data[i]);
    return numbers[2] - numbers[0];
  };
  EXPECT_NEAR(length(1) / (length(0) + length(1) + length(2)), 0.25, 1e-3);
}

TEST(Marks, MotionBendsTheWayOfTheBase) {
  Drawing drawing;
  drawing.steps = {step(0, pose(0, 0, 0)), step(1, pose(1, 0, 0))};
  drawing.steps[1].motion().resize(3);
  for (std::size_t i = 0; i < 3; ++i) drawing.steps[1].motion()[i].base(pose(0.25 * static_cast<double>(i + 1), 0.3, 0));
  const Picture picture(draw_svg(drawing, {}));
  EXPECT_EQ(Picture::attributes(picture.part("above"), "w", "d").size(), 4u);
}

TEST(Marks, WayBeginsAtTheStartOnlyWithTheFirstStep) {
  Drawing drawing;
  drawing.start.base({pose(-1, 0, 0)});
  for (std::uint32_t i = 0; i < 4; ++i) drawing.steps.push_back(step(i, pose(i, 0, 0)));
  DrawOptions options;
  EXPECT_EQ(Picture::attributes(Picture(draw_svg(drawing, options)).part("above"), "w", "d").size(), 4u);
  options.first_step = 1;
  EXPECT_EQ(Picture::attributes(Picture(draw_svg(drawing, options)).part("above"), "w", "d").size(), 2u);
}

TEST(Marks, StartContactThatStillHoldsIsDrawnOnce) {
  Drawing drawing;
  drawing.start.contacts({contact("A", pose(0, 0, 0))});
  msg::Step one = step(0, pose(0, 0, 0.3));
  one.placed({contact("B", pose(0.5, 0, 0))});
  one.stance({drawing.start.contacts()[0], one.placed()[0]});
  drawing.steps = {one};
  EXPECT_EQ(Picture::attributes(Picture(draw_svg(drawing, {})).part("above"), "ax", "d").size(), 2u);
}

TEST(Marks, ContactHeldFromBeforeIsDrawnWithoutANumber) {
  Drawing drawing;
  drawing.steps = {step(0, pose(0, 0, 0)), step(1, pose(1, 0, 0))};
  const auto held = contact("B", pose(0.5, 0.5, 0));
  for (msg::Step& one : drawing.steps) {
    one.placed({contact("A", pose(one.index(), 0, 0))});
    one.stance({held, one.placed()[0]});
  }
  const Picture picture(draw_svg(drawing, {}));
  EXPECT_EQ(Picture::attributes(picture.part("above"), "ax", "d").size(), 3u);
  EXPECT_EQ(labels_in(picture, "above"), (std::multiset<std::string>{"0", "1"}));
}

TEST(Marks, SmallPlansAreInMillimetres) {
  for (const auto& [reach, unit] : {std::pair{0.5, "in mm"}, {5.0, "in m"}}) {
    Drawing drawing;
    drawing.steps = {step(0, pose(0, 0, 0)), step(1, pose(reach, 0, 0))};
    EXPECT_NE(draw_svg(drawing, {}).find(std::string("X to the right, Y up, ") + unit + "<"), std::string::npos) << reach;
  }
}

TEST(Marks, GoalAloneIsDrawn) {
  Drawing drawing;
  drawing.goal.base({pose(3, 4, 5)});
  const Picture picture(draw_svg(drawing, {}));
  EXPECT_EQ(labels_in(picture, "oblique"), std::multiset<std::string>{"G"});
}

TEST(Marks, PlanWithoutExtentIsDrawnInTheMiddle) {
  for (const double far : {0.0, 1e6, -3e8}) {
    Drawing drawing;
    drawing.steps = {step(0, pose(far, far, far))};
    const Picture picture(draw_svg(drawing, {}));
    const auto x = Picture::attributes(picture.part("above"), "wp", "cx");
    ASSERT_EQ(x.size(), 1u);
    EXPECT_GT(std::stod(x[0]), 62.0);
    EXPECT_LT(std::stod(x[0]), 800.0);
  }
}

TEST(Marks, PlanOnALineIsDrawn) {
  for (int axis = 0; axis < 3; ++axis) {
    Drawing drawing;
    drawing.steps = {step(0, pose(0, 0, 0)), step(1, pose(axis == 0, axis == 1, axis == 2))};
    Picture picture(draw_svg(drawing, {}));
  }
}

TEST(Marks, WithoutShapesTheRobotIsLinesFromBaseToContacts) {
  Drawing drawing = hexapod();
  for (msg::Step& one : drawing.steps) one.shapes().clear();
  const Picture picture(draw_svg(drawing, {}));
  EXPECT_GE(Picture::attributes(picture.part("above"), "sk", "d").size(), 6 * drawing.steps.size());
}

}  // namespace
}  // namespace foothold::drawing
