// A journal read by somebody else: while its server writes, after it died, and spoilt.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "fakes.hpp"
#include "journal/journal.hpp"
#include "journal/view.hpp"
#include "temporary_folder.hpp"

namespace foothold::server::testing {
namespace {

bool any(const Record&) { return true; }

class JournalViewTest : public ::testing::Test {
 protected:
  // One request with steps; it ends as `state`, or not at all.
  void add(SqliteJournal& journal, const std::string& name, std::uint32_t steps, std::optional<msg::State> state) {
    const auto request = good_request(name);
    journal.add_request(request, ++stamp_);
    for (std::uint32_t i = 0; i < steps; ++i) journal.add_step(request.id(), i, step_bytes(request.id(), i, name));
    if (state) {
      msg::PlanEvent event;
      event.request(request.id());
      event.state(*state);
      event.stamp(++stamp_);
      journal.set_final(request.id(), event);
    }
    journal.commit();
  }
  static std::vector<std::string> told(const std::vector<Record>& records) {
    std::vector<std::string> out;
    for (const Record& record : records) {
      const std::string state(record.final_event ? msg::state_name(record.final_event->state()) : "UNFINISHED");
      out.push_back(msg::to_hex(record.request.id()).substr(0, 4) + " " + state + " " + std::to_string(record.steps));
    }
    return out;
  }
  static std::string row(const std::string& name, const std::string& rest) {
    return msg::to_hex(msg::id_of(name)).substr(0, 4) + " " + rest;
  }

  test::TemporaryFolder folder_;
  const std::string path_ = folder_ / "journal.db";
  Stamp stamp_ = 1'700'000'000'000'000'000;
};

TEST_F(JournalViewTest, ShowsWhatWasCommittedAtOnceWhileTheServerGoesOnWriting) {
  SqliteJournal journal(path_);
  for (int i = 0; i < 50; ++i) {
    const std::string name = std::to_string(i);
    add(journal, name, 2, i % 2 == 0 ? std::optional(msg::SUCCEEDED) : std::nullopt);
    JournalView view(path_);
    const auto latest = view.latest(1, any);
    ASSERT_EQ(told(latest), std::vector<std::string>{row(name, i % 2 == 0 ? "SUCCEEDED 2" : "UNFINISHED 2")});
    ASSERT_EQ(view.latest(1000, any).size(), static_cast<std::size_t>(i) + 1);
    ASSERT_EQ(view.steps(msg::id_of(name)), journal.steps(msg::id_of(name), 0));
  }
}

TEST_F(JournalViewTest, ShowsWhatAServerThatWasKilledLeft) {
  {
    SqliteJournal journal(path_);
    add(journal, "carried", 3, msg::PARTIAL);
    journal.unfinished();  // waits until the database has it
    add(journal, "in the log", 4, msg::CRASHED);
    // As after kill -9: what lies on the disk now, the log included.
    std::filesystem::copy(folder_.path(), folder_ / "copy");
  }
  JournalView view(folder_ / "copy/journal.db");
  EXPECT_EQ(told(view.latest(10, any)), (std::vector<std::string>{row("in the log", "CRASHED 4"), row("carried", "PARTIAL 3")}));
  EXPECT_EQ(view.steps(msg::id_of("in the log")).size(), 4U);
  ASSERT_TRUE(view.find(msg::id_of("carried")));
  EXPECT_EQ(view.find(msg::id_of("carried"))->request, good_request("carried"));
  EXPECT_FALSE(view.find(msg::id_of("unheard of")));
}

TEST_F(JournalViewTest, ChangesNothing) {
  { SqliteJournal journal(path_); }
  const auto octets = [&] {
    std::ifstream in(path_, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const std::string before = octets();
  const auto time = std::filesystem::last_write_time(path_);
  JournalView(path_).latest(10, any);
  EXPECT_EQ(octets(), before);
  EXPECT_EQ(std::filesystem::last_write_time(path_), time);
}

TEST_F(JournalViewTest, AFilterIsAskedBeforeTheNumberIsCounted) {
  SqliteJournal journal(path_);
  for (int i = 0; i < 20; ++i) add(journal, std::to_string(i), 0, i < 3 ? msg::FAILED : msg::SUCCEEDED);
  const auto failed = JournalView(path_).latest(2, [](const Record& r) { return r.final_event->state() == msg::FAILED; });
  EXPECT_EQ(told(failed), (std::vector<std::string>{row("2", "FAILED 0"), row("1", "FAILED 0")}));
}

TEST_F(JournalViewTest, WhatIsNoJournalIsRefused) {
  EXPECT_THROW(JournalView(folder_ / "none.db"), JournalError);
  std::ofstream(path_) << std::string(5000, 'x');
  EXPECT_THROW(JournalView{path_}, JournalError);
}

// Whatever a bundle's file holds, it is read or refused.
TEST(EntryView, SpoiltEntriesAreReadOrRefused) {
  const auto request = good_request("a");
  msg::PlanEvent end;
  end.request(request.id());
  end.state(msg::CRASHED);
  msg::Bytes whole;
  append_entry(whole, {Entry::Kind::kRequest, request.id(), 1, msg::encode(request)});
  append_entry(whole, {Entry::Kind::kStep, request.id(), 0, step_bytes(request.id(), 0, "s")});
  append_entry(whole, {Entry::Kind::kEnding, request.id(), 2, msg::encode(end)});
  std::mt19937_64 random(7);
  int refused = 0, read = 0;
  for (int round = 0; round < 20000; ++round) {
    msg::Bytes spoilt = whole;
    for (int i = 0; i < 1 + static_cast<int>(random() % 3); ++i)
      spoilt[random() % spoilt.size()] = static_cast<std::byte>(random());
    if (random() % 4 == 0U) spoilt.resize(random() % spoilt.size());
    EntryView view;
    try {
      const bool entire = visit_entries(spoilt, [&](const Entry& entry) { view.add(entry); });
      ++(entire ? read : refused);
    } catch (const JournalError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 1000);
  EXPECT_GT(read, 1000);
}

}  // namespace
}  // namespace foothold::server::testing
