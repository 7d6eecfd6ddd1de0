// A plugin's schema has to agree with itself; requests have to agree with it.
#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <span>

#include "worker/loader.hpp"
#include "worker/schema.hpp"

namespace foothold::server {
namespace {

constexpr ParameterSpec kSound = {"gait", ParameterKind::kInteger, "1", "3", 0, 10, "", "which gait"};

std::string refusal_of(const PlannerInfo& info) {
  try {
    check_info(info);
    return "";
  } catch (const PluginRefused& refused) {
    return refused.what();
  }
}

PlannerInfo info_with(std::span<const ParameterSpec> specs) {
  return {.name = "mine", .version = "1", .parameters = specs.data(), .parameter_count = specs.size()};
}

std::string refusal_of_spec(const ParameterSpec& spec) { return refusal_of(info_with({&spec, 1})); }

void expect_words(const std::string& sentence, std::initializer_list<std::string> words) {
  EXPECT_FALSE(sentence.empty());
  for (const std::string& word : words) EXPECT_NE(sentence.find(word), std::string::npos) << "'" << word << "' in: " << sentence;
}

TEST(Schema, ASoundOneIsTaken) { EXPECT_EQ(refusal_of_spec(kSound), ""); }

TEST(Schema, RefusesWhatDoesNotAgreeWithItself) {
  ParameterSpec spec = kSound;
  spec.default_value = "11";
  expect_words(refusal_of_spec(spec), {"'mine'", "'gait'", "0 to 10", "is 11"});
  spec = kSound;
  spec.minimum = 20;
  expect_words(refusal_of_spec(spec), {"'gait'", "minimum above its maximum"});
  spec = kSound;
  spec.maximum = std::numeric_limits<double>::infinity();
  expect_words(refusal_of_spec(spec), {"'gait'", "not finite"});
  spec = kSound;
  spec.name = "";
  expect_words(refusal_of_spec(spec), {"without a name"});
  spec = kSound;
  spec.unit = nullptr;
  expect_words(refusal_of_spec(spec), {"null pointer"});
  spec = kSound;
  spec.kind = static_cast<ParameterKind>(9);
  expect_words(refusal_of_spec(spec), {"unknown kind 9"});
  spec = kSound;
  spec.kind = ParameterKind::kChoice;
  expect_words(refusal_of_spec(spec), {"choice of nothing"});
}

TEST(Schema, RefusesARepeatedNameAndAnUndeclaredOne) {
  const std::array twice = {kSound, kSound};
  expect_words(refusal_of(info_with(twice)), {"'gait' twice"});
  PlannerInfo info = info_with({&kSound, 1});
  info.prepare_parameters = "gait|grid";
  expect_words(refusal_of(info), {"'grid'", "prepare_parameters"});
}

TEST(Schema, RefusesAPlannerWithoutNameVersionOrTexts) {
  expect_words(refusal_of({.version = "1"}), {"no name"});
  expect_words(refusal_of({.name = "mine"}), {"'mine'", "no version"});
  expect_words(refusal_of({.name = "mine", .version = "1", .limbs = nullptr}), {"null pointer"});
  expect_words(refusal_of({.name = "mine", .version = "1\x02"}), {"control characters", "'1\\x02'"});
  expect_words(refusal_of({.name = "mine", .version = "1", .parameter_count = 3}), {"null pointer", "parameters"});
}

TEST(Schema, TheWireTellsAllOfIt) {
  const std::array specs = {kSound, ParameterSpec{"method", ParameterKind::kChoice, "", "b", 0, 0, "a|b", "how"}};
  PlannerInfo info = info_with(specs);
  info.joints = "hip|knee";
  const msg::RobotInfo told = describe_robot("left_robot", info);
  EXPECT_EQ(told.name(), "left_robot");
  EXPECT_EQ(told.plugin(), "mine");
  EXPECT_EQ(told.joints(), (std::vector<std::string>{"hip", "knee"}));
  EXPECT_TRUE(told.limbs().empty());
  ASSERT_EQ(told.parameters().size(), 2u);
  EXPECT_EQ(told.parameters()[0].maximum(), 10.0);
  EXPECT_EQ(told.parameters()[1].kind(), msg::CHOICE);
  EXPECT_EQ(told.parameters()[1].choices(), (std::vector<std::string>{"a", "b"}));
}

msg::Parameter given(const std::string& name, const std::string& value) {
  msg::Parameter parameter;
  parameter.name(name);
  parameter.value(value);
  return parameter;
}

TEST(Schema, ARequestGetsTheDefaultsOfWhatItLeavesOut) {
  const std::array specs = {kSound, ParameterSpec{"grid", ParameterKind::kReal, "m", "0.1", 0, 1, "", ""}};
  PlannerInfo info = info_with(specs);
  info.prepare_parameters = "grid";
  const ParsedParameters parsed = parse_parameters(info, {given("gait", "7")});
  EXPECT_EQ(parsed.values.integer("gait"), 7);
  EXPECT_EQ(parsed.values.real("grid"), 0.1);
  ASSERT_EQ(parsed.texts.size(), 2u);
  EXPECT_EQ(parsed.texts[1].value(), "0.1");
  EXPECT_EQ(parsed.prepare_key, "grid=0.1\n") << "gait is nothing to prepare()";
}

TEST(Schema, ARequestOutsideItIsRefusedByName) {
  const PlannerInfo info = info_with({&kSound, 1});
  const auto kind_of = [&](const msg::Parameter& parameter) {
    try {
      parse_parameters(info, {parameter});
    } catch (const ParameterFault& fault) {
      EXPECT_EQ(fault.name, parameter.name());
      return fault.kind;
    }
    ADD_FAILURE() << "was taken";
    return ParameterFault::Kind::kUnknown;
  };
  EXPECT_EQ(kind_of(given("speed", "1")), ParameterFault::Kind::kUnknown);
  EXPECT_EQ(kind_of(given("gait", "99")), ParameterFault::Kind::kOutOfRange);
  EXPECT_EQ(kind_of(given("gait", "fast")), ParameterFault::Kind::kNotOfKind);
}

}  // namespace
}  // namespace foothold::server
