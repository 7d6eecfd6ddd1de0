// config/robots/*.yaml to numbers in SI: units, and every refusal with file, line and field.
#include "foothold/errors.hpp"
#include "foothold/robot_file.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "temporary_folder.hpp"

namespace foothold {
namespace {

// A file in the test's own folder that is gone with it.
class RobotFile : public testing::Test {
 protected:
  std::string write(const std::string& text) const {
    const std::string path = folder_ / "robot.yaml";
    std::ofstream(path) << text;
    return path;
  }
  RobotModel load(const std::string& text) const { return load_robot_model(write(text)); }

  // `model` is what stands under "model:", indented; its first line is line 2 of the file.
  void expect_refusal(const std::string& model, const std::string& field, int line, const std::string& reason) const {
    expect_refusal_of_file("model:\n" + model, field, line, reason);
  }
  void expect_refusal_of_file(const std::string& text, const std::string& field, int line, const std::string& reason) const {
    try {
      load(text);
      ADD_FAILURE() << "was taken: " << text;
    } catch (const FileError& refused) {
      EXPECT_EQ(refused.field(), field) << text;
      const std::string begin = folder_ / "robot.yaml" + ":" + std::to_string(line) + ": " + (field.empty() ? "" : field + ": ");
      EXPECT_EQ(std::string(refused.what()).rfind(begin, 0), 0u) << refused.what() << "\nshould begin with " << begin;
      EXPECT_NE(std::string(refused.what()).find(reason), std::string::npos) << refused.what();
    }
  }

  test::TemporaryFolder folder_;
};

TEST_F(RobotFile, TheTextOfAUrdfTravelsWithTheModel) {
  std::ofstream(folder_ / "two legs.urdf") << "<robot/>";
  const RobotModel model = load("model:\n  urdf: two legs.urdf\n  l: {value: 1, unit: m, source: paper}\n");
  EXPECT_EQ(model.text("urdf"), "<robot/>");
  EXPECT_TRUE(model.has_text("urdf"));
  EXPECT_EQ(model.number("l", "m"), 1.0);
  EXPECT_FALSE(load("model:\n  l: {value: 1, unit: m, source: paper}\n").has_text("urdf"));
  EXPECT_THROW(load("model:\n  l: {value: 1, unit: m, source: paper}\n").text("urdf"), InvalidModel);

  std::ofstream(folder_ / "empty.urdf");
  std::ofstream(folder_ / "long.urdf") << std::string((4 << 20) + 1, ' ');
  expect_refusal("  urdf: none.urdf", "model.urdf", 2, "is no file");
  expect_refusal("  urdf: .", "model.urdf", 2, "is no file");
  expect_refusal("  urdf: /dev/zero", "model.urdf", 2, "is no file");
  expect_refusal("  urdf: empty.urdf", "model.urdf", 2, "is empty");
  expect_refusal("  urdf: long.urdf", "model.urdf", 2, "at most 4 MiB");
  expect_refusal("  urdf: [a.urdf]", "model.urdf", 2, "must be the name of a file");
  std::ofstream(folder_ / "full.urdf") << "<robot/>";
  expect_refusal("  urdf: full.urdf\n  urdf: full.urdf", "model.urdf", 3, "is given twice");
}

TEST_F(RobotFile, EveryUnitIsConvertedToItsSiUnit) {
  struct Case {
    const char* unit;
    const char* si;
    double one;
  };
  const Case cases[] = {{"m", "m", 1.0},
                        {"cm", "m", 0.01},
                        {"mm", "m", 0.001},
                        {"rad", "rad", 1.0},
                        {"deg", "rad", M_PI / 180.0},
                        {"kg", "kg", 1.0},
                        {"g", "kg", 0.001},
                        {"s", "s", 1.0},
                        {"m/s", "m/s", 1.0},
                        {"ms", "s", 0.001},
                        {"N", "N", 1.0},
                        {"Nm", "Nm", 1.0},
                        {"rpm", "rad/s", M_PI / 30.0},
                        {"rad/s", "rad/s", 1.0},
                        {"1", "1", 1.0}};
  for (const Case& one : cases) {
    const RobotModel model = load("model:\n  x: {value: 250, unit: " + std::string(one.unit) + ", source: assumed}\n");
    EXPECT_DOUBLE_EQ(model.number("x", one.si), 250.0 * one.one) << one.unit;
  }
}

TEST_F(RobotFile, PathsAreJoinedByDotsAndListsKeepTheirOrder) {
  const RobotModel model = load(
      "robot: r\nmodel:\n  hip:\n    yaw:\n      limits: {value: [-90, 0, 45.5], unit: deg, source: 'public: two code bases', "
      "note: free}\n"
      "  mass: {value: 1.7, unit: kg, source: assumed}\n");
  const auto& limits = model.numbers("hip.yaw.limits", "rad", 3);
  EXPECT_DOUBLE_EQ(limits[0], -M_PI / 2.0);
  EXPECT_EQ(limits[1], 0.0);
  EXPECT_DOUBLE_EQ(limits[2], 45.5 * M_PI / 180.0);
  EXPECT_EQ(model.number("mass", "kg"), 1.7);
  EXPECT_EQ(model.quantities().size(), 2u);
  EXPECT_EQ(model.quantities().at("hip.yaw.limits").source, "public: two code bases");
}

TEST_F(RobotFile, NumbersMayBeWrittenInEveryUsualWay) {
  for (const char* text : {"1500", "1.5e3", "1500.0", "+1500", "'1500'"})
    EXPECT_EQ(load(std::string("model:\n  x: {value: ") + text + ", unit: m, source: paper}\n").number("x", "m"), 1500.0) << text;
  EXPECT_EQ(load("model:\n  x: {value: -0.25, unit: m, source: paper}\n").number("x", "m"), -0.25);
}

TEST_F(RobotFile, SourceIsOneOfFourTagsAsAWholeWord) {
  for (const char* source : {"paper", "'paper: b'", "public", "derived from b", "'assumed, for drawing'"})
    EXPECT_NO_THROW(load(std::string("model:\n  x: {value: 1, unit: m, source: ") + source + "}\n")) << source;
  for (const char* source : {"''", "guessed", "Paper", "' paper'", "paperclip", "assumedly", "[paper]"})
    expect_refusal(std::string("  x: {value: 1, unit: m, source: ") + source + "}\n", "model.x.source", 2,
                   "must begin with paper, public, derived or assumed");
}

TEST_F(RobotFile, WhatIsMissingIsNamed) {
  expect_refusal("  a:\n    x: {value: 1, source: paper}\n", "model.a.x.unit", 3, "is missing");
  expect_refusal("  a:\n    x: {value: 1, unit: m}\n", "model.a.x.source", 3, "is missing (paper, public, derived or assumed");
  expect_refusal_of_file("robot: xrobin\n", "model", 1, "is missing");
}

TEST_F(RobotFile, QuantityWithoutValueIsTakenForAGroupAndItsPartsRefused) {
  expect_refusal("  x: {unit: m, source: paper}\n", "model.x.unit", 2, "must be a map of quantities, or {value: ...");
}

TEST_F(RobotFile, UnknownPartsUnitsAndValuesAreRefused) {
  expect_refusal("  x: {value: 1, unit: m, source: paper, sorce: p}\n", "model.x.sorce", 2, "is not a part of a quantity");
  for (const char* unit : {"inch", "MM", "''", "[m]", "m/h", "2"})
    expect_refusal(std::string("  x: {value: 1, unit: ") + unit + ", source: paper}\n", "model.x.unit", 2,
                   "must be one of m, cm, mm, rad, deg, kg, g, s, ms, N, Nm, 1, m/s, rad/s, rpm; is '");
  for (const char* value : {"", "~", "one", "1 m", "0x10", "1_000", "'1,5'", "{a: 1}", "[[1]]", "[1, two]", "1.2.3"})
    expect_refusal(std::string("  x: {value: ") + value + ", unit: m, source: paper}\n", "model.x.value", 2, "must be a number");
  for (const char* value : {".inf", "-.inf", ".nan", "[1, .inf]"})
    expect_refusal(std::string("  x: {value: ") + value + ", unit: m, source: paper}\n", "model.x.value", 2, "must be finite");
  expect_refusal("  x: {value: [], unit: m, source: paper}\n", "model.x.value", 2, "must hold one number at least");
}

TEST_F(RobotFile, BareNumbersAreRefused) {
  expect_refusal("  piston:\n    retracted: 103\n", "model.piston.retracted", 3, "must be a map of quantities");
  expect_refusal("  - 1\n", "model", 2, "must be a map of quantities");
  expect_refusal_of_file("model:\n", "model", 2, "must be a map of quantities");
}

TEST_F(RobotFile, WhatIsGivenTwiceIsRefused) {
  const std::string one = "x: {value: 1, unit: m, source: paper}\n";
  expect_refusal("  " + one + "  " + one, "model.x", 3, "is given twice");
  expect_refusal("  a:\n    " + one + "  a.x: {value: 2, unit: m, source: paper}\n", "model.a.x", 4, "is given twice");
  expect_refusal("  x: {value: 1, value: 2, unit: m, source: paper}\n", "model.x.value", 2, "is given twice");
}

TEST_F(RobotFile, WhatIsNoYamlIsRefusedWithItsLine) {
  expect_refusal_of_file("model:\n  x: {value: 1, unit: m\n  y: ]\n", "", 3, "");
  expect_refusal_of_file("", "", 1, "must be a map with the keys robot, plugin, model");
  expect_refusal_of_file("- model\n", "", 1, "must be a map with the keys");
  expect_refusal_of_file("just words\n", "", 1, "must be a map with the keys");
}

TEST_F(RobotFile, FileThatIsNotThereIsNamed) {
  try {
    (void)load_robot_model(folder_ / "nobody.yaml");
    FAIL() << "was read";
  } catch (const FileError& refused) {
    EXPECT_NE(std::string(refused.what()).find(folder_ / "nobody.yaml"), std::string::npos);
    EXPECT_NE(std::string(refused.what()).find("cannot be read"), std::string::npos);
  }
}

TEST_F(RobotFile, EveryPrefixOfASoundFileIsTakenOrRefusedWithoutACrash) {
  const std::string text =
      "robot: r\nmodel:\n  a:\n    x: {value: [1, 2], unit: mm, source: \"paper: t\"}\n  m: {value: 2, unit: kg, source: "
      "assumed}\n";
  for (std::size_t size = 0; size <= text.size(); ++size) {
    try {
      (void)load(text.substr(0, size));
    } catch (const FileError& refused) {
      EXPECT_NE(std::string(refused.what()).find("robot.yaml:"), std::string::npos);
    }
  }
}

TEST(ShippedRobotFiles, AreSound) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(FOOTHOLD_ROBOTS)) {
    if (entry.path().extension() != ".yaml") continue;
    ++count;
    EXPECT_FALSE(load_robot_model(entry.path().string()).quantities().empty()) << entry.path();
  }
  EXPECT_GE(count, 1);
}

}  // namespace
}  // namespace foothold
