// What cannot be drawn is refused with the field's name.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "samples.hpp"

namespace foothold::drawing {
namespace {

using namespace samples;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

struct Refusal {
  const char* field;
  const char* reason;  // a part of the message
  std::function<void(Drawing&, DrawOptions&)> spoil;
};

void PrintTo(const Refusal& refusal, std::ostream* out) { *out << refusal.field << " (" << refusal.reason << ")"; }

Drawing sound() {
  Drawing drawing;
  drawing.scene = {box("beam", 0, 0, 0, 1, 1, 1), polygon("wall", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}})};
  drawing.start.base({pose(0, 0, 0)});
  drawing.goal.contacts({contact("A", pose(1, 1, 1))});
  for (std::uint32_t i = 0; i < 5; ++i) {
    msg::Step one = step(i, pose(i, 0, 0));
    one.placed({contact("A", pose(i, 0, 0)), contact("B", pose(i, 1, 0))});
    one.stance(one.placed());
    one.shapes({capsule("leg", {0, 0, 0}, {0, 0, 1}, 0.1)});
    one.motion().resize(2);
    for (auto& point : one.motion()) point.base(pose(i, 0, 0.5));
    drawing.steps.push_back(one);
  }
  return drawing;
}

class Refusals : public testing::TestWithParam<Refusal> {};

TEST_P(Refusals, NameTheField) {
  Drawing drawing = sound();
  DrawOptions options;
  GetParam().spoil(drawing, options);
  try {
    draw_svg(drawing, options);
    FAIL() << "was drawn";
  } catch (const InvalidDrawing& refused) {
    EXPECT_EQ(refused.field(), GetParam().field);
    EXPECT_NE(std::string(refused.what()).find(GetParam().reason), std::string::npos) << refused.what();
  }
}

INSTANTIATE_TEST_SUITE_P(
    Messages, Refusals,
    testing::Values(
        Refusal{"steps[3].base.position.x", "not a finite number", [](auto& d, auto&) { d.steps[3].base().position().x(kNaN); }},
        Refusal{"steps[2].base.orientation.w", "not a finite number",
                [](auto& d, auto&) { d.steps[2].base().orientation().w(kInfinity); }},
        Refusal{"steps[2].base.orientation", "unit length", [](auto& d, auto&) { d.steps[2].base().orientation().w(1.01); }},
        Refusal{"steps[0].base.orientation", "unit length", [](auto& d, auto&) { d.steps[0].base(msg::Pose()); }},
        Refusal{"steps[4].placed[1].frame.position.z", "not a finite number",
                [](auto& d, auto&) { d.steps[4].placed()[1].frame().position().z(kNaN); }},
        Refusal{"steps[4].stance[0].frame.position.y", "beyond 1e9",
                [](auto& d, auto&) { d.steps[4].stance()[0].frame().position().y(-2e9); }},
        Refusal{"steps[1].motion[1].base.position.x", "not a finite number",
                [](auto& d, auto&) { d.steps[1].motion()[1].base().position().x(-kInfinity); }},
        Refusal{"steps[1].shapes[0].size.z", "not a finite number", [](auto& d, auto&) { d.steps[1].shapes()[0].size().z(kNaN); }},
        Refusal{"steps[1].shapes[0].size.x", "below 0", [](auto& d, auto&) { d.steps[1].shapes()[0].size().x(-0.1); }},
        Refusal{"steps[1].shapes[0].kind", "number 9",
                [](auto& d, auto&) { d.steps[1].shapes()[0].kind(static_cast<msg::ShapeKind>(9)); }},
        Refusal{"steps", "2 follows 2", [](auto& d, auto&) { d.steps[3].index(2); }},
        Refusal{"scene[0].pose.position.y", "not a finite number", [](auto& d, auto&) { d.scene[0].pose().position().y(kNaN); }},
        Refusal{"scene[1].vertices[2].x", "not a finite number", [](auto& d, auto&) { d.scene[1].vertices()[2].x(kNaN); }},
        Refusal{"scene[1].vertices", "3 vertices, has 2", [](auto& d, auto&) { d.scene[1].vertices().resize(2); }},
        Refusal{"scene[1].vertices", "may have 2000", [](auto& d, auto&) { d.scene[1].vertices().resize(2001); }},
        Refusal{"scene[1].vertices", "planar", [](auto& d, auto&) { d.scene[1].vertices()[2].z(0.2); }},
        Refusal{"scene[1].vertices", "crosses itself",
                [](auto& d, auto&) {
                  std::swap(d.scene[1].vertices()[1], d.scene[1].vertices()[2]);
                  d.scene[1].vertices()[3].y(0.7);
                }},
        Refusal{"start.base.orientation", "unit length", [](auto& d, auto&) { d.start.base()[0].orientation().w(0.0); }},
        Refusal{"start.base.position.x", "not a finite number",
                [](auto& d, auto&) {
                  d.start.any_orientation(true);
                  d.start.base()[0].position().x(kNaN);
                }},
        Refusal{"goal.contacts[0].frame.position.z", "not a finite number",
                [](auto& d, auto&) { d.goal.contacts()[0].frame().position().z(kNaN); }}));

INSTANTIATE_TEST_SUITE_P(Options, Refusals,
                         testing::Values(Refusal{"options.width", "300 to", [](auto&, auto& o) { o.width = 299.0; }},
                                         Refusal{"options.width", "is nan", [](auto&, auto& o) { o.width = kNaN; }},
                                         Refusal{"options.height", "300 to", [](auto&, auto& o) { o.height = 20001.0; }},
                                         Refusal{"options.azimuth", "is inf", [](auto&, auto& o) { o.azimuth = kInfinity; }},
                                         Refusal{"options.elevation", "-90 to 90", [](auto&, auto& o) { o.elevation = 90.5; }},
                                         Refusal{"options.last_step", "before first_step 3",
                                                 [](auto&, auto& o) {
                                                   o.first_step = 3;
                                                   o.last_step = 2;
                                                 }},
                                         Refusal{"options.first_step", "5 steps, 0 to 4",
                                                 [](auto&, auto& o) { o.first_step = 5; }}));

TEST(Refusal, TheSoundDrawingIsDrawn) { EXPECT_NO_THROW(draw_svg(sound(), {})); }

TEST(Refusal, NothingToDrawIsSaid) {
  try {
    draw_svg({}, {});
    FAIL() << "was drawn";
  } catch (const InvalidDrawing& refused) {
    EXPECT_EQ(refused.field(), "");
    EXPECT_NE(std::string(refused.what()).find("nothing to draw"), std::string::npos);
  }
}

TEST(Refusal, GoalOfAnyOrientationNeedsNone) {
  Drawing drawing = sound();
  drawing.goal = {};
  drawing.goal.base({msg::Pose()});
  drawing.goal.any_orientation(true);
  EXPECT_NO_THROW(draw_svg(drawing, {}));
}

TEST(Refusal, StepsThatAreNotChosenAreNotLookedAt) {
  Drawing drawing = sound();
  drawing.steps[4].base().position().x(kNaN);
  DrawOptions options;
  options.last_step = 3;
  EXPECT_NO_THROW(draw_svg(drawing, options));
}

}  // namespace
}  // namespace foothold::drawing
