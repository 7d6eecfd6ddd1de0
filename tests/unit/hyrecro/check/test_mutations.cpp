// Right steps, changed at random, before two judges: what the second one proves wrong the first one must refuse, and what is right
// with some room to spare it must accept.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

#include "dense_judge.hpp"

namespace foothold::hyrecro {
namespace {

constexpr int kMutations = 12;

class Mutations : public testing::Test {
 protected:
  double small(double least, double most) {
    return (levels_.integer(0, 1) == 0 ? -1 : 1) * std::pow(10.0, levels_.uniform(least, most));
  }
  std::size_t point(const Walk& w) {
    return static_cast<std::size_t>(levels_.integer(0, static_cast<int>(w.step.motion.size()) - 1));
  }
  std::size_t joint() { return static_cast<std::size_t>(levels_.integer(0, 9)); }

  // Bases where the joints put them, times that the joints' speeds allow: so that other wrongs are looked at.
  void repair(Walk& w, Foot holds) {
    double time = 0.0;
    for (std::size_t k = 0; k < w.step.motion.size(); ++k) {
      MotionPoint& now = w.step.motion[k];
      now.base = w.before.stance[0].frame * chain_by_the_paper(model_, now.joints, holds).base;
      double needed = k == 0 ? 0.0 : 1e-3;
      for (std::size_t j = 0; j < kJoints && k > 0; ++j)
        needed = std::max(
            needed, std::fabs(now.joints[j] - w.step.motion[k - 1].joints[j]) / (j < 8 ? model_.actuator_speed : model_.hip_speed));
      now.time = time += needed * (1.0 + 1e-6);
    }
  }

  void mutate(int kind, Walk& w, truss::Truss& truss, Foot holds) {
    std::vector<MotionPoint>& motion = w.step.motion;
    const Isometry3d held = w.before.stance[0].frame;
    const auto near_a_body = [&] {
      const Chain is = chain_by_the_paper(model_, motion[point(w)].joints, holds);
      const Vector3d spot = levels_.integer(0, 1) == 0
                                ? is.bodies.plate[1].pose.translation()
                                : Vector3d(is.bodies.leg[1].a + levels_.uniform(0, 1) * (is.bodies.leg[1].b - is.bodies.leg[1].a));
      return Vector3d(held * spot + Vector3d(levels_.uniform(-0.1, 0.1), levels_.uniform(-0.1, 0.1), levels_.uniform(-0.05, 0.1)));
    };
    switch (kind) {
      case 0:
        return;
      case 1:
        return add_box(truss, "stone", near_a_body(), Vector3d::Constant(levels_.uniform(0.0, 0.03)));
      case 2:
        return add_box(truss, "wire", near_a_body(), Vector3d(1e-4, 1e-4, levels_.uniform(0.0, 0.1)));
      case 3:
        motion[point(w)].joints[joint()] += small(-7.0, -2.0);
        return repair(w, holds);
      case 4:
        for (int k = levels_.integer(1, 6); k > 0; --k) motion.erase(motion.begin() + static_cast<std::ptrdiff_t>(point(w)));
        return repair(w, holds);
      case 5:
        std::swap(motion[point(w)].joints, motion[point(w)].joints);
        return repair(w, holds);
      case 6: {
        const Vector3d by(small(-9.0, -4.0), small(-9.0, -4.0), small(-9.0, -4.0));
        for (Contact* contact : {&w.step.placed[0], &w.step.after.stance[1]}) contact->frame.translation() += by;
        return;
      }
      case 7: {
        const Eigen::AngleAxisd by(small(-9.0, -4.0), Vector3d(small(0, 0), small(0, 0), small(0, 0)).normalized());
        for (Contact* contact : {&w.step.placed[0], &w.step.after.stance[1]}) contact->frame.rotate(by);
        return;
      }
      case 8: {
        const double edge = w.step.placed[0].frame.translation().x() + levels_.uniform(0.04, 0.08);
        truss.faces[0].outline = {{-1.5, -1.5}, {edge, -1.5}, {edge, 1.5}, {-1.5, 1.5}};
        return;
      }
      case 9: {
        const Vector3d at = w.step.placed[0].frame.translation();
        const double x = at.x() + levels_.uniform(-0.1, 0.1), y = at.y() + levels_.uniform(-0.1, 0.1),
                     s = levels_.uniform(0.001, 0.1);
        truss.faces[0].holes = {{{x, y}, {x, y + s}, {x + s, y}}};
        return;
      }
      case 10: {
        const double factor = levels_.uniform(0.9, 1.2);
        for (MotionPoint& now : motion) now.time *= factor;
        return;
      }
      default: {
        // The whole way over, in one straight piece.
        motion.erase(motion.begin() + 22, motion.end() - 22);
        return repair(w, holds);
      }
    }
  }

  const Model model_ = shipped_model();
  Levels levels_{model_, 7};
};

TEST_F(Mutations, AreAcceptedOnlyIfTheSecondJudgeFindsNothing) {
  const int rounds = std::getenv("FOOTHOLD_LONG") != nullptr ? 300 : 40;
  std::map<int, int> accepted, refused;
  for (int round = 0; round < rounds; ++round) {
    const Foot holds = round % 2 == 0 ? Foot::kA : Foot::kB;
    const Walk right = walk(model_, holds, levels_.foothold(), levels_.level(), levels_.level(), 10);
    if (!densely_judged(model_, floor_scene(), {}, right, holds, {true, 3}).empty()) continue;
    for (int kind = 0; kind < kMutations; ++kind) {
      Walk w = right;
      truss::Truss truss = floor_scene();
      mutate(kind, w, truss, holds);
      const StepVerdict verdict = check_step(model_, truss, Obstacles(truss), {}, w.step, w.before);
      if (verdict.accepted) {
        ++accepted[kind];
        const std::string wrong = densely_judged(model_, truss, {}, w, holds, {false, 40});
        EXPECT_EQ(wrong, "") << "mutation " << kind << " of round " << round << " was accepted";
      } else {
        ++refused[kind];
        EXPECT_NE(densely_judged(model_, truss, {}, w, holds, {true, 40}), "")
            << "mutation " << kind << " of round " << round << " is right: " << verdict.reason;
      }
    }
  }
  EXPECT_EQ(refused[0], 0);
  EXPECT_GT(accepted[0], rounds / 4);
  for (const int kind : {1, 2, 3, 4, 6, 7, 8, 9, 10}) {
    EXPECT_GT(refused[kind], 0) << kind;
    EXPECT_GT(accepted[kind], 0) << kind;
  }
}

// The second judge's own kinematics, and the first one's.
TEST_F(Mutations, BothJudgesKnowTheSameRobot) {
  for (int k = 0; k < 500; ++k) {
    std::vector<double> joints;
    for (int j = 0; j < 8; ++j) joints.push_back(levels_.uniform(model_.mechanism.shortest(), model_.mechanism.longest()));
    joints.push_back(levels_.uniform(-3.0, 3.0));
    joints.push_back(levels_.uniform(-3.0, 3.0));
    for (const Foot holds : {Foot::kA, Foot::kB}) {
      const Chain is = chain_by_the_paper(model_, joints, holds);
      const Bodies bodies = bodies_at(model_, from_joints(model_, joints, holds), Isometry3d::Identity());
      EXPECT_TRUE(is.sole[1].isApprox(forward(model_, from_joints(model_, joints, holds)), 1e-11));
      for (std::size_t j = 0; j < 2; ++j) {
        EXPECT_LT((is.bodies.leg[j].a - bodies.leg[j].a).norm() + (is.bodies.leg[j].b - bodies.leg[j].b).norm(), 1e-11);
        EXPECT_TRUE(is.bodies.plate[j].pose.isApprox(bodies.plate[j].pose, 1e-11));
      }
      EXPECT_LT((is.bodies.hip.pose.translation() - bodies.hip.pose.translation()).norm(), 1e-11);
      EXPECT_NEAR(std::fabs(is.bodies.hip.pose.linear().col(0).dot(bodies.hip.pose.linear().col(0))), 1.0, 1e-11);
    }
  }
}

}  // namespace
}  // namespace foothold::hyrecro
