// Distances against the Flexible Collision Library, which is exact to about 1e-6 m and at times gives up near contact.
#include <fcl/narrowphase/collision_object.h>
#include <fcl/narrowphase/distance.h>
#include <gtest/gtest.h>

#include <memory>
#include <optional>

#include "pairs.hpp"

namespace foothold::collision {
namespace {

fcl::CollisionObjectd object(const Box& box) {
  return {std::make_shared<fcl::Boxd>(2.0 * box.half.x(), 2.0 * box.half.y(), 2.0 * box.half.z()), box.pose};
}

fcl::CollisionObjectd object(const Capsule& capsule) {
  Isometry3d pose = Isometry3d::Identity();
  pose.translate(0.5 * (capsule.a + capsule.b));
  pose.rotate(Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), capsule.b - capsule.a));
  return {std::make_shared<fcl::Capsuled>(capsule.radius, (capsule.b - capsule.a).norm()), pose};
}

std::optional<double> by_fcl(const fcl::CollisionObjectd& a, const fcl::CollisionObjectd& b) {
  try {
    fcl::DistanceRequestd request;
    request.distance_tolerance = 1e-9;
    fcl::DistanceResultd result;
    return fcl::distance(&a, &b, request, result);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

// Near contact FCL is no judge (its documented faults); what is left must agree.
constexpr double kContact = 1e-3, kError = 1e-4;

TEST(AgainstFcl, DistancesOfBodiesThatAreApartAgree) {
  Pairs pairs(Kind::kAnywhere, 5);
  int judged = 0, differ = 0, refused = 0;
  const auto judge = [&](const auto& a, const auto& b) {
    const double ours = distance(a, b);
    if (ours < kContact) return;
    const std::optional<double> theirs = by_fcl(object(a), object(b));
    if (!theirs) {
      ++refused;
      return;
    }
    ++judged;
    differ += std::abs(*theirs - ours) > kError;
  };
  for (int k = 0; k < 35000; ++k) {
    Box b = pairs.box(), e = pairs.box();
    b.half += Vector3d::Constant(0.01), e.half += Vector3d::Constant(0.01);
    Capsule c = pairs.capsule(), d = pairs.capsule();
    c.radius += 0.01, d.radius += 0.01;
    judge(c, d);
    judge(c, b);
    judge(b, e);
  }
  EXPECT_GT(judged, 80000);
  EXPECT_LT(refused, judged / 1000);
  EXPECT_LT(differ, judged / 1000) << "of " << judged;
}

}  // namespace
}  // namespace foothold::collision
