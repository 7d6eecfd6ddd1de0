// Every refusal of a plugin is one sentence with both values.
#include <gtest/gtest.h>

#include <cstring>

#include "worker/loader.hpp"

namespace foothold::server {
namespace {

std::string refusal_of(const std::string& path) {
  try {
    load_plugin(path);
    return "";
  } catch (const PluginRefused& refused) {
    return refused.what();
  }
}

std::string test_plugin(const std::string& name) { return std::string(FOOTHOLD_TEST_PLUGINS) + "/" + name + ".so"; }

void expect_words(const std::string& sentence, std::initializer_list<std::string> words) {
  for (const std::string& word : words) EXPECT_NE(sentence.find(word), std::string::npos) << "'" << word << "' in: " << sentence;
}

TEST(Loader, TakesAPluginThatWasBuiltAsItWas) {
  const PluginDescriptor& plugin = load_plugin(test_plugin("many"));
  EXPECT_STREQ(plugin.info.name, "many");
  EXPECT_EQ(abi_mismatch(plugin.abi), std::nullopt);
}

TEST(Loader, RefusesAnotherApiVersionWithBoth) {
  expect_words(refusal_of(test_plugin("unlike_api")), {"unlike_api.so", "API version " + std::to_string(2 * kApiVersion),
                                                       "this server has " + std::to_string(kApiVersion)});
}

TEST(Loader, RefusesAnotherSizeWithBoth) {
  expect_words(refusal_of(test_plugin("unlike_step")), {"Step of " + std::to_string(2 * sizeof(Step)) + " octets",
                                                        "this server one of " + std::to_string(sizeof(Step)) + " octets"});
}

TEST(Loader, RefusesAnotherAlignmentOfEigenWithBothAndWhatToDo) {
  expect_words(refusal_of(test_plugin("unlike_eigen")), {"Eigen aligned to " + std::to_string(2 * EIGEN_MAX_ALIGN_BYTES),
                                                         std::to_string(EIGEN_MAX_ALIGN_BYTES) + " octets", "-m options"});
}

TEST(Loader, RefusesALibraryWithoutTheEntryPoint) {
  expect_words(refusal_of(test_plugin("no_entry")), {"no_entry.so", kEntryPoint, "FOOTHOLD_EXPORT_PLANNER"});
}

TEST(Loader, PassesOnWhatTheSystemSaysOfAMissingOrBrokenFile) {
  expect_words(refusal_of("/nowhere/none.so"), {"/nowhere/none.so", "No such file"});
  expect_words(refusal_of("/etc/passwd"), {"/etc/passwd"});
  expect_words(refusal_of("none.so"), {"none.so", "is not a path"});
}

struct Difference {
  const char* name;
  void (*change)(PluginAbi&);
  const char* words;
};

TEST(Loader, EveryMemberOfTheLayoutIsCompared) {
  const Difference differences[] = {
      {"api_version", [](PluginAbi& abi) { abi.api_version = 77; }, "API version 77, this server has 1"},
      {"size", [](PluginAbi& abi) { abi.size = 12; }, "in 12 octets, this server in"},
      {"alignof_step", [](PluginAbi& abi) { abi.alignof_step = 64; }, "aligns Step to 64 octets, this server to"},
      {"sizeof_step", [](PluginAbi& abi) { abi.sizeof_step = 1; }, "Step of 1 octets"},
      {"sizeof_request", [](PluginAbi& abi) { abi.sizeof_request = 1; }, "Request of 1 octets"},
      {"sizeof_report", [](PluginAbi& abi) { abi.sizeof_report = 1; }, "PlanReport of 1 octets"},
      {"sizeof_shape", [](PluginAbi& abi) { abi.sizeof_shape = 1; }, "Shape of 1 octets"},
      {"sizeof_context", [](PluginAbi& abi) { abi.sizeof_context = 1; }, "PlanContext of 1 octets"},
      {"sizeof_info", [](PluginAbi& abi) { abi.sizeof_info = 1; }, "PlannerInfo of 1 octets"},
      {"sizeof_spec", [](PluginAbi& abi) { abi.sizeof_spec = 1; }, "ParameterSpec of 1 octets"},
      {"sizeof_verdict", [](PluginAbi& abi) { abi.sizeof_verdict = 1; }, "StepVerdict of 1 octets"},
      {"sizeof_scene", [](PluginAbi& abi) { abi.sizeof_scene = 1; }, "Scene of 1 octets"},
      {"sizeof_model", [](PluginAbi& abi) { abi.sizeof_model = 1; }, "RobotModel of 1 octets"},
      {"sizeof_parameters", [](PluginAbi& abi) { abi.sizeof_parameters = 1; }, "Parameters of 1 octets"},
      {"eigen_max_align", [](PluginAbi& abi) { abi.eigen_max_align = 64; }, "aligned to 64 octets"},
      {"cxx11_abi", [](PluginAbi& abi) { abi.cxx11_abi = 0; }, "_GLIBCXX_USE_CXX11_ABI=0, this server with 1"},
      {"compiler", [](PluginAbi& abi) { std::strcpy(abi.compiler, "clang 14.0.6"); }, "by clang 14.0.6, this server by gcc"}};
  for (const Difference& difference : differences) {
    PluginAbi theirs = this_abi(), ours = this_abi();
    std::strcpy(ours.compiler, "gcc 12.2.0");
    std::strcpy(theirs.compiler, "gcc 12.2.0");
    difference.change(theirs);
    const auto sentence = abi_mismatch(theirs, ours);
    ASSERT_TRUE(sentence.has_value()) << difference.name;
    expect_words(*sentence, {difference.words});
  }
}

TEST(Loader, MinorVersionsOfACompilerAgreeAndMajorOnesDoNot) {
  PluginAbi theirs = this_abi(), ours = this_abi();
  std::strcpy(ours.compiler, "gcc 12.2.0");
  std::strcpy(theirs.compiler, "gcc 12.3.1");
  EXPECT_EQ(abi_mismatch(theirs, ours), std::nullopt);
  std::strcpy(theirs.compiler, "gcc 1.2.0");
  EXPECT_TRUE(abi_mismatch(theirs, ours).has_value());
  std::strcpy(theirs.compiler, "gcc 13.1.0");
  EXPECT_TRUE(abi_mismatch(theirs, ours).has_value());
}

}  // namespace
}  // namespace foothold::server
