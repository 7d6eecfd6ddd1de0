// Text to value under a schema, at the bounds and beside them.
#include "foothold/parameters.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace foothold {
namespace {

using Kind = ParameterFault::Kind;

constexpr double kHuge = std::numeric_limits<double>::infinity();

ParameterSpec integer(double minimum, double maximum, const char* unit = "1") {
  return {"cycles", ParameterKind::kInteger, unit, "1", minimum, maximum, "", ""};
}
ParameterSpec real(double minimum, double maximum, const char* unit = "m") {
  return {"tolerance", ParameterKind::kReal, unit, "0", minimum, maximum, "", ""};
}
constexpr ParameterSpec kFlag{"resume", ParameterKind::kFlag, "", "false", 0, 0, "", ""};
constexpr ParameterSpec kText{"note", ParameterKind::kText, "", "", 0, 0, "", ""};
constexpr ParameterSpec kMethod{"method", ParameterKind::kChoice, "", "greedy", 0, 0, "greedy|optimal|fewest", ""};

ParameterFault fault_of(const ParameterSpec& spec, std::string_view text) {
  try {
    (void)parse_parameter(spec, text);
  } catch (const ParameterFault& fault) {
    EXPECT_EQ(fault.name, spec.name);
    return fault;
  }
  ADD_FAILURE() << "'" << text << "' was taken";
  return {};
}

std::int64_t integer_of(const ParameterSpec& spec, std::string_view text) {
  return std::get<std::int64_t>(parse_parameter(spec, text));
}
double real_of(const ParameterSpec& spec, std::string_view text) { return std::get<double>(parse_parameter(spec, text)); }

TEST(Parameters, FlagIsTrueOrFalseAndNothingElse) {
  EXPECT_TRUE(std::get<bool>(parse_parameter(kFlag, "true")));
  EXPECT_FALSE(std::get<bool>(parse_parameter(kFlag, "false")));
  for (const char* text : {"", "True", "TRUE", "1", "0", "yes", " true", "true ", "truefalse"}) {
    const ParameterFault fault = fault_of(kFlag, text);
    EXPECT_EQ(fault.kind, Kind::kNotOfKind);
    EXPECT_NE(fault.message.find(std::string("'") + text + "'"), std::string::npos) << fault.message;
  }
}

TEST(Parameters, IntegersBoundsAreIncluded) {
  const ParameterSpec spec = integer(-3, 7);
  EXPECT_EQ(integer_of(spec, "-3"), -3);
  EXPECT_EQ(integer_of(spec, "7"), 7);
  EXPECT_EQ(integer_of(spec, "007"), 7);
  EXPECT_EQ(fault_of(spec, "-4").kind, Kind::kOutOfRange);
  EXPECT_EQ(fault_of(spec, "8").kind, Kind::kOutOfRange);
  EXPECT_EQ(fault_of(spec, "8").message, "must be -3 to 7, is 8");
}

TEST(Parameters, IntegerIsAWholeDecimalNumberAndNothingMore) {
  for (const char* text : {"", "-", "+1", " 1", "1 ", "1.0", "1e3", "0x10", "1,000", "one", "--1", "\xD9\xA1"}) {
    const ParameterFault fault = fault_of(integer(-1e6, 1e6), text);
    EXPECT_EQ(fault.kind, Kind::kNotOfKind) << text;
    EXPECT_NE(fault.message.find("a whole number"), std::string::npos) << fault.message;
  }
}

TEST(Parameters, TextAfterAZeroOctetCounts) {
  EXPECT_EQ(fault_of(integer(0, 9), std::string_view("1\0", 2)).kind, Kind::kNotOfKind);
}

TEST(Parameters, IntegersAtTheEndsOf64Bits) {
  const ParameterSpec spec = integer(-kHuge, kHuge);
  EXPECT_EQ(integer_of(spec, "9223372036854775807"), std::numeric_limits<std::int64_t>::max());
  EXPECT_EQ(integer_of(spec, "-9223372036854775808"), std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(fault_of(spec, "9223372036854775808").kind, Kind::kOutOfRange);
  EXPECT_EQ(fault_of(spec, "-9223372036854775809").kind, Kind::kOutOfRange);
  EXPECT_EQ(fault_of(spec, "9223372036854775808x").kind, Kind::kNotOfKind);
}

// Beyond 2^53 doubles leave integers out: a comparison in doubles lets the next one above the maximum through.
TEST(Parameters, IntegerJustAboveALargeMaximumIsRefused) {
  const ParameterSpec spec = integer(0, 9007199254740992.0);
  EXPECT_EQ(integer_of(spec, "9007199254740992"), 9007199254740992);
  EXPECT_EQ(fault_of(spec, "9007199254740993").kind, Kind::kOutOfRange);
}

TEST(Parameters, RealsBoundsAreIncluded) {
  const ParameterSpec spec = real(0.001, 0.1);
  EXPECT_EQ(real_of(spec, "0.001"), 0.001);
  EXPECT_EQ(real_of(spec, "0.1"), 0.1);
  EXPECT_EQ(real_of(spec, "1e-2"), 0.01);
  EXPECT_EQ(fault_of(spec, "0.10000000000000002").kind, Kind::kOutOfRange);
  EXPECT_EQ(fault_of(spec, "0.00099999999999999980").kind, Kind::kOutOfRange);
  EXPECT_EQ(fault_of(spec, "0.2").message, "must be 0.001 to 0.1 m, is 0.2");
}

TEST(Parameters, RealIsADecimalNumberAndNothingMore) {
  for (const char* text : {"", ".", "-", "+1", " 1", "1 ", "1,5", "1.5m", "0x1p3", "1e", "five", "1.2.3"}) {
    const ParameterFault fault = fault_of(real(-1e6, 1e6), text);
    EXPECT_EQ(fault.kind, Kind::kNotOfKind) << text;
    EXPECT_NE(fault.message.find("must be a number"), std::string::npos) << fault.message;
  }
}

TEST(Parameters, NotANumberIsInNoRange) {
  for (const char* text : {"nan", "NaN", "-nan"}) EXPECT_EQ(fault_of(real(-kHuge, kHuge), text).kind, Kind::kOutOfRange) << text;
}

TEST(Parameters, InfinityIsOutOfEveryFiniteRange) {
  EXPECT_EQ(fault_of(real(0.0, 1e308), "inf").kind, Kind::kOutOfRange);
  EXPECT_EQ(fault_of(real(-1e308, 0.0), "-inf").kind, Kind::kOutOfRange);
  EXPECT_EQ(real_of(real(0.0, kHuge), "inf"), kHuge);
}

TEST(Parameters, RealTooLargeForADoubleIsOutOfRange) {
  EXPECT_EQ(fault_of(real(0.0, kHuge), "1e999").kind, Kind::kOutOfRange);
  EXPECT_EQ(fault_of(real(-kHuge, 0.0), "-1e999").kind, Kind::kOutOfRange);
}

TEST(Parameters, NegativeZeroIsWithinBoundsFromZero) { EXPECT_EQ(real_of(real(0.0, 1.0), "-0"), 0.0); }

TEST(Parameters, RefusalTellsBoundsExactlyEnough) {
  EXPECT_EQ(fault_of(integer(0, 12345678, ""), "12345679").message, "must be 0 to 12345678, is 12345679");
  EXPECT_EQ(fault_of(real(0, 0.123456789, "rad"), "0.2").message, "must be 0 to 0.123456789 rad, is 0.2");
}

TEST(Parameters, ChoiceIsOneWholeWord) {
  for (const char* word : {"greedy", "optimal", "fewest"}) EXPECT_EQ(std::get<std::string>(parse_parameter(kMethod, word)), word);
  for (const char* text : {"", "greed", "greedyy", "Greedy", "optimal|fewest", "greedy|", "|", " greedy", "fewest "}) {
    const ParameterFault fault = fault_of(kMethod, text);
    EXPECT_EQ(fault.kind, Kind::kOutOfRange) << text;
    EXPECT_EQ(fault.message, std::string("must be one of greedy|optimal|fewest, is '") + text + "'");
  }
}

TEST(Parameters, ChoiceOfOneWord) {
  ParameterSpec spec = kMethod;
  spec.choices = "only";
  EXPECT_EQ(std::get<std::string>(parse_parameter(spec, "only")), "only");
  EXPECT_EQ(fault_of(spec, "").kind, Kind::kOutOfRange);
}

TEST(Parameters, TextIsTakenAsItIs) {
  for (const char* text : {"", " ", "any words", "a|b", "\xC3\xB1"})
    EXPECT_EQ(std::get<std::string>(parse_parameter(kText, text)), text);
  const std::string with_zero("a\0b", 3);
  EXPECT_EQ(std::get<std::string>(parse_parameter(kText, with_zero)), with_zero);
}

TEST(Parameters, KindThatDoesNotExistIsAMistakeOfThePlugin) {
  ParameterSpec spec = kText;
  spec.kind = static_cast<ParameterKind>(17);
  EXPECT_THROW((void)parse_parameter(spec, "x"), std::logic_error);
}

TEST(Parameters, EachKindIsReadBackAsItself) {
  const Parameters parameters(
      {{"resume", true}, {"cycles", std::int64_t{7}}, {"tolerance", 0.5}, {"method", std::string("greedy")}});
  EXPECT_TRUE(parameters.flag("resume"));
  EXPECT_EQ(parameters.integer("cycles"), 7);
  EXPECT_EQ(parameters.real("tolerance"), 0.5);
  EXPECT_EQ(parameters.text("method"), "greedy");
  EXPECT_EQ(parameters.values().size(), 4u);
}

TEST(Parameters, ReadingAnUndeclaredNameSaysWhich) {
  try {
    (void)Parameters().real("tolerance");
    FAIL() << "was read";
  } catch (const std::logic_error& error) {
    EXPECT_STREQ(error.what(), "parameter 'tolerance' is not in the plugin's schema");
  }
}

TEST(Parameters, ReadingAsAnotherKindSaysWhich) {
  const Parameters parameters({{"cycles", std::int64_t{7}}});
  EXPECT_THROW((void)parameters.flag("cycles"), std::logic_error);
  EXPECT_THROW((void)parameters.text("cycles"), std::logic_error);
  try {
    (void)parameters.real("cycles");
    FAIL() << "was read";
  } catch (const std::logic_error& error) {
    EXPECT_STREQ(error.what(), "parameter 'cycles' is read as another kind than its schema says");
  }
}

}  // namespace
}  // namespace foothold
