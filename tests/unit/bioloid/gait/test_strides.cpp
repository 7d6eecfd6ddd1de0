// Key postures, phases and strides: feet where they belong, weight where it belongs, in time, and back again.
#include <gtest/gtest.h>

#include "../robot.hpp"
#include "bioloid/gait/gait.hpp"

namespace foothold::bioloid::testing {
namespace {

const Model& model() { return shipped_model(); }

PlanarPose ahead(double x, double out = 0.0, double heading = 0.0) {
  PlanarPose place = beside(model(), Side::kRight);
  return rounded({x, place.y + out, heading});
}

// The same place for the right foot, seen from the left one.
PlanarPose right_of(const PlanarPose& place) { return {place.x, -place.y, -place.heading}; }

// Of the centre of mass, seen from the supporting sole.
Vector3d centre_over(Side support, const Joints& joints) {
  return sole_in_torso(model(), support, joints).inverse() * centre_of_mass(model(), joints);
}

TEST(KeyPostures, PutTheCentreOfMassWhereItIsWanted) {
  for (const double heading : {0.0, 0.3, -0.3})
    for (const double x : {-0.04, 0.0, 0.05}) {
      const Key key{
          .swing = ahead(x, 0.005, heading), .lift = 0.01, .heading = 0.5 * heading, .height = 0.12, .balance = {0.003, -0.002}};
      const auto posture = key_posture(model(), Side::kRight, key);
      ASSERT_TRUE(posture) << x << " " << heading;
      EXPECT_LT((centre_over(Side::kRight, posture->joints).head<2>() - key.balance).norm(), 1e-9);
      const Isometry3d swing =
          sole_in_torso(model(), Side::kRight, posture->joints).inverse() * sole_in_torso(model(), Side::kLeft, posture->joints);
      EXPECT_LT((swing.matrix() - to_world(key.swing, key.lift).matrix()).cwiseAbs().maxCoeff(), 1e-9);
      EXPECT_TRUE(within_limits(model(), posture->joints));
    }
}

TEST(KeyPostures, AreNoneOutOfReach) {
  EXPECT_FALSE(key_posture(model(), Side::kRight, {.swing = ahead(0.3), .height = 0.12}));
  EXPECT_FALSE(key_posture(model(), Side::kRight, {.swing = ahead(0.0), .height = 0.2}));
}

TEST(Strides, GoFromStandingToStandingWithoutAJump) {
  Gait gait(model(), {});
  std::mt19937_64 random(1);
  const auto stride = gait.stride(Side::kRight, ahead(-0.05), ahead(0.05), 0.01, random, {});
  ASSERT_TRUE(stride);
  EXPECT_STREQ(stride->phases.front().name, "shift");
  EXPECT_STREQ(stride->phases.back().name, "settle");
  for (std::size_t k = 1; k < stride->phases.size(); ++k)
    EXPECT_LT((stride->phases[k].points.front() - stride->phases[k - 1].points.back()).cwiseAbs().maxCoeff(), 1e-8) << k;
  const auto begin = gait.midway(Side::kRight, ahead(-0.05)), end = gait.midway(Side::kRight, ahead(0.05));
  EXPECT_LT((stride->phases.front().points.front() - begin->joints).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_LT((stride->phases.back().points.back() - end->joints).cwiseAbs().maxCoeff(), 1e-8);
}

TEST(Strides, ShiftTheWeightAsFarAsBalanceAsksForAndByThePaperToTheCentre) {
  const PlanarPose swing = ahead(-0.05);
  GaitOptions options, centred;
  centred.paper.emplace();
  const auto weight = [&](const GaitOptions& by) {
    Gait gait(model(), by);
    const Departure& leaves = gait.departure(Side::kRight, swing, 0.01);
    EXPECT_TRUE(leaves.sound());
    return Eigen::Vector2d(centre_over(Side::kRight, leaves.shift.points.back()).head<2>());
  };
  const double inside = options.demands.balance + options.reserve;
  EXPECT_LT((weight(options) - Eigen::Vector2d(-0.025, 0.5 * model().sole_width - inside)).norm(), 1e-9);
  EXPECT_LT(weight(centred).norm(), 1e-9);
  options.demands.balance = 0.028;
  EXPECT_LT(std::abs(weight(options).y()), 1e-9) << "no farther than the centre";
}

TEST(Strides, LiftByWhatIsAskedAndKeepTheSoleLevel) {
  GaitOptions options;
  Gait gait(model(), options);
  std::mt19937_64 random(1);
  const auto stride = gait.stride(Side::kLeft, right_of(ahead(0.0)), right_of(ahead(0.05, 0.0, 0.2)), 0.015, random, {});
  ASSERT_TRUE(stride);
  double highest = 0.0;
  for (const Phase& phase : stride->phases) {
    if (phase.support.both) continue;
    for (const Joints& joints : phase.points) {
      const Isometry3d swing = sole_in_torso(model(), Side::kLeft, joints).inverse() * sole_in_torso(model(), Side::kRight, joints);
      highest = std::max(highest, swing.translation().z());
      EXPECT_GT(swing.linear()(2, 2), 1.0 - 1e-12) << phase.name;
      EXPECT_GT(swing.translation().z(), -1e-9) << phase.name;
    }
  }
  EXPECT_GE(highest, 0.015 - 1e-9);
  EXPECT_LT(highest, 0.04);
}

TEST(Strides, KeepToThePaceAndThePeriod) {
  GaitOptions options;
  options.pace = {0.3, 0.01};
  Gait gait(model(), options);
  std::mt19937_64 random(1);
  const auto stride = gait.stride(Side::kRight, ahead(0.0), ahead(0.05), 0.01, random, {});
  ASSERT_TRUE(stride);
  for (const Phase& phase : stride->phases) {
    EXPECT_EQ(phase.times.front(), 0.0);
    for (std::size_t k = 1; k < phase.points.size(); ++k) {
      const double time = phase.times[k] - phase.times[k - 1];
      EXPECT_GT(time, 0.0);
      EXPECT_LE(time, 0.01 + 1e-12);
      EXPECT_LE(least_time(model(), phase.points[k - 1], phase.points[k], 0.3), time * 1.05) << phase.name << " " << k;
    }
  }
}

TEST(Strides, ComeFromTheSamePiecesForwardsAndBackwards) {
  Gait gait(model(), {});
  const Departure& leaves = gait.departure(Side::kRight, ahead(0.05), 0.01);
  ASSERT_TRUE(leaves.sound());
  EXPECT_EQ(certify(gait.judge(), reversed(leaves.lift), leaves.lift.support), Fault::kNone);
  EXPECT_EQ(certify(gait.judge(), reversed(leaves.shift), leaves.shift.support), Fault::kNone);
  EXPECT_EQ(reversed(leaves.lift).ground, 2U);
}

TEST(Strides, AreTheSameForTheSameSeed) {
  Gait a(model(), {}), b(model(), {});
  std::mt19937_64 first(7), second(7);
  const auto one = a.stride(Side::kRight, ahead(0.0), ahead(0.04, 0.01), 0.02, first, {});
  const auto two = b.stride(Side::kRight, ahead(0.0), ahead(0.04, 0.01), 0.02, second, {});
  ASSERT_TRUE(one && two);
  for (std::size_t k = 0; k < one->phases.size(); ++k) EXPECT_EQ(one->phases[k].points, two->phases[k].points);
}

TEST(Search, JoinsWhatCanBeJoined) {
  Gait gait(model(), {});
  const Departure &a = gait.departure(Side::kRight, ahead(-0.05), 0.01), &b = gait.departure(Side::kRight, ahead(0.05), 0.01);
  ASSERT_TRUE(a.sound() && b.sound());
  std::mt19937_64 random(3);
  const Support support{.foot = Side::kRight};
  const std::vector<Free> way = connect(model(), gait.judge(), support, a.raised, b.raised, {}, random, {});
  ASSERT_GE(way.size(), 2u);
  EXPECT_EQ(way.front(), a.raised);
  EXPECT_EQ(way.back(), b.raised);
  for (std::size_t k = 1; k < way.size(); ++k) EXPECT_TRUE(free_line(model(), gait.judge(), support, way[k - 1], way[k], 0)) << k;
}

// A way of the right foot's swing partner from 50 mm behind to 50 mm ahead, certified line by line among the prisms.
std::vector<Free> way_among(const std::vector<Prism>& prisms, double out, double lift) {
  Judge judge(model(), {}, prisms);
  const Support support{.foot = Side::kRight};
  const auto key = [&](double x) {
    return to_free(model(), Side::kRight,
                   key_posture(model(), Side::kRight, {.swing = ahead(x, out), .lift = lift, .height = 0.12})->joints);
  };
  const Free a = key(-0.06), b = key(0.06);
  std::mt19937_64 random(3);
  EXPECT_FALSE(free_line(model(), judge, support, a, b, 0)) << "something is in the way";
  std::vector<Free> way = connect(model(), judge, support, a, b, {}, random, {});
  if (way.empty()) return way;
  EXPECT_EQ(way.front(), a);
  EXPECT_EQ(way.back(), b);
  for (std::size_t k = 1; k < way.size(); ++k) EXPECT_TRUE(free_line(model(), judge, support, way[k - 1], way[k], 0)) << k;
  return way;
}

TEST(Search, GoesOverASill) {
  const std::vector<Prism> sill{{"sill", {{-0.001, 0.04}, {0.001, 0.04}, {0.001, 0.15}, {-0.001, 0.15}}, 0.014}};
  const std::vector<Free> way = way_among(sill, 0.0, 0.010);
  EXPECT_EQ(way.size(), 5u) << "up, level across its middle, down";
}

TEST(Search, GoesRoundWhatIsTooHighToGoOver) {
  // The foot stands out to 25 mm beyond its place beside the other; a post there has to be passed on the inside.
  const std::vector<Prism> post{{"post", {{-0.002, 0.125}, {0.002, 0.125}, {0.002, 0.16}, {-0.002, 0.16}}, 0.06}};
  EXPECT_GE(way_among(post, 0.025, 0.020).size(), 3u);
}

TEST(Search, EndsWhereNoTreeCanGrow) {
  // Both ends lie in what is in the way.
  const std::vector<Prism> block{{"block", {{-0.2, 0.04}, {0.2, 0.04}, {0.2, 0.15}, {-0.2, 0.15}}, 0.03}};
  EXPECT_TRUE(way_among(block, 0.0, 0.010).empty());
}

TEST(Rising, TakesTheWalkingPostureFromTheZeroPose) {
  Gait gait(model(), {});
  const Joints zero = Joints::Zero();
  // The zero pose balances its centre of mass 12 mm behind the ankles: well inside soles of 100 mm.
  const auto rise = gait.rise(zero, Side::kRight, beside(model(), Side::kRight));
  ASSERT_TRUE(rise);
  EXPECT_EQ(rise->points.front(), zero);
  EXPECT_LT((rise->points.back() - gait.midway(Side::kRight, beside(model(), Side::kRight))->joints).cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace foothold::bioloid::testing
