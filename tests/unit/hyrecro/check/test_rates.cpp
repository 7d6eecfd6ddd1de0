// Bounds of speeds against what bodies really move.
#include <gtest/gtest.h>

#include <Eigen/SVD>

#include "hyrecro/check/piece.hpp"
#include "walk.hpp"

namespace foothold::hyrecro {
namespace {

double moved(const collision::Capsule& a, const collision::Capsule& b) { return std::max((a.a - b.a).norm(), (a.b - b.b).norm()); }

double moved(const collision::Box& a, const collision::Box& b) {
  double most = 0.0;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.0, 1.0}) {
        const Vector3d corner = a.half.cwiseProduct(Vector3d(x, y, z));
        most = std::max(most, (a.pose * corner - b.pose * corner).norm());
      }
  return most;
}

TEST(Rates, AreNeverExceededAndNotIdle) {
  const Model model = shipped_model();
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> length(model.mechanism.shortest(), model.mechanism.longest()), angle(-3.0, 3.0),
      part(0.0, 1.0);
  double used = 0.0;
  constexpr int kPieces = 1000;
  for (int k = 0; k < kPieces; ++k) {
    std::vector<double> from(kJoints), to(kJoints);
    const double size = std::pow(10.0, -3.0 * part(random));
    for (std::size_t j = 0; j < kJoints; ++j) {
      from[j] = j < 8 ? length(random) : angle(random);
      to[j] = from[j] + size * ((j < 8 ? length(random) : angle(random)) - from[j]);
    }
    const Foot holds = k % 2 == 0 ? Foot::kA : Foot::kB;
    const Piece piece{from, to, rates_between(model, from, to, holds)};
    double most = 0.0;
    for (int sample = 0; sample < 40; ++sample) {
      const double s = part(random), step = 0.05 * (part(random) - s);
      const Coordinates c = from_joints(model, piece.joints_at(s), holds), d = from_joints(model, piece.joints_at(s + step), holds);
      const Bodies a = bodies_at(model, c, Isometry3d::Identity()), b = bodies_at(model, d, Isometry3d::Identity());
      const double share = std::fabs(step), slack = 1e-13;
      EXPECT_LE(moved(a.leg[0], b.leg[0]), share * piece.rates.leg0 + slack);
      EXPECT_LE(moved(a.leg[1], b.leg[1]), share * piece.rates.leg1 + slack);
      EXPECT_LE(moved(a.hip, b.hip), share * piece.rates.hip + slack);
      EXPECT_LE(moved(a.plate[1], b.plate[1]), share * piece.rates.plate1 + slack);
      EXPECT_LE(moved(a.plate[0], b.plate[0]), slack);
      most = std::max(most, moved(a.plate[1], b.plate[1]) / (share * piece.rates.plate1));
    }
    used += most / kPieces;
  }
  EXPECT_GT(used, 0.1) << "bounds that are never nearly met are too wide to be of use";
}

// Any posture between two against the mean of the two, by the part's square.
TEST(Rates, BoundHowFarTheSoleIsOffTheStraightWay) {
  const Model model = shipped_model();
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> length(model.mechanism.shortest(), model.mechanism.longest()), angle(-3.0, 3.0),
      part(0.0, 1.0);
  double most = 0.0, most_turn = 0.0;
  for (int k = 0; k < 1000; ++k) {
    std::vector<double> from(kJoints), to(kJoints);
    for (std::size_t j = 0; j < kJoints; ++j) {
      from[j] = j < 8 ? length(random) : angle(random);
      to[j] = k % 3 == 0 || static_cast<int>(j) == k % 10 ? (j < 8 ? length(random) : angle(random)) : from[j];
    }
    const Foot holds = k % 2 == 0 ? Foot::kA : Foot::kB;
    const Piece piece{from, to, rates_between(model, from, to, holds)};
    for (int sample = 0; sample < 30; ++sample) {
      const double begin = 0.95 * part(random), h = std::pow(10.0, -2.0 * part(random)) * (1.0 - begin), s = part(random);
      const auto sole = [&](double at) { return forward(model, from_joints(model, piece.joints_at(at), holds)); };
      const Isometry3d a = sole(begin), b = sole(begin + h), c = sole(begin + s * h);
      const double off = (c.translation() - (1.0 - s) * a.translation() - s * b.translation()).norm();
      const double turn =
          Eigen::JacobiSVD<Eigen::Matrix3d>(c.linear() - (1.0 - s) * a.linear() - s * b.linear()).singularValues()[0];
      EXPECT_LE(off, piece.rates.bend1 * h * h / 8.0 + 1e-13);
      EXPECT_LE(turn, piece.rates.bend_turn1 * h * h / 8.0 + 1e-13);
      most = std::max(most, 8.0 * off / (h * h * piece.rates.bend1 + 1e-9));
      most_turn = std::max(most_turn, 8.0 * turn / (h * h * piece.rates.bend_turn1 + 1e-9));
    }
  }
  EXPECT_GT(most, 0.1);
  EXPECT_GT(most_turn, 0.1);
}

}  // namespace
}  // namespace foothold::hyrecro
