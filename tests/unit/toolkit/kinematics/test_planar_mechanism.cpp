// The 2RPR-PR mechanism both ways, against its equations solved by other means.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>
#include <vector>

#include "kinematics/planar_mechanism.hpp"

namespace foothold::kinematics {
namespace {

struct Sizes {
  double b, p, shortest, longest;
};
// HyReCRo's, and others whose base and body differ.
const std::vector<Sizes> kSizes = {{0.04, 0.04, 0.19, 0.25}, {0.05, 0.03, 0.15, 0.22}, {0.06, 0.05, 0.3, 0.36}};

// Real roots x of the cubic that is left of y sin phi = v and y^2 = k + 2 p b x with x = cos phi: (k + 2 p b x)(1 - x^2) = v^2.
std::vector<double> cosines(double k, double pb2, double v) {
  Eigen::Matrix3d companion = Eigen::Matrix3d::Zero();
  // x^3 + (k / pb2) x^2 - x + (v^2 - k) / pb2 = 0
  companion(0, 0) = -k / pb2;
  companion(0, 1) = 1.0;
  companion(0, 2) = -(v * v - k) / pb2;
  companion(1, 0) = companion(2, 1) = 1.0;
  std::vector<double> out;
  for (const auto& root : Eigen::EigenSolver<Eigen::Matrix3d>(companion, false).eigenvalues())
    if (std::fabs(root.imag()) < 1e-6) out.push_back(root.real());
  return out;
}

TEST(PlanarMechanism, LengthsAreThoseOfThePinsInThePlane) {
  std::mt19937_64 random(1);
  for (const Sizes& s : kSizes) {
    const PlanarMechanism mechanism(s.b, s.p, s.shortest, s.longest);
    for (int i = 0; i < 2000; ++i) {
      const double phi = std::uniform_real_distribution<>(-1.0, 1.0)(random),
                   y = std::uniform_real_distribution<>(0.1, 0.5)(random);
      // Actuators run from the pins at -p and +p to those at -b and +b of the part that is turned by phi and is y away.
      const double left = std::hypot(s.p - s.b * std::cos(phi), y + s.b * std::sin(phi));
      const double right = std::hypot(s.p - s.b * std::cos(phi), y - s.b * std::sin(phi));
      const auto [l, r] = mechanism.lengths({phi, y});
      EXPECT_NEAR(l, left, 1e-15);
      EXPECT_NEAR(r, right, 1e-15);
    }
  }
}

TEST(PlanarMechanism, ForwardAndLengthsAreInverse) {
  std::mt19937_64 random(2);
  for (const Sizes& s : kSizes) {
    const PlanarMechanism mechanism(s.b, s.p, s.shortest, s.longest);
    std::uniform_real_distribution<> stroke(s.shortest, s.longest);
    for (int i = 0; i < 20000; ++i) {
      const PlanarMechanism::Lengths lengths{stroke(random), stroke(random)};
      const auto pose = mechanism.forward(lengths);
      const auto again = mechanism.lengths(pose);
      ASSERT_NEAR(again.left, lengths.left, 1e-13);
      ASSERT_NEAR(again.right, lengths.right, 1e-13);
      ASSERT_TRUE(mechanism.offsets(pose.phi).holds(pose.y, 1e-12));
      ASSERT_LE(std::fabs(pose.phi), mechanism.greatest_phi() + 1e-12);
    }
  }
}

TEST(PlanarMechanism, ForwardIsARootOfTheCubic) {
  std::mt19937_64 random(3);
  for (const Sizes& s : kSizes) {
    const PlanarMechanism mechanism(s.b, s.p, s.shortest, s.longest);
    std::uniform_real_distribution<> stroke(s.shortest, s.longest);
    for (int i = 0; i < 2000; ++i) {
      const double l = stroke(random), r = stroke(random);
      const double k = 0.5 * (l * l + r * r) - s.p * s.p - s.b * s.b;
      const auto pose = mechanism.forward({l, r});
      double nearest = 1.0;
      for (const double x : cosines(k, 2.0 * s.p * s.b, (l * l - r * r) / (4.0 * s.b)))
        nearest = std::min(nearest, std::fabs(x - std::cos(pose.phi)));
      EXPECT_LT(nearest, 1e-7);
      EXPECT_EQ(std::signbit(pose.phi), l < r);
    }
  }
}

TEST(PlanarMechanism, OffsetsEndWhereAnActuatorMeetsItsLimit) {
  for (const Sizes& s : kSizes) {
    const PlanarMechanism mechanism(s.b, s.p, s.shortest, s.longest);
    for (int i = -100; i <= 100; ++i) {
      const double phi = mechanism.greatest_phi() * i / 100.0;
      const Interval y = mechanism.offsets(phi);
      ASSERT_FALSE(y.low > y.high + 1e-9);
      const auto low = mechanism.lengths({phi, y.low}), high = mechanism.lengths({phi, y.high});
      EXPECT_NEAR(std::fmin(low.left, low.right), s.shortest, 1e-12);
      EXPECT_NEAR(std::fmax(high.left, high.right), s.longest, 1e-12);
    }
    EXPECT_TRUE(mechanism.offsets(mechanism.greatest_phi() + 1e-6).empty());
    EXPECT_TRUE(mechanism.offsets(-mechanism.greatest_phi() - 1e-6).empty());
  }
}

TEST(PlanarMechanism, HyrecrosGreatestAngleIsThePublishedOne) {
  const PlanarMechanism mechanism(0.04, 0.04, 0.19, 0.25);
  EXPECT_NEAR(mechanism.greatest_phi() * 180.0 / 3.14159265358979, 48.72, 0.01);
}

}  // namespace
}  // namespace foothold::kinematics
