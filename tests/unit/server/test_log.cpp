// Lines of the log as text and as entries of systemd's journal.
#include <gtest/gtest.h>
#include <spdlog/spdlog.h>

#include "log/log.hpp"

namespace foothold::server::log {
namespace {

TEST(Log, FieldsStandBehindTheSentenceAndAreQuotedWhereTheyMustBe) {
  const std::vector<Field> fields = {{"robot", "walker"}, {"unit", "yard 3"}, {"error", ""}, {"field", "a\"b\\c\nd=e"}};
  EXPECT_EQ(as_text(fields), " robot=walker unit=\"yard 3\" field=\"a\\\"b\\\\c d=e\"");
}

TEST(Log, TheJournalGetsTheSentenceItsPriorityAndEachField) {
  const std::vector<Field> fields = {{"request", "0123"}, {"robot", "walker"}, {"error", ""}};
  EXPECT_EQ(as_journal_entry(Level::kWarn, "request ended CRASHED", fields),
            (std::vector<std::string>{"MESSAGE=request ended CRASHED", "PRIORITY=4", "SYSLOG_IDENTIFIER=footholdd",
                                      "FOOTHOLD_REQUEST=0123", "FOOTHOLD_ROBOT=walker"}));
}

TEST(Log, TheTailHoldsTheLatestLinesOfTheLevelsThatAreOn) {
  open("info");
  say(Level::kDebug, "not on", {});
  for (std::size_t i = 0; i < kTail + 10; ++i) say(Level::kInfo, "line " + std::to_string(i), {{"robot", "walker"}});
  spdlog::warn("by spdlog alone");
  const auto lines = tail();
  ASSERT_EQ(lines.size(), kTail);
  EXPECT_TRUE(lines.front().ends_with(" info line 11 robot=walker")) << lines.front();
  EXPECT_TRUE(lines.back().ends_with(" warning by spdlog alone")) << lines.back();
  set_level("debug");
  say(Level::kDebug, "on now", {});
  EXPECT_TRUE(tail().back().ends_with(" debug on now"));
}

TEST(Log, BracesOfASentenceAreNoFormat) {
  open("info");
  say(Level::kInfo, "a {} b {0}", {});
  EXPECT_TRUE(tail().back().ends_with(" info a {} b {0}"));
}

}  // namespace
}  // namespace foothold::server::log
