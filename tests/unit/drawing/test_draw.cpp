// The whole picture, by its properties.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "reading.hpp"
#include "samples.hpp"

namespace foothold::drawing {
namespace {

using namespace samples;

std::multiset<std::string> labels_in(const Picture& picture, const char* view) {
  const auto texts = Picture::texts(picture.part(view), "text");
  return {texts.begin(), texts.end()};
}

TEST(Draw, SamplesAreWellFormed) {
  for (const Drawing& drawing : {planar(), biped(false), biped(true), tower(), hexapod()}) Picture picture(draw_svg(drawing, {}));
}

TEST(Draw, SameInputSameBytes) {
  EXPECT_EQ(draw_svg(hexapod(), {}), draw_svg(hexapod(), {}));
  EXPECT_EQ(draw_svg(biped(true), {}), draw_svg(biped(true), {}));
}

TEST(Draw, EveryClassHasARule) {
  const std::set<std::string> without = {"stance", "label"};  // for scripts and tests only
  Drawing bare = hexapod();
  for (msg::Step& one : bare.steps) one.shapes().clear();
  for (const Drawing& drawing : {planar(), biped(true), tower(), hexapod(), bare}) {
    const Picture picture(draw_svg(drawing, {}));
    const std::string rules = Picture::texts(picture.root(), "style").at(0);
    for (const std::string& classes : Picture::attributes(picture.root(), "", "class")) {
      std::istringstream words(classes);
      for (std::string word; words >> word;) {
        const std::string selector = "." + word;
        const bool ruled =
            std::ranges::any_of(std::string("{,. "), [&](char next) { return rules.find(selector + next) != std::string::npos; });
        EXPECT_TRUE(ruled || without.contains(word)) << word;
      }
    }
  }
}

TEST(Draw, NoNumberIsAnythingButFinite) {
  for (const Drawing& drawing : {planar(), biped(true), hexapod()}) {
    const std::string svg = draw_svg(drawing, {});
    for (const char* word : {"nan", "inf", "'-nan", " 1e"}) EXPECT_EQ(svg.find(word), std::string::npos) << word;
  }
}

TEST(Draw, OfTwoBoxesTheNearerOneIsDrawnLast) {
  // From azimuth -90 deg the box at y = -0.4 is before the other; their order in the message does not matter.
  for (const bool swapped : {false, true}) {
    Drawing drawing;
    drawing.scene = {box("far", 0, 0.4, 0.1, 1, 0.2, 1), box("near", 0, -0.4, 0.1, 1, 0.2, 1)};
    if (swapped) std::swap(drawing.scene[0], drawing.scene[1]);
    DrawOptions options;
    options.views = Views::kOblique;
    options.azimuth = -90.0;
    const Picture picture(draw_svg(drawing, options));
    const auto faces = Picture::attributes(picture.part("oblique"), "f", "d");
    ASSERT_EQ(faces.size(), 4u);  // two of each: the top and the one that looks here
    // The near box's front reaches lowest on the page, and is drawn after both faces of the far one.
    std::vector<double> lowest;
    for (const std::string& data : faces) {
      const auto numbers = numbers_in(data);
      lowest.push_back(0.0);
      for (std::size_t i = 1; i < numbers.size(); i += 2) lowest.back() = std::max(lowest.back(), numbers[i]);
    }
    EXPECT_GE(std::max_element(lowest.begin(), lowest.end()) - lowest.begin(), 2);
  }
}

TEST(Draw, OfTwoBodiesTheNearerOneIsDrawnLast) {
  for (const bool swapped : {false, true}) {
    Drawing drawing;
    msg::Step one = step(0, pose(0, 0, 0));
    one.shapes({sphere("low", 0, 0, 0.0, 0.1), sphere("high", 0.05, 0, 0.5, 0.2)});
    if (swapped) std::swap(one.shapes()[0], one.shapes()[1]);
    drawing.steps = {one};
    DrawOptions options;
    options.views = Views::kAbove;
    const Picture picture(draw_svg(drawing, options));
    const auto low = Picture::attributes(picture.part("above"), swapped ? "r1" : "r0", "d");
    const auto high = Picture::attributes(picture.part("above"), swapped ? "r0" : "r1", "d");
    ASSERT_EQ(low.size(), 1u);
    ASSERT_EQ(high.size(), 1u);
    const std::string svg = draw_svg(drawing, options);
    EXPECT_LT(svg.find(low[0]), svg.find(high[0]));
  }
}

TEST(Draw, CutsInsideAConcavePolygonAreNotSeen) {
  Drawing drawing;
  drawing.scene = {polygon("L", {{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}})};
  drawing.steps = {step(0, pose(0, 0, 0)), step(1, pose(3, 0, 0))};
  const Picture picture(draw_svg(drawing, {}));
  const auto x = Picture::attributes(picture.part("above"), "wp", "cx");
  const double scale = (std::stod(x[1]) - std::stod(x[0])) / 3.0;
  double drawn = 0.0;
  for (const std::string& data : Picture::attributes(picture.part("above"), "e", "d")) {
    const auto numbers = numbers_in(data);
    for (std::size_t i = 0; i + 3 < numbers.size(); i += 4)
      drawn += std::hypot(numbers[i + 2] - numbers[i], numbers[i + 3] - numbers[i + 1]);
  }
  EXPECT_NEAR(drawn / scale, 12.0, 0.01);
}

TEST(Draw, SeenFromBelowNoGridIsBeforeTheScene) {
  DrawOptions options;
  options.views = Views::kOblique;
  EXPECT_EQ(Picture::attributes(Picture(draw_svg(biped(false), options)).part("oblique"), "g", "d").size(), 1u);
  options.elevation = -30.0;
  EXPECT_TRUE(Picture::attributes(Picture(draw_svg(biped(false), options)).part("oblique"), "g", "d").empty());
}

TEST(Draw, WhatABeamHidesOfTheRobotIsDashed) {
  Drawing drawing;
  drawing.scene = {box("wall", 0, -1, 0, 2, 0.1, 2)};
  msg::Step behind = step(0, pose(0, 0, 0));
  behind.shapes({sphere("ball", 0, 0, 0, 0.2)});
  drawing.steps = {behind};
  DrawOptions options;
  options.views = Views::kOblique;
  options.azimuth = -90.0;
  const Picture hidden(draw_svg(drawing, options));
  EXPECT_EQ(Picture::attributes(hidden.part("oblique"), "h", "d").size(), 1u);
  EXPECT_TRUE(Picture::attributes(hidden.part("oblique"), "s3", "d").empty());
  options.azimuth = 90.0;
  const Picture seen(draw_svg(drawing, options));
  EXPECT_TRUE(Picture::attributes(seen.part("oblique"), "h", "d").empty());
}

TEST(Draw, CrossingIsMarkedInBothViewsAndSaidInTheLegend) {
  const Picture clean(draw_svg(biped(false), {})), through(draw_svg(biped(true), {}));
  const auto marks = [](const Picture& picture, const char* view) {
    return Picture::attributes(picture.part(view), "x", "d").size() + Picture::attributes(picture.part(view), "xl", "d").size();
  };
  for (const char* view : {"above", "oblique"}) {
    EXPECT_EQ(marks(clean, view), 0u);
    EXPECT_GT(marks(through, view), 0u);
  }
  std::string words;
  for (const std::string& text : Picture::texts(through.root(), "text")) words += text + "\n";
  EXPECT_NE(words.find("CUTS THE SCENE after step 4"), std::string::npos) << words;
}

TEST(Draw, LaterStancesAreStronger) {
  const Picture picture(draw_svg(hexapod(), {}));
  double before = 0.0;
  for (const std::string& opacity : Picture::attributes(picture.part("above"), "stance", "opacity")) {
    EXPECT_GT(std::stod(opacity), before);
    before = std::stod(opacity);
  }
}

TEST(Draw, OneViewAndSomeSteps) {
  DrawOptions options;
  options.views = Views::kAbove;
  options.first_step = 3;
  options.last_step = 7;
  const Picture picture(draw_svg(planar(), options));
  EXPECT_EQ(picture.part("oblique"), nullptr);
  EXPECT_EQ(labels_in(picture, "above"), (std::multiset<std::string>{"3", "4", "5", "6", "7", "G", "S"}));
  std::string words;
  for (const std::string& text : Picture::texts(picture.root(), "text")) words += text + "\n";
  EXPECT_NE(words.find("12 steps, drawn: 3 to 7"), std::string::npos) << words;
}

TEST(Draw, SizeIsAsAskedFor) {
  DrawOptions options;
  options.width = 900.0;
  options.height = 700.0;
  const Picture picture(draw_svg(biped(false), options));
  EXPECT_STREQ(picture.root()->Attribute("width"), "900");
  EXPECT_STREQ(picture.root()->Attribute("height"), "700");
}

TEST(Draw, LegendIsBrokenIntoLinesThatFit) {
  DrawOptions options;
  options.width = 420.0;
  const Picture picture(draw_svg(biped(true), options));
  for (const auto* text = picture.root()->FirstChildElement("text"); text != nullptr; text = text->NextSiblingElement("text")) {
    if (text->Attribute("text-anchor") != nullptr || text->FindAttribute("class")->Value() != std::string("i")) continue;
    EXPECT_LT(text->DoubleAttribute("x") + 5.0 * static_cast<double>(std::string(text->GetText()).size()), 420.0)
        << text->GetText();
  }
}

TEST(Draw, TitleSaysStateCostBoundAndProof) {
  const Picture picture(draw_svg(planar(), {}));
  const auto texts = Picture::texts(picture.root(), "text");
  ASSERT_GE(texts.size(), 2u);
  EXPECT_EQ(texts[0], "planar: SUCCEEDED");
  EXPECT_EQ(texts[1].rfind("12 steps; cost 0.000275 m, proved bound 0.000275 m, optimal (", 0), 0u) << texts[1];
}

TEST(Draw, ErrorIsInTheTitle) {
  Drawing drawing = planar();
  drawing.state = msg::PARTIAL;
  drawing.error.code(402);
  drawing.error.name("UNREACHABLE_GOAL");
  drawing.error.message("7 cycles advance 0.703 m at most");
  const std::string svg = draw_svg(drawing, {});
  EXPECT_NE(svg.find("UNREACHABLE_GOAL: 7 cycles advance 0.703 m at most"), std::string::npos);
}

TEST(Draw, HostileNamesStayText) {
  const std::string hostile = "</text><script>alert(1)</script>&\"'\x01\xFF";
  Drawing drawing = biped(true);
  drawing.robot = hostile;
  drawing.summary->objective(hostile);
  drawing.summary->plugin(hostile);
  drawing.error.code(900);
  drawing.error.name(hostile);
  drawing.error.message(hostile);
  for (msg::Shape& shape : drawing.scene) shape.body(hostile);
  for (msg::Step& one : drawing.steps) {
    one.label(hostile);
    for (msg::Shape& shape : one.shapes()) shape.body(hostile);
    for (msg::Contact& c : one.placed()) c.limb(hostile);
  }
  const std::string svg = draw_svg(drawing, {});
  const Picture picture(svg);
  EXPECT_EQ(svg.find("<script"), std::string::npos);
  EXPECT_EQ(svg.find('\x01'), std::string::npos);
  EXPECT_EQ(svg.find('\xFF'), std::string::npos);
}

TEST(Draw, UprightWallIsALineFromAbove) {
  Drawing drawing;
  drawing.scene = {polygon("wall", {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}), box("roof", 1.0, 0, 2.0, 1.0, 1.0, 0.1)};
  DrawOptions options;
  options.views = Views::kAbove;
  const Picture picture(draw_svg(drawing, options));
  const auto lines = Picture::attributes(picture.part("above"), "e", "d");
  ASSERT_EQ(lines.size(), 2u) << "the long edges, above and below; the upright ones are points";
  for (const std::string& data : lines) {
    const auto numbers = numbers_in(data);
    const auto roof = numbers_in(Picture::attributes(picture.part("above"), "f", "d").front());
    // Half of the wall is under the roof, which spans as much as the wall is long.
    EXPECT_NEAR(std::abs(numbers[2] - numbers[0]),
                0.5 * (std::max({roof[0], roof[2], roof[4]}) - std::min({roof[0], roof[2], roof[4]})), 0.1);
  }
}

TEST(Draw, SceneAloneIsDrawn) {
  Drawing drawing;
  drawing.scene = biped(false).scene;
  const Picture picture(draw_svg(drawing, {}));
  EXPECT_FALSE(Picture::attributes(picture.part("above"), "f", "d").empty());
  EXPECT_EQ(Picture::texts(picture.root(), "text")[1], "no steps");
}

TEST(Draw, BodiesWithoutSizeAreHarmless) {
  Drawing drawing;
  drawing.scene = {box("point", 0, 0, 0, 0, 0, 0), box("sheet", 0, 0, 0, 1, 1, 0), box("stick", 0, 0, 0, 1, 0, 0),
                   sphere("dot", 0, 0, 0, 0), polygon("line", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}})};
  msg::Step one = step(0, pose(0, 0, 0));
  one.shapes(drawing.scene);
  drawing.steps = {one};
  Picture picture(draw_svg(drawing, {}));
}

TEST(Draw, FittedToThePlanItSaysThatTheSceneGoesOn) {
  DrawOptions options;
  options.frame = Frame::kPlan;
  options.first_step = 3;
  options.last_step = 4;
  Drawing drawing = hexapod();
  drawing.start = {};
  drawing.goal = {};
  const std::string svg = draw_svg(drawing, options);
  EXPECT_NE(svg.find("the scene goes on beyond the border"), std::string::npos);
  options.frame = Frame::kScene;
  EXPECT_EQ(draw_svg(drawing, options).find("the scene goes on beyond the border"), std::string::npos);
}

TEST(Draw, EveryViewpointWorks) {
  for (double azimuth = -180.0; azimuth <= 180.0; azimuth += 60.0)
    for (double elevation = -90.0; elevation <= 90.0; elevation += 45.0) {
      DrawOptions options;
      options.azimuth = azimuth;
      options.elevation = elevation;
      Picture picture(draw_svg(biped(false), options));
    }
}

TEST(Draw, ThousandPiecesOfASceneTakeLittleTime) {
  Drawing drawing = hexapod();
  drawing.scene.clear();
  for (int i = 0; i < 1000; ++i)
    drawing.scene.push_back(box("b" + std::to_string(i), 0.1 * (i % 10), 0.1 * (i / 10 % 10), 0.1 * (i / 100), 0.09, 0.12, 0.13));
  const auto begin = std::chrono::steady_clock::now();
  Picture picture(draw_svg(drawing, {}));
  // About half a second in a release build; far more would mean that something grows with the cube of the scene.
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(60));
}

}  // namespace
}  // namespace foothold::drawing
