// Motions from stance to stance: accepted ones against a dense judge of another make, and each way to be wrong.
#include <functional>

#include "contact/equilibrium.hpp"
#include "octopod/check/bodies.hpp"
#include "octopod/check/check.hpp"
#include "octopod/check/course.hpp"
#include "planning.hpp"
#include "terrain/surface.hpp"

namespace foothold::octopod {
namespace {

struct Walk {
  std::shared_ptr<const PreparedScene> scene;
  std::vector<Step> steps;
  Posture start;
  CheckOptions options;

  const terrain::Surface& surface() const { return dynamic_cast<const Ground&>(*scene).surface(); }
  const Posture& before(std::size_t k) const { return k == 0 ? start : steps[k - 1].after; }
};

const Walk& walk() {
  static const Walk planned = [] {
    const Parameters values = parameters({{"transitions", "true"}});
    Walk out{shared_planner().prepare(shipped("terrain-ditch"), values), {}, {}, {}};
    const Request request = request_between({-1.5, -1.0, 0.0}, {-0.9, -1.0, 0.0});
    Collector steps;
    out.start = shared_planner().start(request, values, *out.scene);
    shared_planner().plan(request, values, *out.scene, steps);
    out.steps = steps.steps;
    return out;
  }();
  return planned;
}

StepVerdict judge(const Step& step, std::size_t k = 0, const CheckOptions& options = walk().options) {
  return check_step(octopod(), walk().surface(), step, walk().before(k), options);
}

// Ten times as many points, each by itself: feet, bodies by the terrain's own tree, equilibrium by the simplex method.
TEST(Motions, ThatAreAcceptedHoldAtEachInstant) {
  contact::Equilibrium equilibrium(contact::FrictionCone::pyramid(10));
  ASSERT_FALSE(walk().steps.empty());
  long instants = 0;
  for (std::size_t s = 0; s < walk().steps.size(); ++s) {
    const Step& step = walk().steps[s];
    const StepVerdict verdict = judge(step, s);
    ASSERT_TRUE(verdict.accepted) << verdict.reason;
    for (std::size_t i = 1; i < step.motion.size(); ++i) {
      const Pose a{step.motion[i - 1].base, step.motion[i - 1].joints}, b{step.motion[i].base, step.motion[i].joints};
      const auto stands = [&](const Pose& pose, std::size_t k, const Posture& posture) {
        const Vector3d foot = leg(octopod(), from_posture({pose.base, pose.joints, {}}), static_cast<int>(k)).foot;
        return (foot - posture.stance[k].frame.translation()).norm() < 1e-6;
      };
      for (int part = 0; part < 10; part += 3, ++instants) {
        const Pose now = between(a, b, part / 10.0);
        const Coordinates at = from_posture({now.base, now.joints, {}});
        std::vector<contact::Contact> carrying;
        for (std::size_t k = 0; k < kLegs; ++k) {
          const Vector3d foot = leg(octopod(), at, static_cast<int>(k)).foot;
          for (const Posture* posture : {&walk().before(s), &step.after}) {
            if (!stands(a, k, *posture) || !stands(b, k, *posture)) continue;
            const Isometry3d& frame = posture->stance[k].frame;
            EXPECT_LE((foot - frame.translation()).norm(), kSlip);
            carrying.push_back({frame.translation(), frame.linear().col(2)});
            break;
          }
        }
        EXPECT_GE(carrying.size(), 7u);
        EXPECT_TRUE(equilibrium.judge(carrying, centre_of_mass(octopod(), at), walk().options.friction).stable);
        for (const Shape& shape : shapes(octopod(), at)) {
          if (shape.kind == Shape::Kind::kBox) {
            EXPECT_GT(walk().surface().distance(collision::Box{shape.pose, 0.5 * shape.size}), 0.0) << shape.body;
          } else {
            const Vector3d half = 0.5 * shape.size.z() * shape.pose.linear().col(2);
            const collision::Capsule body{shape.pose.translation() - half, shape.pose.translation() + half, shape.size.x()};
            EXPECT_GT(walk().surface().distance(body), 0.0) << shape.body;
          }
        }
      }
    }
  }
  EXPECT_GT(instants, 1000);
}

struct Wrong {
  const char* name;
  const char* reason;  // a part of it
  std::function<void(Step&, CheckOptions&)> spoil;
};

void PrintTo(const Wrong& wrong, std::ostream* out) { *out << wrong.name; }

class WrongMotions : public testing::TestWithParam<Wrong> {};

TEST_P(WrongMotions, AreRefusedWithTheReason) {
  Step step = walk().steps.front();
  CheckOptions options = walk().options;
  GetParam().spoil(step, options);
  const StepVerdict verdict = judge(step, 0, options);
  EXPECT_FALSE(verdict.accepted);
  EXPECT_NE(verdict.reason.find(GetParam().reason), std::string::npos) << verdict.reason;
}

// Time enough for whatever a test makes of the joints.
void slow_down(Step& step, double factor) {
  for (MotionPoint& point : step.motion) point.time *= factor;
}

void at_middle(Step& step, const std::function<void(MotionPoint&)>& change) {
  slow_down(step, 1e4);
  change(step.motion[step.motion.size() / 2]);
}

INSTANTIATE_TEST_SUITE_P(
    EachWay, WrongMotions,
    testing::Values(Wrong{"OnePoint", "two points at least", [](Step& s, CheckOptions&) { s.motion.resize(1); }},
                    Wrong{"BeginsLate", "begins at 1 s",
                          [](Step& s, CheckOptions&) {
                            for (auto& p : s.motion) p.time += 1.0;
                          }},
                    Wrong{"BeginsBeside", "the motion begins", [](Step& s, CheckOptions&) { s.motion.front().joints[0] += 1e-7; }},
                    Wrong{"EndsBeside", "the motion ends", [](Step& s, CheckOptions&) { s.motion.back().joints[0] += 1e-7; }},
                    Wrong{"BaseBeginsBeside", "the motion begins",
                          [](Step& s, CheckOptions&) { s.motion.front().base.translation().x() += 1e-7; }},
                    Wrong{"JointsMissing", "gives 26 joints", [](Step& s, CheckOptions&) { s.motion[3].joints.pop_back(); }},
                    Wrong{"TimeStandsStill", "time does not go on",
                          [](Step& s, CheckOptions&) { s.motion[5].time = s.motion[4].time; }},
                    Wrong{"TooFast", "rad/s, may with 2", [](Step& s, CheckOptions&) { slow_down(s, 0.01); }},
                    Wrong{"FeetDragged", "is dragged from one contact to the other",
                          [](Step& s, CheckOptions&) {
                            slow_down(s, 1e4);
                            s.motion = {s.motion.front(), s.motion.back()};
                          }},
                    Wrong{"TooFewPoints", "foot",
                          [](Step& s, CheckOptions&) {
                            slow_down(s, 1e4);
                            std::vector<MotionPoint> few;
                            for (std::size_t i = 0; i < s.motion.size(); i += 25) few.push_back(s.motion[i]);
                            few.push_back(s.motion.back());
                            s.motion = few;
                          }},
                    Wrong{"FeetInTheGround", "its contact",
                          [](Step& s, CheckOptions&) {
                            at_middle(s, [](MotionPoint& p) {
                              for (std::size_t k = 0; k < kLegs; ++k) p.joints[3 * k + 1] -= 1e-3;
                            });
                          }},
                    Wrong{"RobotSinks", "the ground",
                          [](Step& s, CheckOptions&) { at_middle(s, [](MotionPoint& p) { p.base.translation().z() -= 0.15; }); }},
                    Wrong{"RobotLeaps", "no equilibrium on no feet",
                          [](Step& s, CheckOptions&) { at_middle(s, [](MotionPoint& p) { p.base.translation().z() += 0.1; }); }},
                    Wrong{"LeftFeetInTheAir", "no equilibrium on",
                          [](Step& s, CheckOptions&) {
                            at_middle(s, [](MotionPoint& p) {
                              for (const std::size_t k : {0, 2, 4, 6}) p.joints[3 * k + 1] += 0.3;
                            });
                          }},
                    Wrong{"Slippery", "no equilibrium",
                          [](Step& s, CheckOptions& options) {
                            options.friction = 0.021;
                            s.placed = s.after.stance;
                          }},
                    Wrong{"ClearanceNotKept", "m must be kept", [](Step&, CheckOptions& options) { options.clearance = 0.0119; }}),
    [](const auto& tested) { return std::string(tested.param.name); });

// A thin wall between two points: what is free at both is not free between them, and no point tells.
TEST(Motions, AreJudgedBetweenTheirPointsToo) {
  Step step = walk().steps.front();
  terrain::Terrain with_wall = walk().surface().terrain();
  // In the way of a swinging leg: upright, across the robot's sole, as high as a knee.
  int refused = 0, blocked_points = 0;
  for (std::size_t i = 20; i + 1 < step.motion.size(); i += 20) {
    const Pose a{step.motion[i].base, step.motion[i].joints}, b{step.motion[i + 1].base, step.motion[i + 1].joints};
    for (int k = 0; k < kLegs; ++k) {
      const auto foot = [&](const Pose& pose) { return leg(octopod(), from_posture({pose.base, pose.joints, {}}), k).foot; };
      const Vector3d way = foot(b) - foot(a), middle = 0.5 * (foot(a) + foot(b));
      if (way.norm() < 1e-3) continue;
      std::vector<Vector3d> vertices = with_wall.vertices;
      std::vector<std::array<int, 3>> triangles = with_wall.triangles;
      const Vector3d along = way.normalized(), side = along.unitOrthogonal() * 2e-4, up = along.cross(side).normalized() * 2e-4;
      const int first = static_cast<int>(vertices.size());
      vertices.insert(vertices.end(), {middle - side - up, middle + side - up, middle + up});
      triangles.push_back({first, first + 1, first + 2});
      const terrain::Terrain made = terrain::make_terrain(mesh::joined(vertices, triangles));
      const StepVerdict verdict = check_step(octopod(), terrain::Surface(made), step, walk().before(0), walk().options);
      ++blocked_points;
      refused += verdict.accepted ? 0 : 1;
    }
  }
  EXPECT_GT(blocked_points, 5);
  EXPECT_EQ(refused, blocked_points);
}

}  // namespace
}  // namespace foothold::octopod
