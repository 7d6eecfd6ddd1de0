// P4: every way in which a request can be malformed, each refused with its code and the path of the field at fault.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "fakes.hpp"
#include "jobs/admission/admission.hpp"
#include "jobs/admission/limits.hpp"
#include "text/text.hpp"

namespace foothold::server::testing {
namespace {

using msg::PlanRequest;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

struct Case {
  const char* name;
  std::function<void(PlanRequest&)> spoil;
  std::uint16_t code;
  const char* field;
};

msg::Pose& base(PlanRequest& r) { return r.goal().base().at(0); }

// The third of three contacts of the start, so that the index shows.
msg::Contact& contact(PlanRequest& r) {
  r.start().contacts().resize(3);
  for (auto& c : r.start().contacts()) c.frame().orientation().w(1.0);
  return r.start().contacts()[2];
}

std::function<void(PlanRequest&)> parameter(const std::string& name, const std::string& value) {
  return [=](PlanRequest& r) {
    msg::Parameter p;
    p.name(name);
    p.value(value);
    r.parameters().push_back(p);
  };
}

const std::vector<Case>& cases() {
  static const std::vector<Case> all = {
      {"ZeroId", [](auto& r) { r.id(msg::kNoId); }, msg::MALFORMED, "id"},
      {"ZeroClient", [](auto& r) { r.client(msg::kNoId); }, msg::MALFORMED, "client"},
      {"RobotTooLong", [](auto& r) { r.robot(std::string(65, 'r')); }, msg::OVERSIZE, "robot"},
      {"RobotUnknown", [](auto& r) { r.robot("wanderer"); }, msg::UNKNOWN_ROBOT, "robot"},
      {"RobotEmpty", [](auto& r) { r.robot(""); }, msg::UNKNOWN_ROBOT, "robot"},
      {"RobotNotUtf8", [](auto& r) { r.robot("wal\xff"); }, msg::MALFORMED, "robot"},
      {"RobotWithNewline", [](auto& r) { r.robot("walker\n"); }, msg::MALFORMED, "robot"},
      {"UnitTooLong", [](auto& r) { r.unit(std::string(129, 'u')); }, msg::OVERSIZE, "unit"},
      {"UnitOverlongUtf8", [](auto& r) { r.unit("\xc0\xaf"); }, msg::MALFORMED, "unit"},
      {"SceneTooLong", [](auto& r) { r.scene(std::string(65, 's')); }, msg::OVERSIZE, "scene"},
      {"SceneUnknown", [](auto& r) { r.scene("moon"); }, msg::UNKNOWN_SCENE, "scene"},
      {"SceneMissing", [](auto& r) { r.scene_revision(std::string(64, 'a')); }, msg::MALFORMED, "scene"},
      {"RevisionNotHex", [](auto& r) { r.scene("yard"), r.scene_revision(std::string(64, 'g')); }, msg::MALFORMED,
       "scene_revision"},
      {"RevisionUpperCase", [](auto& r) { r.scene("yard"), r.scene_revision(std::string(64, 'A')); }, msg::MALFORMED,
       "scene_revision"},
      {"RevisionShort", [](auto& r) { r.scene("yard"), r.scene_revision("abc"); }, msg::MALFORMED, "scene_revision"},
      {"RevisionUnknown", [](auto& r) { r.scene("yard"), r.scene_revision(std::string(64, 'c')); }, msg::UNKNOWN_REVISION,
       "scene_revision"},
      {"TooManyContacts", [](auto& r) { r.start().contacts().resize(65); }, msg::OVERSIZE, "start.contacts"},
      {"LimbTooLong", [](auto& r) { contact(r).limb(std::string(65, 'l')); }, msg::OVERSIZE, "start.contacts[2].limb"},
      {"LimbWithControl", [](auto& r) { contact(r).limb("left\x1b"); }, msg::MALFORMED, "start.contacts[2].limb"},
      {"FaceTooLong", [](auto& r) { contact(r).face(std::string(65, 'f')); }, msg::OVERSIZE, "start.contacts[2].face"},
      {"ContactNan", [](auto& r) { contact(r).frame().position().y(kNan); }, msg::NOT_FINITE, "start.contacts[2].frame.position"},
      {"ContactNotUnit", [](auto& r) { contact(r).frame().orientation().w(0.5); }, msg::NOT_UNIT,
       "start.contacts[2].frame.orientation"},
      {"TwoBases", [](auto& r) { r.goal().base().push_back(base(r)); }, msg::OVERSIZE, "goal.base"},
      {"BaseNan", [](auto& r) { base(r).position().x(kNan); }, msg::NOT_FINITE, "goal.base.position"},
      {"BaseInfinite", [](auto& r) { base(r).position().z(-kInf); }, msg::NOT_FINITE, "goal.base.position"},
      {"OrientationNan", [](auto& r) { base(r).orientation().z(kNan); }, msg::NOT_FINITE, "goal.base.orientation"},
      {"OrientationZero", [](auto& r) { base(r).orientation().w(0.0); }, msg::NOT_UNIT, "goal.base.orientation"},
      {"OrientationTooLong", [](auto& r) { base(r).orientation().w(1.0 + 2e-6); }, msg::NOT_UNIT, "goal.base.orientation"},
      {"OrientationHuge", [](auto& r) { base(r).orientation().w(1e308), base(r).orientation().x(1e308); }, msg::NOT_UNIT,
       "goal.base.orientation"},
      {"TooManyJoints", [](auto& r) { r.start().joints().resize(257); }, msg::OVERSIZE, "start.joints"},
      {"JointNan",
       [](auto& r) {
         r.goal().joints({0, 1, kNan});
       },
       msg::NOT_FINITE, "goal.joints[2]"},
      {"BudgetZero", [](auto& r) { r.budget(0.0); }, msg::MALFORMED, "budget"},
      {"BudgetNegative", [](auto& r) { r.budget(-1.0); }, msg::MALFORMED, "budget"},
      {"BudgetNan", [](auto& r) { r.budget(kNan); }, msg::NOT_FINITE, "budget"},
      {"BudgetInfinite", [](auto& r) { r.budget(kInf); }, msg::NOT_FINITE, "budget"},
      {"BudgetAboveTheServers", [](auto& r) { r.budget(3600.001); }, msg::MALFORMED, "budget"},
      {"TooManyParameters", [](auto& r) { r.parameters().resize(65); }, msg::OVERSIZE, "parameters"},
      {"ParameterNameTooLong", parameter(std::string(65, 'p'), "1"), msg::OVERSIZE, "parameters[0].name"},
      {"ParameterNameNotText", parameter("cyc\x01les", "1"), msg::MALFORMED, "parameters[0].name"},
      {"ParameterValueTooLong", parameter("note", std::string(1025, 'v')), msg::OVERSIZE, "parameters.note"},
      {"ParameterValueNotText", parameter("note", "a\x7f"), msg::MALFORMED, "parameters.note"},
      {"ParameterUnknown", parameter("cyclos", "7"), msg::UNKNOWN_PARAMETER, "parameters.cyclos"},
      {"ParameterTwice", [](auto& r) { parameter("cycles", "7")(r), parameter("cycles", "7")(r); }, msg::MALFORMED,
       "parameters.cycles"},
      {"IntegerNotANumber", parameter("cycles", "seven"), msg::MALFORMED, "parameters.cycles"},
      {"IntegerWithFraction", parameter("cycles", "7.5"), msg::MALFORMED, "parameters.cycles"},
      {"IntegerEmpty", parameter("cycles", ""), msg::MALFORMED, "parameters.cycles"},
      {"IntegerTooLarge", parameter("cycles", "31"), msg::PARAMETER_OUT_OF_RANGE, "parameters.cycles"},
      {"IntegerTooSmall", parameter("cycles", "0"), msg::PARAMETER_OUT_OF_RANGE, "parameters.cycles"},
      {"IntegerBeyond64Bits", parameter("cycles", "99999999999999999999"), msg::PARAMETER_OUT_OF_RANGE, "parameters.cycles"},
      {"RealNotANumber", parameter("gain", "much"), msg::MALFORMED, "parameters.gain"},
      {"RealOutOfRange", parameter("gain", "1.0000001"), msg::PARAMETER_OUT_OF_RANGE, "parameters.gain"},
      {"RealNan", parameter("gain", "nan"), msg::NOT_FINITE, "parameters.gain"},
      {"RealInfinite", parameter("gain", "inf"), msg::NOT_FINITE, "parameters.gain"},
      {"FlagNeither", parameter("careful", "yes"), msg::MALFORMED, "parameters.careful"},
      {"ChoiceUnknown", parameter("method", "best"), msg::PARAMETER_OUT_OF_RANGE, "parameters.method"},
      {"WholeTooLarge",
       [](auto& r) {
         for (auto* p : {&r.start(), &r.goal()}) {
           p->contacts().resize(64);
           p->joints().resize(256);
           for (auto& c : p->contacts()) {
             c.limb(std::string(64, 'l'));
             c.face(std::string(64, 'f'));
             c.frame().orientation().w(1.0);
           }
         }
         for (int i = 0; i < 48; ++i) parameter("note", std::string(1024, 'n'))(r);
       },
       msg::OVERSIZE, "request"},
  };
  return all;
}

class Malformed : public ::testing::TestWithParam<Case> {};

TEST_P(Malformed, IsRejectedWithItsField) {
  World world;
  auto request = good_request();
  GetParam().spoil(request);
  world.submit(request);
  const auto event = world.last(request.id(), request.client());
  EXPECT_EQ(event.state(), msg::REJECTED);
  EXPECT_EQ(event.error().name(), msg::make_error(GetParam().code, "").name());
  EXPECT_EQ(event.error().field(), GetParam().field);
  EXPECT_EQ(event.error().message().rfind(event.error().field(), 0), 0U) << event.error().message();
  EXPECT_LT(event.error().message().size(), 400U);
  EXPECT_TRUE(is_clean_text(event.error().message())) << event.error().message();
  EXPECT_TRUE(world.planners.runs.empty());
}

INSTANTIATE_TEST_SUITE_P(P4, Malformed, ::testing::ValuesIn(cases()), [](const auto& tested) { return tested.param.name; });

TEST(P4, TheGoodRequestIsGoodAndSoAreTheLimitsThemselves) {
  World world;
  world.submit(good_request());
  EXPECT_EQ(world.state(good_request().id()), msg::RUNNING);
  auto request = good_request("at the limits");
  request.robot("walker");
  request.unit("\u00e4" + std::string(126, 'u'));
  request.scene("yard");
  request.scene_revision(std::string(64, 'a'));
  request.budget(3600.0);
  contact(request).limb(std::string(64, 'l'));
  request.start().joints().resize(256);
  base(request).orientation().w(1.0 - 0.9e-6);
  parameter("cycles", "30")(request);
  parameter("gain", "1")(request);
  parameter("careful", "false")(request);
  parameter("method", "optimal")(request);
  parameter("note", std::string(1024, 'n'))(request);
  world.submit(request);
  EXPECT_EQ(world.state(request.id()), msg::RUNNING) << world.last(request.id()).error().message();
}

TEST(P4, TheFirstFieldAtFaultIsNamed) {
  World world;
  auto request = good_request();
  request.budget(-1.0);
  request.goal().joints({kNan});
  world.submit(request);
  EXPECT_EQ(world.last(request.id()).error().field(), "goal.joints[0]");
}

TEST(Text, QuotesWhatIsNotCleanAndCutsWhatIsLong) {
  EXPECT_EQ(server::quoted("a\x01\xff"), "'a\\x01\\xff'");
  EXPECT_EQ(server::quoted("gr\u00fcn"), "'gr\u00fcn'");
  EXPECT_LT(server::quoted(std::string(1000, 'x')).size(), 120U);
  EXPECT_TRUE(is_clean_text("\U0001F43E"));
  EXPECT_FALSE(is_clean_text("\xed\xa0\x80")) << "a surrogate";
  EXPECT_FALSE(is_clean_text("\xf4\x90\x80\x80")) << "beyond Unicode";
  EXPECT_FALSE(is_clean_text("\xe2\x82")) << "cut off";
  EXPECT_FALSE(is_clean_text("\xc2\x85")) << "a control character of Latin-1";
}

}  // namespace
}  // namespace foothold::server::testing
