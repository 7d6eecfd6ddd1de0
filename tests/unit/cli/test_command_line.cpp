// The program itself: what it says of wrong arguments, its manual pages and its completions.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace foothold::test {
namespace {

struct Result {
  int code;
  std::string said;  // stdout and stderr
};

Result shell(const std::string& command) {
  std::FILE* pipe = popen(("( " + command + " ) 2>&1 </dev/null").c_str(), "r");
  Result result{-1, {}};
  std::array<char, 4096> piece;
  while (const std::size_t count = std::fread(piece.data(), 1, piece.size(), pipe)) result.said.append(piece.data(), count);
  const int status = pclose(pipe);
  if (WIFEXITED(status)) result.code = WEXITSTATUS(status);
  return result;
}

Result foothold(const std::string& arguments) { return shell(FOOTHOLD_PROGRAM " " + arguments); }

struct Wrong {
  const char* arguments;
  const char* says;
};

class WrongArguments : public testing::TestWithParam<Wrong> {};

TEST_P(WrongArguments, AreRefusedWithWhatWasMeant) {
  const Result result = foothold(GetParam().arguments);
  EXPECT_EQ(result.code, 2);
  EXPECT_EQ(result.said.find(GetParam().says), 0u) << result.said;
}

INSTANTIATE_TEST_SUITE_P(
    All, WrongArguments,
    testing::Values(Wrong{"", "foothold: a command is missing; known: robots, plan"},
                    Wrong{"pla", "foothold: 'pla' is no command; did you mean 'plan'?"},
                    Wrong{"scene", "foothold: scene: a command is missing; known: put, list"},
                    Wrong{"scene putt", "foothold: scene: 'putt' is no command; did you mean 'put'?"},
                    Wrong{"plan", "foothold: plan: request is required"}, Wrong{"plan a b", "foothold: plan: 'b' is too much"},
                    Wrong{"plan a --bugdet 3", "foothold: plan: '--bugdet' is no option; did you mean '--budget'?"},
                    Wrong{"robots --timout 3", "foothold: robots: '--timout' is no option; did you mean '--timeout'?"},
                    Wrong{"--timeout nan robots", "foothold: robots: --timeout: expected seconds above 0, not 'nan'"},
                    Wrong{"--domain 201 robots", "foothold: robots: --domain: Value 201 not in range 0 to 200"},
                    Wrong{"--dds ospl robots", "foothold: robots: --dds: ospl not in {cyclone,fastdds}"},
                    Wrong{"plan /nowhere.yaml", "foothold: /nowhere.yaml: cannot be read: No such file or directory"},
                    Wrong{"replay /nowhere.json", "foothold: /nowhere.json: cannot be read: No such file or directory"},
                    Wrong{"cancel 12", "foothold: '12' is no request's id"},
                    Wrong{"plugin info /nowhere.so", "foothold: /nowhere.so: no such file"}));

TEST(CommandLine, HelpTellsEveryExitCode) {
  const Result result = foothold("--help");
  EXPECT_EQ(result.code, 0);
  for (const char* line : {"\n  3   PARTIAL", "\n  4   FAILED", "\n  5   CANCELLED", "\n  6   EXPIRED", "\n  7   CRASHED",
                           "\n  8   REJECTED", "\n  9   no server", "\n  10  no server knows", "\n  130 interrupted"})
    EXPECT_NE(result.said.find(line), std::string::npos) << line;
}

TEST(CommandLine, ColoursAreForTerminalsOnly) { EXPECT_EQ(foothold("--help").said.find('\033'), std::string::npos); }

TEST(CommandLine, SaysWhenItsOutputCannotBeWritten) {
  const Result result = shell(FOOTHOLD_PROGRAM " --help >/dev/full");
  EXPECT_EQ(result.code, 1);
  EXPECT_EQ(result.said, "foothold: the output could not be written: No space left on device\n");
}

class Documents : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = testing::TempDir() + "foothold_documents_" + testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::remove_all(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string folder_;
};

TEST_F(Documents, EveryCommandHasAManualPageThatGroffTakes) {
  ASSERT_EQ(foothold("generate man " + folder_).code, 0);
  for (const char* name : {"foothold", "foothold-plan", "foothold-scene-put", "foothold-plugin-info", "foothold-doctor"})
    EXPECT_TRUE(std::filesystem::exists(folder_ + "/" + name + ".1")) << name;
  for (const auto& page : std::filesystem::directory_iterator(folder_)) {
    const Result result = shell("groff -man -ww -z " + page.path().string());
    EXPECT_EQ(result.code, 0) << page.path();
    EXPECT_EQ(result.said, "") << page.path();
  }
  const Result shown = shell("groff -man -Tutf8 -P-cbu -rLL=200n " + folder_ + "/foothold-plan.1");
  EXPECT_NE(shown.said.find("--budget SECONDS"), std::string::npos) << shown.said;
}

// What bash offers when this is typed and the tab key is pressed at its end.
std::string bash_offers(const std::string& folder, const std::string& typed) {
  return shell("bash --norc -c '. " + folder + "/foothold; read -ra COMP_WORDS <<< \"" + typed + "\"; [[ \"" + typed +
               "\" == *\" \" ]] && COMP_WORDS+=(\"\"); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _foothold; echo \"${COMPREPLY[@]}\"'")
      .said;
}

TEST_F(Documents, BashCompletionOffersCommandsOptionsAndWords) {
  ASSERT_EQ(foothold("generate completion bash " + folder_).code, 0);
  ASSERT_EQ(shell("bash -n " + folder_ + "/foothold").code, 0);
  EXPECT_EQ(bash_offers(folder_, "foothold pla"), "plan\n");
  EXPECT_EQ(bash_offers(folder_, "foothold s"), "state scene security\n");
  EXPECT_EQ(bash_offers(folder_, "foothold scene "), "put list -h --help\n");
  EXPECT_EQ(bash_offers(folder_, "foothold --dds f"), "fastdds\n");
  EXPECT_EQ(bash_offers(folder_, "foothold plan x.yaml --bud"), "--budget\n");
  EXPECT_EQ(bash_offers(folder_, "foothold plan " + folder_ + "/foo"), folder_ + "/foothold\n");
  EXPECT_EQ(bash_offers(folder_, "foothold gen"), "\n");
}

TEST_F(Documents, OtherShellsTakeTheirCompletions) {
  for (const std::string name : {"zsh", "fish"}) {
    ASSERT_EQ(foothold("generate completion " + name + " " + folder_).code, 0);
    if (shell("command -v " + name).code != 0) continue;
    const Result result = shell(name + " -n " + folder_ + (name == "zsh" ? "/_foothold" : "/foothold.fish"));
    EXPECT_EQ(result.code, 0) << result.said;
  }
  std::ifstream fish(folder_ + "/foothold.fish");
  const std::string text(std::istreambuf_iterator<char>(fish), {});
  EXPECT_NE(text.find("complete -c foothold -n '__fish_use_subcommand' -a plan"), std::string::npos);
  EXPECT_NE(text.find("-n '__fish_seen_subcommand_from plan' -l budget -x"), std::string::npos);
}

}  // namespace
}  // namespace foothold::test
