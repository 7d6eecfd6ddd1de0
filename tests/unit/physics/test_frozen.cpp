// Blocks on slopes and at edges: when they slide and tip over is known.
#include <gtest/gtest.h>

#include "physics/frozen.hpp"

namespace foothold::physics {
namespace {

// Feet in a rectangle on a plane that slopes down towards +X, the centre of mass `height` above its middle and `ahead` of it.
FrozenStance on_slope(double slope, double friction, double height, double ahead = 0.0) {
  const Eigen::AngleAxisd turn(slope, Vector3d::UnitY());
  FrozenStance out{.contacts = {}, .centre_of_mass = turn * Vector3d(ahead, 0.0, height), .mass = 5.2, .friction = friction};
  for (const double x : {-0.2, 0.2})
    for (const double y : {-0.15, 0.15}) out.contacts.push_back({turn * Vector3d(x, y, 0.0), turn * Vector3d::UnitZ()});
  return out;
}

TEST(Frozen, SlidesWhereTheSlopeIsSteeperThanTheFriction) {
  for (const double friction : {0.2, 0.4, 0.8}) {
    EXPECT_FALSE(let_go(on_slope(std::atan(0.88 * friction), friction, 0.05)).moves()) << friction;
    EXPECT_TRUE(let_go(on_slope(std::atan(1.12 * friction), friction, 0.05)).moves()) << friction;
  }
}

TEST(Frozen, TipsOverWhereTheCentreOfMassIsBeyondTheFeet) {
  EXPECT_FALSE(let_go(on_slope(0.0, 0.4, 0.1, 0.19)).moves());
  EXPECT_TRUE(let_go(on_slope(0.0, 0.4, 0.1, 0.21)).moves());
}

// Two walls that face each other hold what each of them alone would let go; with too little friction they do not.
TEST(Frozen, BracesItselfBetweenSlopes) {
  const auto wedged = [](double friction) {
    FrozenStance out{.contacts = {}, .centre_of_mass = {0.0, 0.0, 0.1}, .mass = 5.2, .friction = friction};
    for (const double side : {-1.0, 1.0})
      for (const double y : {-0.15, 0.15}) {
        const Vector3d normal = Vector3d(-side * std::sin(1.0), 0.0, std::cos(1.0));
        out.contacts.push_back({{0.2 * side, y, 0.0}, normal});
      }
    return out;
  };
  EXPECT_FALSE(let_go(wedged(0.4)).moves());
  FrozenStance one_wall = wedged(0.4);
  one_wall.contacts.resize(2);
  EXPECT_TRUE(let_go(one_wall).moves());
}

TEST(Frozen, RefusesAStanceWithoutContacts) { EXPECT_THROW(let_go({}), std::runtime_error); }

}  // namespace
}  // namespace foothold::physics
