// What crashed and slow plans leave: which, how many, and what the report says.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "bundles/bundles.hpp"
#include "bundles/report.hpp"
#include "fakes.hpp"
#include "journal/view.hpp"
#include "temporary_folder.hpp"

namespace foothold::server::testing {
namespace {
namespace fs = std::filesystem;

class BundlesTest : public ::testing::Test {
 protected:
  void end(const std::string& name, msg::State state, double planned, bool killed = false, const std::string& message = "why") {
    const auto request = good_request(name);
    msg::PlanEvent event;
    event.request(request.id());
    event.state(state);
    event.stamp(stamp_ += 1'000'000'000);
    event.error().message(message);
    bundles_.on_ended({.request = request, .event = event, .ran = true, .planned = planned, .killed = killed});
  }
  std::vector<std::string> made(const std::string& kind) const {
    std::vector<std::string> names;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder_ / kind, none)) names.push_back(entry.path().filename());
    std::ranges::sort(names);
    return names;
  }
  std::string report(const std::string& kind) const {
    std::ifstream in(folder_ / (kind + "/" + made(kind).at(0) + "/report.txt"));
    return {std::istreambuf_iterator<char>(in), {}};
  }

  test::TemporaryFolder folder_;
  Stamp stamp_ = 1'700'000'000'000'000'000;
  std::vector<std::pair<std::function<void()>, std::function<void()>>> waiting_;
  bool at_once_ = true;
  std::vector<std::string> told_, complaints_;
  Bundles bundles_{folder_.path().string(),
                   folder_ / "journal.db",
                   "0.1.0",
                   {.slow = 5.0, .keep = 3},
                   {.background =
                        [this](std::function<void()> work, std::function<void()> then) {
                          if (!at_once_) return waiting_.emplace_back(work, then), void();
                          work();
                          then();
                        },
                    .tell = [this](const std::string& place) { told_.push_back(place); },
                    .complain = [this](const std::string& sentence) { complaints_.push_back(sentence); }}};
};

TEST_F(BundlesTest, OnlyCrashedKilledAndSlowPlansLeaveOne) {
  end("quick", msg::SUCCEEDED, 4.9);
  end("fails", msg::FAILED, 1.0);
  EXPECT_TRUE(told_.empty());
  end("slow", msg::SUCCEEDED, 5.0);
  end("crashes", msg::CRASHED, 0.1);
  end("killed", msg::EXPIRED, 1.0, true);
  EXPECT_EQ(made("slow").size(), 1U);
  EXPECT_EQ(made("crashed").size(), 2U);
  EXPECT_NE(made("slow")[0].find(msg::to_hex(msg::id_of("slow"))), std::string::npos);
  EXPECT_NE(report("slow").find("why: the plan took longer than bundles.slow"), std::string::npos);
}

TEST_F(BundlesTest, OfEachKindOnlyTheNewestStay) {
  for (int i = 0; i < 10; ++i) end("slow " + std::to_string(i), msg::SUCCEEDED, 6.0);
  for (int i = 0; i < 10; ++i) end("crash " + std::to_string(i), msg::CRASHED, 0.1);
  EXPECT_EQ(made("slow").size(), 3U);
  ASSERT_EQ(made("crashed").size(), 3U);
  EXPECT_NE(made("crashed")[2].find(msg::to_hex(msg::id_of("crash 9"))), std::string::npos);
}

TEST_F(BundlesTest, WhatTheReportSaysOfACrash) {
  end("crashes", msg::CRASHED, 0.25, false,
      "worker 77 died of SIGSEGV; its last words: signal SIGSEGV at address 0x10 | /lib/walker.so(+0x12) [0x34] | main");
  const std::string text = report("crashed");
  for (const char* line : {"why: its worker died\n", "robot: walker\n", "state: CRASHED\n", "message: worker 77 died of SIGSEGV\n",
                           "signal: SIGSEGV\n", "planned_s: 0.250000\n", "seed: 42\n", "server: 0.1.0\n",
                           "  signal SIGSEGV at address 0x10\n  /lib/walker.so(+0x12) [0x34]\n  main\n"})
    EXPECT_NE(text.find(line), std::string::npos) << line << "is not in:\n" << text;
}

TEST_F(BundlesTest, ThePlanIsThereForAReplay) {
  end("crashes", msg::CRASHED, 0.25);
  std::ifstream in(folder_ / ("crashed/" + made("crashed")[0] + "/plan.entries"), std::ios::binary);
  const std::string octets((std::istreambuf_iterator<char>(in)), {});
  EntryView view;
  ASSERT_TRUE(visit_entries(std::as_bytes(std::span(octets)), [&](const Entry& entry) { view.add(entry); }));
  const auto* known = view.find(msg::id_of("crashes"));
  ASSERT_NE(known, nullptr);
  EXPECT_EQ(known->record.request, good_request("crashes"));
  EXPECT_EQ(known->record.final_event->state(), msg::CRASHED);
}

TEST_F(BundlesTest, AFloodIsBoundedAndTold) {
  at_once_ = false;
  for (int i = 0; i < 100; ++i) end("crash " + std::to_string(i), msg::CRASHED, 0.1);
  EXPECT_EQ(waiting_.size(), Bundles::kMostWaiting);
  for (const auto& [work, then] : waiting_) work(), then();
  ASSERT_EQ(complaints_.size(), 2U);
  EXPECT_EQ(complaints_[1], "92 plans got no bundle");
}

TEST_F(BundlesTest, AFolderThatCannotBeWrittenIsToldAndNothingElseHappens) {
  std::ofstream(folder_ / "crashed") << "a file in the way";
  end("crashes", msg::CRASHED, 0.1);
  ASSERT_EQ(complaints_.size(), 1U);
  EXPECT_NE(complaints_[0].find("no bundle of a plan: "), std::string::npos);
}

TEST(BundleReport, ASignalIsFoundInTheWordsOfAWorkersEnd) {
  EXPECT_EQ(signal_in("worker 3 died of SIGABRT; its last words: x"), "SIGABRT");
  EXPECT_EQ(signal_in("signal SIGFPE at address 0x1"), "SIGFPE");
  EXPECT_EQ(signal_in("worker 3 exited with code 1"), "");
  EXPECT_EQ(last_words_in("no such words"), std::vector<std::string>{});
}

}  // namespace
}  // namespace foothold::server::testing
