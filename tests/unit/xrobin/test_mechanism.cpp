// The eight configurations from the piston lengths, and the end points that the paper prints.
#include <gtest/gtest.h>

#include <stdexcept>

#include "fixtures.hpp"
#include "foothold/errors.hpp"
#include "word.hpp"

namespace foothold::xrobin {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

struct Row {
  const char* state;
  double phi;  // deg
  double y;    // mm
};
constexpr Row kTable[] = {{"11U", 0, 50.24},  {"01V", -45, 21.95}, {"00V", -90, 0}, {"10V", -45, -21.95},
                          {"11V", 0, -50.24}, {"01U", 45, -21.95}, {"00U", 90, 0},  {"10U", 45, 21.95}};

TEST(Mechanism, HasTheEightConfigurationsOfThePapersFigure2) {
  const Mechanism m = mechanism();
  for (int number = 1; number <= 8; ++number) {
    const Configuration& c = m.configuration(number);
    const Row& row = kTable[number - 1];
    EXPECT_EQ(c.number, number);
    EXPECT_EQ(c.l_extended, row.state[0] == '1') << number;
    EXPECT_EQ(c.r_extended, row.state[1] == '1') << number;
    EXPECT_EQ(c.solution, row.state[2]) << number;
    EXPECT_NEAR(c.phi, row.phi * kDegree, 0.005 * kDegree) << number;
    EXPECT_NEAR(c.y, row.y * 1e-3, 0.006e-3) << number;
  }
}

TEST(Mechanism, ClosesTheChainInEveryConfiguration) {
  for (const Lengths& lengths : {mechanism().lengths(), with_exact_turns(0.103, 0.130), Lengths{0.02, 0.1, 0.105, 0.135}}) {
    const Mechanism m(lengths);
    for (const Configuration& c : m.configurations()) {
      const Pistons is = m.pistons(c.phi, c.y);
      const Pistons should = m.pistons(c.number);
      EXPECT_NEAR(is.l, should.l, 1e-14) << c.number;
      EXPECT_NEAR(is.r, should.r, 1e-14) << c.number;
      EXPECT_NEAR(c.phi, c.quarter_turns * m.quarter_turn() + c.eighth_turns * m.eighth_turn(), 1e-15) << c.number;
    }
  }
}

TEST(Mechanism, ExactTurnsGiveTheLengthsThatThePaperPrintsRounded) {
  const Lengths exact = with_exact_turns(0.103, 0.130);
  EXPECT_NEAR(exact.b, 18.5905e-3, 0.00005e-3);
  EXPECT_NEAR(exact.p, 101.3084e-3, 0.00005e-3);
  const Mechanism m(exact);
  EXPECT_NEAR(m.quarter_turn(), 90 * kDegree, 1e-13);
  EXPECT_NEAR(m.eighth_turn(), 45 * kDegree, 1e-13);
  EXPECT_THROW(with_exact_turns(0.103, 0.300), std::domain_error);
}

TEST(Mechanism, RefusesLengthsWithoutEightConfigurationsByName) {
  const auto field_of = [](const Lengths& lengths) -> std::string {
    try {
      Mechanism m(lengths);
      return "accepted";
    } catch (const InvalidModel& fault) {
      return fault.field();
    }
  };
  EXPECT_EQ(field_of({0.0, 0.1, 0.103, 0.13}), "slot.half_width");
  EXPECT_EQ(field_of({0.0186, -0.1, 0.103, 0.13}), "rail.half_width");
  EXPECT_EQ(field_of({0.0186, 0.1013, 0.08, 0.13}), "piston.retracted");
  EXPECT_EQ(field_of({0.0186, 0.1013, 0.125, 0.13}), "piston.retracted");
  EXPECT_EQ(field_of({0.0186, 0.1013, 0.103, 0.115}), "piston.extended");
  EXPECT_EQ(field_of({0.0186, 0.1013, 0.103, 0.4}), "piston.extended");
}

struct Printed {
  double target_x, target_y;  // mm
  std::vector<int> first, second;
  double end_x, end_y, error;  // mm
};

TEST(Word, PrintedVectorsEndWherePublishedNumbersPutThem) {
  const Mechanism m = mechanism();
  const Printed examples[] = {{400, 400, {2, 1, 1, 1, 1, 1, 8}, {5, 5, 5, 5, 5, 6, 4}, 399.177, 399.119, 1.21},
                              {200, 200, {2, 1, 1, 7, 1, 1, 1}, {5, 5, 5, 2, 1, 1, 1}, 199.589, 199.564, 0.60},
                              {1000, 1000, {1, 1, 2, 1, 1, 1, 1}, {5, 5, 5, 5, 5, 5, 5}, 319.744, 542.608, 819.73}};
  for (const Printed& example : examples) {
    const PlanarPose end = forward(m, from_paper(example.first, example.second));
    EXPECT_NEAR(end.x * 1e3, example.end_x, 1e-3);
    EXPECT_NEAR(end.y * 1e3, example.end_y, 1e-3);
    EXPECT_NEAR(std::hypot(end.x * 1e3 - example.target_x, end.y * 1e3 - example.target_y), example.error, 0.006);
  }
}

TEST(Word, TracesBothBodiesHalfCycleByHalfCycle) {
  const Mechanism m = mechanism();
  const Word word{2, 5, 1, 7, 3, 8};
  const PlanarPose start{0.3, -0.2, 0.7};
  const std::vector<BodyPoses> poses = trace(m, word, start);
  ASSERT_EQ(poses.size(), word.size());
  PlanarPose a = start;
  for (std::size_t k = 0; k < word.size(); ++k) {
    if (k % 2 == 1) a = poses[k].a;
    EXPECT_LT(distance(poses[k].a, a), 1e-12) << k;  // A holds in the first half of a cycle
    const PlanarPose b_in_a = inverse(poses[k].a) * poses[k].b;
    EXPECT_LT(distance(b_in_a, m.b_in_a(word[k])), 1e-12) << k;
    const bool b_holds = k % 2 == 1;
    EXPECT_TRUE(!b_holds || distance(poses[k].b, poses[k - 1].b) < 1e-12) << k;
  }
  EXPECT_LT(distance(poses.back().a, forward(m, word, start)), 1e-12);
}

TEST(Word, AdvancesAtMostHundredMillimetresInACycle) { EXPECT_NEAR(mechanism().longest_cycle() * 7.0, 0.703, 0.001); }

TEST(Word, KeepsThePapersOrder) {
  const std::vector<int> first{2, 1, 8}, second{5, 6, 4};
  const Word word = from_paper(first, second);
  EXPECT_EQ(word, (Word{2, 5, 1, 6, 8, 4}));
  EXPECT_EQ(to_paper(word), (std::vector<int>{2, 1, 8, 5, 6, 4}));
  EXPECT_THROW(from_paper(std::vector<int>{1}, std::vector<int>{}), std::invalid_argument);
  EXPECT_THROW(from_paper(std::vector<int>{9}, std::vector<int>{1}), std::invalid_argument);
}

}  // namespace
}  // namespace foothold::xrobin
