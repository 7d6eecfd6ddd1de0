// Back-off and quarantine on a clock of the test's own.
#include <gtest/gtest.h>

#include "workers/health.hpp"

namespace foothold::server {
namespace {

using namespace std::chrono_literals;

constexpr Health::Time kBegin{1h};

WorkersConfig limits() {
  return {
      .restart_first = 0.5, .restart_longest = 3.0, .quarantine_crashes = 5, .quarantine_window = 60.0, .quarantine_time = 30.0};
}

TEST(Health, EachCrashInARowDoublesTheWaitUpToTheLongest) {
  Health health(limits());
  EXPECT_EQ(health.wait(kBegin), 0s);
  const Health::Duration waits[] = {500ms, 1s, 2s, 3s};
  for (const auto wait : waits) {
    EXPECT_FALSE(health.crashed(kBegin));
    EXPECT_EQ(health.wait(kBegin), wait);
  }
  EXPECT_EQ(health.wait(kBegin + 3s), 0s);
}

TEST(Health, AFinishedPlanEndsTheBackOff) {
  Health health(limits());
  health.crashed(kBegin);
  health.crashed(kBegin);
  health.proved();
  health.crashed(kBegin + 1min);
  EXPECT_EQ(health.wait(kBegin + 1min), 500ms);
}

TEST(Health, CrashesWithinTheWindowQuarantineAndThoseBeforeDoNot) {
  Health health(limits());
  for (int i = 0; i < 20; ++i) EXPECT_FALSE(health.crashed(kBegin + i * 16s)) << i;
  const auto now = kBegin + 19 * 16s + 8s;
  EXPECT_FALSE(health.quarantined(now));
  EXPECT_TRUE(health.crashed(now)) << "the fifth within 60 s";
  EXPECT_TRUE(health.quarantined(now));
  EXPECT_EQ(health.wait(now), 30s);
  EXPECT_FALSE(health.on_trial(now));
}

TEST(Health, PlansInBetweenDoNotHideCrashes) {
  Health health(limits());
  for (int i = 0; i < 4; ++i) {
    EXPECT_FALSE(health.crashed(kBegin + i * 1s));
    health.proved();
  }
  EXPECT_TRUE(health.crashed(kBegin + 5s));
}

class Quarantined : public ::testing::Test {
 protected:
  Quarantined() {
    for (int i = 0; i < 5; ++i) health.crashed(kBegin);
  }
  Health health{limits()};
};

TEST_F(Quarantined, EndsInATrial) {
  EXPECT_TRUE(health.quarantined(kBegin + 29s));
  EXPECT_FALSE(health.quarantined(kBegin + 30s));
  EXPECT_TRUE(health.on_trial(kBegin + 30s));
  EXPECT_EQ(health.wait(kBegin + 30s), 0s);
}

TEST_F(Quarantined, AFailedTrialQuarantinesAtOnce) {
  EXPECT_TRUE(health.crashed(kBegin + 5min));
  EXPECT_EQ(health.wait(kBegin + 5min), 30s);
}

TEST_F(Quarantined, APassedTrialForgives) {
  health.proved();
  EXPECT_FALSE(health.on_trial(kBegin + 40s));
  EXPECT_FALSE(health.crashed(kBegin + 41s));
  EXPECT_EQ(health.wait(kBegin + 41s), 500ms);
}

TEST_F(Quarantined, FurtherDeathsDoNotProlongIt) {
  EXPECT_FALSE(health.crashed(kBegin + 10s));
  EXPECT_EQ(health.wait(kBegin + 10s), 20s);
}

}  // namespace
}  // namespace foothold::server
