// The method `network` and the weights that are shipped with it.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "fixtures.hpp"
#include "hyrecro/reach/labels.hpp"
#include "hyrecro/reach/network.hpp"
#include "hyrecro/reach/reachability.hpp"

namespace foothold::hyrecro {
namespace {

class Shipped : public testing::TestWithParam<PoseKind> {
 protected:
  const PoseKind kind = GetParam();
  const Model m = model();
  const TrainedPerceptron trained = shipped_perceptron(kind);

  std::vector<Sample> fresh(std::size_t count, std::uint64_t seed) const {
    LabelOptions options;
    options.kind = kind;
    options.clearance = trained.clearance;
    options.radius = trained.radius;
    options.count = count;
    options.seed = seed;
    return labelled(m, options);
  }
};

double least_accuracy(PoseKind kind) { return kind == PoseKind::kFace ? 0.9832 : 0.9785; }  // the paper's

TEST_P(Shipped, WeightsAreForThisRobotAndFillTheirRadius) {
  EXPECT_EQ(trained.kind, name_of(kind));
  EXPECT_EQ(trained.robot, robot_numbers(m));
  EXPECT_EQ(trained.radius, farthest(kind, m));
  EXPECT_EQ(trained.fresh, 1000000U);
}

TEST_P(Shipped, HeaderClaimsAtLeastThePapersAccuracy) {
  const double wrong = static_cast<double>(trained.false_positives + trained.false_negatives);
  EXPECT_GE(1.0 - wrong / static_cast<double>(trained.fresh), least_accuracy(kind));
}

// Poses that neither the training nor the header's own measurement saw; five standard deviations are allowed.
TEST_P(Shipped, PerceptronIsAsGoodAsItsHeaderSays) {
  const std::vector<Sample> samples = fresh(long_run() ? 1000000 : 30000, 12345);
  const Accuracy measured = accuracy(trained.net, samples);
  EXPECT_GT(measured.share(), least_accuracy(kind));
  const auto near = [&](std::size_t counted, std::size_t claimed, const char* what) {
    const double part = static_cast<double>(claimed) / static_cast<double>(trained.fresh);
    const double poses = static_cast<double>(samples.size());
    const double deviation = std::sqrt(part * (1.0 - part) * (1.0 / poses + 1.0 / static_cast<double>(trained.fresh)));
    EXPECT_NEAR(static_cast<double>(counted) / poses, part, 5.0 * deviation) << what;
  };
  near(measured.reachable, trained.reachable, "reachable");
  near(measured.false_positives, trained.false_positives, "false positives");
  near(measured.false_negatives, trained.false_negatives, "false negatives");
}

TEST_P(Shipped, MethodAnswersAsThePerceptronOfThatKindDoes) {
  const std::unique_ptr<Reachability> network = make_network(m);
  std::mt19937_64 random(5);
  int reachable = 0;
  for (int i = 0; i < 20000; ++i) {
    const Isometry3d pose = random_pose(kind, trained.radius, random);
    const Reach answer = network->reach(pose, {});
    ASSERT_EQ(answer.reachable, logit(trained.net, inputs_of(kind, pose)) > 0.0F);
    ASSERT_FALSE(answer.coordinates.has_value());
    reachable += answer.reachable;
  }
  EXPECT_GT(reachable, 500);
  EXPECT_LT(reachable, 15000);
}

INSTANTIATE_TEST_SUITE_P(Networks, Shipped, testing::Values(PoseKind::kFace, PoseKind::kTransition),
                         [](const auto& one) { return std::string(name_of(one.param)); });

TEST(Network, KnowsNoPoseThatIsNeitherInTheFaceNorATransition) {
  const std::unique_ptr<Reachability> network = make_network(model());
  Isometry3d pose = Isometry3d::Identity();
  pose.translation() = Vector3d(0.3, 0.05, 0.0);
  pose.linear() = Eigen::AngleAxisd(0.4, Vector3d::UnitZ()).toRotationMatrix();
  EXPECT_TRUE(network->reach(pose, {}).reachable);
  pose.translation().z() = 0.02;
  EXPECT_FALSE(network->reach(pose, {}).reachable);
}

TEST(Network, ReachesNothingBeyondTheLegs) {
  const std::unique_ptr<Reachability> network = make_network(model());
  for (int i = 0; i < 3600; ++i) {
    Isometry3d pose = Isometry3d::Identity();
    pose.translation() = Eigen::AngleAxisd(i * 0.1, Vector3d::UnitZ()) * Vector3d(0.7, 0.0, 0.0);
    pose.linear() = Eigen::AngleAxisd(i * 0.03, Vector3d::UnitZ()).toRotationMatrix();
    ASSERT_FALSE(network->reach(pose, {}).reachable);
  }
}

TEST(Network, RefusesARobotThatItWasNotTrainedFor) {
  Model other = model();
  other.hip_distance += 0.01;
  try {
    make_network(other);
    FAIL() << "accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("train it anew"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace foothold::hyrecro
