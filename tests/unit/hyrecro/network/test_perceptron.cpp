// Inference and the weights file's form.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "fixtures.hpp"

namespace foothold::hyrecro {
namespace {

TEST(Perceptron, AgreesWithPlainLoopsInDouble) {
  std::mt19937_64 random(1);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Perceptron net = noisy_perceptron(seed, 0.3F);
    const std::vector<double> w = doubles(net);
    for (int i = 0; i < 500; ++i) {
      const NetworkInputs inputs = noisy_inputs(random);
      const double expected = reference_logit(w, inputs);
      ASSERT_NEAR(logit(net, inputs), expected, 1e-4 * (1.0 + std::fabs(expected)));
    }
  }
}

TEST(Perceptron, GivesTheSameBitsWithAndWithoutVectorInstructions) {
  std::mt19937_64 random(2);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Perceptron net = noisy_perceptron(seed, 0.3F);
    for (int i = 0; i < 2000; ++i) {
      const NetworkInputs inputs = noisy_inputs(random);
      const float fast = logit(net, inputs), plain = logit_plain(net, inputs);
      ASSERT_EQ(std::memcmp(&fast, &plain, sizeof fast), 0) << fast << " against " << plain;
    }
  }
}

TrainedPerceptron some() {
  TrainedPerceptron out;
  out.comment = "How it was made\n\nin three lines\n";
  out.kind = "face";
  out.robot = "0.04 0.19";
  out.clearance = 0.005;
  out.radius = 0.1 + 0.2;
  out.fresh = 1000;
  out.seed = 18446744073709551615ULL;
  out.reachable = 400;
  out.false_positives = 3;
  out.false_negatives = 4;
  out.net = noisy_perceptron(7, 0.3F);
  return out;
}

TEST(WeightsFile, GivesBackWhatWasWritten) {
  const TrainedPerceptron out = some(), in = from_text(to_text(out));
  EXPECT_EQ(in.comment, out.comment);
  EXPECT_EQ(in.kind, out.kind);
  EXPECT_EQ(in.robot, out.robot);
  EXPECT_EQ(in.clearance, out.clearance);
  EXPECT_EQ(in.radius, out.radius);
  EXPECT_EQ(in.fresh, out.fresh);
  EXPECT_EQ(in.seed, out.seed);
  EXPECT_EQ(in.reachable, out.reachable);
  EXPECT_EQ(in.false_positives, out.false_positives);
  EXPECT_EQ(in.false_negatives, out.false_negatives);
  EXPECT_EQ(in.net.values, out.net.values);
}

// The message for a text in which `from` is replaced by `to`.
std::string refusal(const std::string& from, const std::string& to) {
  std::string text = to_text(some());
  text.replace(text.find(from), from.size(), to);
  try {
    from_text(text);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(WeightsFile, SaysWhatIsWrongWithABrokenOne) {
  EXPECT_NE(refusal("kind", "sort").find("'kind' expected, found 'sort'"), std::string::npos);
  EXPECT_NE(refusal("clearance 0.005", "clearance much").find("clearance is no number: 'much"), std::string::npos);
  const std::string count = std::to_string(Perceptron::kCount);
  EXPECT_NE(refusal("weights " + count, "weights 12").find(count + " numbers expected, not 12"), std::string::npos);
  std::string text = to_text(some());
  text.erase(text.find_last_of('\n', text.size() - 2));
  EXPECT_THROW(from_text(text), std::runtime_error);
  EXPECT_THROW(from_text(to_text(some()) + "1.5"), std::runtime_error);
  EXPECT_THROW(from_text(""), std::runtime_error);
}

}  // namespace
}  // namespace foothold::hyrecro
