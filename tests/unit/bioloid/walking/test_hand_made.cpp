// Motions by hand before the physics judge: those that must stand, and those that must not.
#include <gtest/gtest.h>

#include "hand_made.hpp"
#include "walker.hpp"

namespace foothold::bioloid::testing {
namespace {

constexpr double kNear = 0.003, kUpright = 3.0 * kDegree;  // m; servos give way by a degree

const Model& robot() { return shipped_model(); }

physics::Walked played(const std::vector<Pose>& poses, const physics::WalkOptions& options = {}) {
  return physics::walk(walker_of(robot()), feet_of(), Pose::at(poses.front().torso), motion_through(robot(), poses), options);
}

bool stands(const physics::Walked& walked, const Pose& goal, double distance = kNear) {
  return physics::stands_at(walked, Pose::at(goal.torso), distance, kUpright);
}

TEST(HandMade, StandsCrouchesAndShifts) {
  const Pose standing_up = standing(robot(), 0.130), crouched = standing(robot(), 0.110);
  Pose lifted = shifted(robot(), standing_up, standing_up.soles[0]);
  lifted.soles[1].z() = 0.01;
  lifted = shifted(robot(), lifted, lifted.soles[0]);
  EXPECT_TRUE(stands(played({standing_up}), standing_up));
  EXPECT_TRUE(stands(played({standing_up, crouched}), crouched));
  const physics::Walked on_one_foot = played({standing_up, shifted(robot(), standing_up, standing_up.soles[0]), lifted});
  EXPECT_TRUE(stands(on_one_foot, lifted)) << on_one_foot.base.translation().transpose();
  EXPECT_EQ(on_one_foot.touching, "");
  EXPECT_GT(on_one_foot.links[18].translation().z(), on_one_foot.links[17].translation().z() + 0.005) << "its left foot is up";
}

TEST(HandMade, AFootLiftedWithoutAShiftIsNotStanding) {
  const Pose begin = standing(robot(), 0.130);
  Pose lifted = begin;
  lifted.soles[1].z() = 0.02;
  const physics::Walked leans = played({begin, lifted});
  EXPECT_FALSE(leans.fell()) << "the raised foot catches it";
  EXPECT_FALSE(stands(leans, lifted, 0.02));
}

TEST(HandMade, BeyondTheFootItFalls) {
  const Pose begin = standing(robot(), 0.120);
  for (const double share : {0.85, 1.15}) {
    // Forward, towards the edge of the toes at 50 mm, both feet on the ground.
    const Pose beyond = shifted(robot(), begin, {share * 0.5 * robot().sole_length, 0.0, 0.0});
    EXPECT_EQ(played({begin, beyond}).fell(), share > 1.0) << share;
  }
}

TEST(HandMade, WalksThePapersStep) {
  const std::vector<Pose> poses = walk_by_hand(robot(), 3, 0.050, 0.010);
  const physics::Walked walked = played(poses);
  EXPECT_EQ(walked.touching, "");
  EXPECT_TRUE(stands(walked, poses.back(), 0.006)) << (walked.base.translation() - poses.back().torso).transpose();
}

}  // namespace
}  // namespace foothold::bioloid::testing
