// A plan through a real worker process, and what is left when one dies.
#include "fixture.hpp"

namespace foothold::server::test {
namespace {

TEST(Workers, APlanComesBackStepByStepWithItsSummary) {
  Rig rig;
  rig.open({Rig::robot("many")});
  const auto status = rig.workers->status("many");
  EXPECT_TRUE(status.known);
  EXPECT_EQ(status.info.state(), msg::READY);
  EXPECT_EQ(status.info.plugin(), "many");
  EXPECT_EQ(status.info.parameters().size(), 2u);
  EXPECT_EQ(status.info.limbs(), (std::vector<std::string>{"left", "right"}));

  const Heard& heard = rig.plan(Rig::request("many", {{"steps", "25"}}));
  ASSERT_EQ(heard.ends.size(), 1u);
  const RunEnd& end = heard.ends[0];
  EXPECT_EQ(end.kind, RunEnd::Kind::kReport);
  EXPECT_EQ(end.state, msg::SUCCEEDED) << end.error.message();
  ASSERT_EQ(heard.steps.size(), 25u);
  EXPECT_EQ(end.summary.steps(), 25u);
  EXPECT_TRUE(end.summary.optimal());
  EXPECT_EQ(end.summary.parameters().size(), 2u);
  EXPECT_EQ(end.summary.parameters()[1].value(), "0") << "the default is filled in";
  EXPECT_NEAR(heard.steps[24].base().position().x(), 2.5, 1e-9);
  ASSERT_EQ(heard.steps[24].margins().size(), 1u);
  EXPECT_EQ(heard.steps[24].margins()[0].name(), "advance");
  EXPECT_TRUE(rig.workers->has_idle("many"));
}

TEST(Workers, ACrashEndsItsRunWithTheSignalAndTheLastWords) {
  Rig rig;
  rig.open({Rig::robot("crash")});
  const Heard& heard = rig.plan(Rig::request("crash"));
  ASSERT_EQ(heard.ends.size(), 1u);
  EXPECT_EQ(heard.ends[0].kind, RunEnd::Kind::kLost);
  EXPECT_EQ(heard.ends[0].error.code(), msg::WORKER_CRASHED);
  EXPECT_NE(heard.ends[0].error.message().find("SIGSEGV"), std::string::npos) << heard.ends[0].error.message();
  EXPECT_NE(heard.ends[0].error.message().find("crash.so"), std::string::npos) << heard.ends[0].error.message();
  EXPECT_EQ(heard.steps.size(), 3u) << "what was sent before the crash stays";
}

TEST(Workers, AWorkerThatDiedIsStartedAgain) {
  Rig rig;
  rig.open({Rig::robot("crash")});
  rig.plan(Rig::request("crash"));
  EXPECT_FALSE(rig.workers->has_idle("crash"));
  rig.run_until([&] { return rig.workers->has_idle("crash"); });
  EXPECT_EQ(rig.plan(Rig::request("crash", {{"how", "not"}})).ends[0].state, msg::SUCCEEDED);
}

}  // namespace
}  // namespace foothold::server::test
