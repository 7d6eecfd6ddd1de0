// The training program, run as a person would run it, in small.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "fixtures.hpp"

namespace foothold::hyrecro {
namespace {

std::string contents(const std::string& path) {
  std::ostringstream out;
  out << std::ifstream(path).rdbuf();
  return out.str();
}

int run(const std::string& words) {
  return std::system(
      (std::string(FOOTHOLD_TRAIN) + " --robot " FOOTHOLD_CONFIG_DIR "/robots/hyrecro.yaml " + words + " > /dev/null 2>&1")
          .c_str());
}

TEST(TrainingProgram, WritesTheSameWeightsForTheSameSeedOnAnyNumberOfThreads) {
  const std::string folder = testing::TempDir() + "hyrecro_train_" + std::to_string(::getpid());
  std::filesystem::create_directories(folder);
  const std::string one = folder + "/one.txt", two = folder + "/two.txt",
                    command = "--net face --poses 10000 --fresh 5000 --epochs 3 --out ";
  ASSERT_EQ(run(command + one), 0);
  ASSERT_EQ(run("--threads 2 " + command + two), 0);
  const std::string text = contents(one);
  EXPECT_EQ(text, contents(two));
  const TrainedPerceptron trained = from_text(text);
  EXPECT_EQ(trained.kind, "face");
  EXPECT_EQ(trained.robot, robot_numbers(model()));
  EXPECT_EQ(trained.fresh, 5000U);
  EXPECT_LT(trained.false_positives + trained.false_negatives, 1000U);
  EXPECT_NE(trained.comment.find("foothold-hyrecro-train --net face --poses 10000"), std::string::npos);
  std::filesystem::remove_all(folder);
}

TEST(TrainingProgram, RefusesWhatItCannotDo) {
  EXPECT_NE(run("--net sideways"), 0);
  EXPECT_NE(run("--net face --poses 1000 --fresh 10 --epochs 1 --out /nowhere/at/all.txt"), 0);
}

}  // namespace
}  // namespace foothold::hyrecro
