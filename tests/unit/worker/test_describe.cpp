// foothold-worker by hand: what a plugin holds, as JSON.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace foothold::server {
namespace {

struct Answer {
  int code = -1;
  nlohmann::json json;
};

Answer describe(const std::string& arguments) {
  const std::string command = std::string(FOOTHOLD_WORKER) + " " + arguments + " 2>/dev/null";
  std::FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  const int status = pclose(pipe);
  return {WEXITSTATUS(status), nlohmann::json::parse(text, nullptr, false)};
}

std::string test_plugin(const std::string& name) { return "--describe " + std::string(FOOTHOLD_TEST_PLUGINS) + "/" + name + ".so"; }

// A robot's file of its own for each test.
class RobotFile {
 public:
  explicit RobotFile(const std::string& model) {
    path_ = std::filesystem::temp_directory_path() / ("foothold_describe_" + std::to_string(getpid()) + ".yaml");
    std::ofstream(path_) << "robot: r\nplugin: model\nmodel:\n" << model;
  }
  ~RobotFile() { std::filesystem::remove(path_); }
  std::string option() const { return " --robot " + path_.string(); }

 private:
  std::filesystem::path path_;
};

TEST(Describe, TellsNameVersionSchemaAndLayout) {
  const Answer answer = describe(test_plugin("many"));
  EXPECT_EQ(answer.code, 0);
  EXPECT_EQ(answer.json.at("plugin"), "many");
  EXPECT_EQ(answer.json.at("version"), "1.0.0");
  EXPECT_EQ(answer.json.at("limbs"), nlohmann::json({"left", "right"}));
  EXPECT_EQ(answer.json.at("abi").at("api_version"), 1);
  const auto& steps = answer.json.at("parameters").at(0);
  EXPECT_EQ(steps.at("name"), "steps");
  EXPECT_EQ(steps.at("kind"), "integer");
  EXPECT_EQ(steps.at("maximum"), 1e6);
}

TEST(Describe, ARefusalIsToldWithExitCodeOne) {
  const Answer answer = describe(test_plugin("unlike_api"));
  EXPECT_EQ(answer.code, 1);
  EXPECT_EQ(answer.json.at("refused").at("name"), "PLUGIN_REFUSED");
  EXPECT_NE(answer.json.at("refused").at("message").get<std::string>().find("API version 2"), std::string::npos);
  EXPECT_EQ(describe(test_plugin("schema_twice")).code, 1);
}

TEST(Describe, ARobotsModelIsTriedOnItsPlanner) {
  EXPECT_EQ(
      describe(test_plugin("model") + RobotFile("  body:\n    length: {value: 100, unit: mm, source: assumed}\n").option()).code,
      0);
  const Answer missing = describe(test_plugin("model") + RobotFile("  mass: {value: 1, unit: kg, source: assumed}\n").option());
  EXPECT_EQ(missing.code, 1);
  EXPECT_EQ(missing.json.at("refused").at("field"), "model.body.length");
  const Answer broken = describe(test_plugin("model") + RobotFile("  mass: {value: heavy, unit: kg, source: assumed}\n").option());
  EXPECT_EQ(broken.code, 1);
  EXPECT_EQ(broken.json.at("refused").at("field"), "model.mass.value");
}

TEST(Describe, WithoutADaemonTheWorkerSaysWhatItIsFor) { EXPECT_EQ(describe("").code, 2); }

}  // namespace
}  // namespace foothold::server
