// Reading a robot's numbers.
#include "foothold/model.hpp"

#include <gtest/gtest.h>

#include "foothold/errors.hpp"

namespace foothold {
namespace {

RobotModel sample() {
  return RobotModel({{"piston.retracted", {{0.103}, "m", "derived"}},
                     {"hip.limits", {{-1.5, 1.5}, "rad", "assumed"}},
                     {"legs", {{6.0}, "1", "paper"}},
                     {"nothing", {{}, "m", "assumed"}}});
}

template <class Read>
void expect_refusal(Read&& read, const std::string& field, const std::string& reason) {
  try {
    read();
    FAIL() << "was read";
  } catch (const InvalidModel& refused) {
    EXPECT_EQ(refused.field(), field);
    EXPECT_EQ(std::string(refused.what()), reason);
  }
}

TEST(RobotModel, NumbersAreReadByPathAndUnit) {
  const RobotModel model = sample();
  EXPECT_EQ(model.number("piston.retracted", "m"), 0.103);
  EXPECT_EQ(model.numbers("hip.limits", "rad"), (std::vector<double>{-1.5, 1.5}));
  EXPECT_EQ(model.numbers("hip.limits", "rad", 2).size(), 2u);
  EXPECT_EQ(model.number("legs", "1"), 6.0);
}

TEST(RobotModel, MissingPathIsNamed) {
  expect_refusal([] { (void)sample().number("piston.extended", "m"); }, "piston.extended", "is missing");
  expect_refusal([] { (void)RobotModel().numbers("", "m"); }, "", "is missing");
}

TEST(RobotModel, PathIsNotFoundByItsBeginOrItsEnd) {
  for (const char* path : {"piston", "retracted", "piston.", "piston.retracted.", "Piston.retracted"}) {
    EXPECT_FALSE(sample().has(path)) << path;
    EXPECT_THROW((void)sample().number(path, "m"), InvalidModel) << path;
  }
  EXPECT_TRUE(sample().has("piston.retracted"));
}

TEST(RobotModel, OtherUnitIsRefusedWithBoth) {
  expect_refusal([] { (void)sample().number("piston.retracted", "mm"); }, "piston.retracted", "must be in mm, is in m");
  expect_refusal([] { (void)sample().number("legs", ""); }, "legs", "must be in , is in 1");
}

TEST(RobotModel, ListOfAnotherLengthIsRefusedWithBoth) {
  expect_refusal([] { (void)sample().numbers("hip.limits", "rad", 3); }, "hip.limits", "must hold 3 numbers, holds 2");
  expect_refusal([] { (void)sample().numbers("hip.limits", "rad", 1); }, "hip.limits", "must hold 1 number, holds 2");
}

TEST(RobotModel, OneNumberIsNeitherAListNorNone) {
  expect_refusal([] { (void)sample().number("hip.limits", "rad"); }, "hip.limits", "must hold 1 number, holds 2");
  expect_refusal([] { (void)sample().number("nothing", "m"); }, "nothing", "must hold 1 number, holds 0");
}

TEST(RobotModel, AnyCountTakesWhatIsThere) { EXPECT_TRUE(sample().numbers("nothing", "m").empty()); }

}  // namespace
}  // namespace foothold
