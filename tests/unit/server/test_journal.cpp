// The journal on disk: what was committed is there again, whatever happened to the process, and nothing else is.
#include <gtest/gtest.h>
#include <sqlite3.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <thread>

#include "fakes.hpp"
#include "journal/journal.hpp"
#include "temporary_folder.hpp"

namespace foothold::server::testing {
namespace {

using test::TemporaryFolder;

msg::PlanEvent final_event(const msg::PlanRequest& request, std::uint32_t steps, Stamp stamp = 77) {
  return change_event({msg::id_of("server"), "1"}, request, msg::SUCCEEDED, stamp, steps, {});
}

std::string failure(const std::string& path) {
  try {
    SqliteJournal journal(path);
  } catch (const JournalError& error) {
    return error.what();
  }
  return "";
}

TEST(Journal, GivesBackWhatWasWrittenAlsoWhenReopened) {
  const TemporaryFolder folder;
  auto request = good_request();
  request.unit("number 3");
  msg::Shape shape;
  shape.body("floor");
  Id server{};
  {
    SqliteJournal journal(folder / "journal.db");
    server = journal.server_id();
    EXPECT_FALSE(journal.knows(request.id()));
    journal.add_request(request, 1234);
    EXPECT_TRUE(journal.knows(request.id())) << "before the commit too";
    for (std::uint32_t i = 0; i < 300; ++i) journal.add_step(request.id(), i, step_bytes(request.id(), i, "s"));
    journal.set_scene(request.id(), {shape});
    journal.set_final(request.id(), final_event(request, 300));
    journal.commit();
  }
  SqliteJournal journal(folder / "journal.db");
  EXPECT_EQ(journal.server_id(), server);
  const auto record = journal.find(request.id());
  ASSERT_TRUE(record);
  EXPECT_EQ(record->request, request);
  EXPECT_EQ(record->received, 1234);
  EXPECT_EQ(record->steps, 300U);
  EXPECT_EQ(*record->final_event, final_event(request, 300));
  EXPECT_EQ(record->scene, std::vector<msg::Shape>{shape});
  const auto steps = journal.steps(request.id(), 298);
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_EQ(steps[1], step_bytes(request.id(), 299, "s"));
  EXPECT_TRUE(journal.steps(request.id(), 300).empty());
  EXPECT_TRUE(journal.unfinished().empty());
  EXPECT_FALSE(journal.find(msg::id_of("another")));
}

TEST(Journal, KnowsWhatIsUnfinishedInTheOrderOfReceipt) {
  const TemporaryFolder folder;
  {
    SqliteJournal journal(folder / "journal.db");
    for (int i = 0; i < 20; ++i) journal.add_request(good_request(std::to_string(i)), i);
    for (int i = 0; i < 20; i += 2) journal.set_final(good_request(std::to_string(i)).id(), final_event(good_request(), 0));
    journal.add_step(msg::id_of("7"), 0, step_bytes(msg::id_of("7"), 0, "s"));
    journal.commit();
  }
  SqliteJournal journal(folder / "journal.db");
  const auto records = journal.unfinished();
  ASSERT_EQ(records.size(), 10U);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(records[static_cast<std::size_t>(i)].received, 2 * i + 1);
  EXPECT_EQ(records[3].steps, 1U);
}

TEST(Journal, WhatWasNotCommittedIsNotThere) {
  const TemporaryFolder folder;
  const auto request = good_request();
  {
    SqliteJournal journal(folder / "journal.db");
    journal.add_request(request, 1);
  }
  EXPECT_FALSE(SqliteJournal(folder / "journal.db").knows(request.id()));
}

TEST(Journal, ReadsWhatIsStillOnItsWayIntoTheDatabase) {
  const TemporaryFolder folder;
  SqliteJournal journal(folder / "journal.db");
  for (int i = 0; i < 300; ++i) {  // some of it carried, some not, at every moment
    const auto request = good_request(std::to_string(i));
    journal.add_request(request, i);
    journal.commit();
    for (std::uint32_t k = 0; k < 5; ++k) {
      journal.add_step(request.id(), k, step_bytes(request.id(), k, "s"));
      if (k % 2 == 0) journal.commit();
      ASSERT_EQ(journal.find(request.id())->steps, k + 1);
      ASSERT_EQ(journal.steps(request.id(), 0).size(), k + 1);
      ASSERT_EQ(journal.steps(request.id(), k).back(), step_bytes(request.id(), k, "s"));
    }
    journal.set_final(request.id(), final_event(request, 5));
    ASSERT_EQ(*journal.find(request.id())->final_event, final_event(request, 5));
    ASSERT_TRUE(journal.knows(msg::id_of(std::to_string(i / 2))));
    ASSERT_FALSE(journal.knows(msg::id_of(std::to_string(i + 1))));
    std::this_thread::sleep_for(std::chrono::microseconds(300));
  }
}

std::vector<std::filesystem::path> log_files(const TemporaryFolder& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    if (entry.path().filename().string().find("-log.") != std::string::npos) files.push_back(entry.path());
  return files;
}

TEST(Journal, ALogThatIsReplayedTwiceChangesNothing) {
  const TemporaryFolder folder;
  const auto request = good_request();
  {
    SqliteJournal journal(folder / "journal.db");
    journal.add_request(request, 1);
    journal.add_step(request.id(), 0, step_bytes(request.id(), 0, "s"));
    journal.set_final(request.id(), final_event(request, 1));
    journal.commit();
  }
  ASSERT_EQ(log_files(folder).size(), 1U);
  ASSERT_GT(std::filesystem::file_size(log_files(folder).front()), 0U) << "the database holds it all; the log still does";
  for (int round = 0; round < 2; ++round) {
    SqliteJournal journal(folder / "journal.db");
    EXPECT_EQ(journal.steps(request.id(), 0).size(), 1U);
    EXPECT_EQ(*journal.find(request.id())->final_event, final_event(request, 1));
    EXPECT_TRUE(journal.unfinished().empty());
  }
}

TEST(Journal, ABatchThatWasCutShortIsLeftOutAsAWhole) {
  const TemporaryFolder folder;
  const std::string path = folder / "journal.db";
  Log log(path + "-log");
  log.restart();
  for (const char* name : {"whole", "cut"}) {
    msg::Bytes batch;
    append_entry(batch, {Entry::Kind::kRequest, msg::id_of(name), 1, msg::encode(good_request(name))});
    append_entry(batch, {Entry::Kind::kStep, msg::id_of(name), 0, step_bytes(msg::id_of(name), 0, "s")});
    log.append(batch);
  }
  const auto file = log_files(folder).front();
  std::filesystem::resize_file(file, std::filesystem::file_size(file) - 1);
  SqliteJournal journal(path);
  EXPECT_EQ(journal.steps(msg::id_of("whole"), 0).size(), 1U);
  EXPECT_FALSE(journal.knows(msg::id_of("cut")));
}

TEST(Journal, WhatALossOfPowerLeftAtTheEndOfTheLogIsLeftOut) {
  const TemporaryFolder folder;
  const std::string path = folder / "journal.db";
  Log log(path + "-log");
  log.restart();
  msg::Bytes batch;
  append_entry(batch, {Entry::Kind::kRequest, msg::id_of("a"), 1, msg::encode(good_request("a"))});
  log.append(batch);
  std::ofstream(log_files(folder).front(), std::ios::app | std::ios::binary) << std::string(5000, '\x17');
  SqliteJournal journal(path);
  EXPECT_TRUE(journal.knows(msg::id_of("a")));
  EXPECT_EQ(journal.unfinished().size(), 1U);
}

TEST(Journal, OldSegmentsOfTheLogAreRemoved) {
  const TemporaryFolder folder;
  SqliteJournal journal(folder / "journal.db");
  const auto request = good_request();
  journal.add_request(request, 1);
  constexpr std::uint32_t kSteps = 400;
  for (std::uint32_t k = 0; k < kSteps; ++k) {  // 40 MB
    journal.add_step(request.id(), k, Bytes(100'000));
    journal.commit();
  }
  EXPECT_EQ(journal.unfinished().size(), 1U);  // waits until the database holds all
  for (int i = 0; i < 100 && log_files(folder).size() > 1; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  EXPECT_EQ(log_files(folder).size(), 1U);
  EXPECT_EQ(journal.find(request.id())->steps, kSteps);
}

TEST(Journal, ForgetsWhatEndedLongAgoWithItsSteps) {
  const TemporaryFolder folder;
  SqliteJournal journal(folder / "journal.db");
  for (int i = 0; i < 200; ++i) {
    const auto request = good_request(std::to_string(i));
    journal.add_request(request, i);
    for (std::uint32_t k = 0; k < 3; ++k) journal.add_step(request.id(), k, step_bytes(request.id(), k, "s"));
    if (i != 5) journal.set_final(request.id(), final_event(request, 3, i));
  }
  journal.commit();
  EXPECT_EQ(journal.unfinished().size(), 1U);
  journal.forget_before(150);
  for (int i = 0; i < 100 && journal.find(msg::id_of("149")); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(50));
  for (int i = 0; i < 200; ++i) {
    EXPECT_EQ(journal.find(msg::id_of(std::to_string(i))).has_value(), i == 5 || i >= 150) << i;
    EXPECT_EQ(journal.steps(msg::id_of(std::to_string(i)), 0).size(), i == 5 || i >= 150 ? 3U : 0U) << i;
  }
}

TEST(Journal, AForeignFileIsRefusedAndLeftAsItIs) {
  const TemporaryFolder folder;
  const std::string text = "This is not a database, but somebody's notes, and they are longer than a header of SQLite would be.";
  std::ofstream(folder / "notes.txt") << text;
  EXPECT_NE(failure(folder / "notes.txt").find("is not a journal of foothold"), std::string::npos) << failure(folder / "notes.txt");
  std::ifstream again(folder / "notes.txt");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(again), {}), text);
}

TEST(Journal, AnotherProgramsDatabaseIsRefused) {
  const TemporaryFolder folder;
  sqlite::Database(folder / "other.db").run("CREATE TABLE bookmarks (url TEXT)");
  EXPECT_NE(failure(folder / "other.db").find("not a journal of foothold"), std::string::npos);
}

TEST(Journal, AnotherSchemaVersionIsRefusedWithBothNumbers) {
  const TemporaryFolder folder;
  SqliteJournal(folder / "journal.db").commit();
  sqlite::Database(folder / "journal.db").run("PRAGMA user_version = 99");
  EXPECT_NE(failure(folder / "journal.db").find("schema version 99, this server reads version 2"), std::string::npos);
}

TEST(Journal, ADamagedFileIsRefused) {
  const TemporaryFolder folder;
  {
    SqliteJournal journal(folder / "journal.db");
    for (int i = 0; i < 500; ++i) journal.add_request(good_request(std::to_string(i)), i);
    journal.commit();
  }
  std::fstream file(folder / "journal.db", std::ios::in | std::ios::out | std::ios::binary);
  for (int page = 1; page < 20; ++page) {
    file.seekp(4096 * page);
    file << std::string(2000, '\x5a');
  }
  file.close();
  EXPECT_NE(failure(folder / "journal.db").find("is damaged"), std::string::npos) << failure(folder / "journal.db");
}

TEST(Journal, AFolderThatIsNotThereIsNamed) {
  EXPECT_NE(failure("/nonexistent/journal.db").find("/nonexistent/journal.db: cannot be opened"), std::string::npos);
}

// The limit on a file's size stands in for a full disk: writes fail at a moment that SQLite does not choose.
TEST(Journal, AFullDiskFailsTheCommitAndSpaceHealsIt) {
  const TemporaryFolder folder;
  SqliteJournal journal(folder / "journal.db");
  journal.add_request(good_request("before"), 1);
  journal.commit();
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit{};
  getrlimit(RLIMIT_FSIZE, &limit);
  const rlimit old = limit;
  limit.rlim_cur = 256 * 1024;
  setrlimit(RLIMIT_FSIZE, &limit);
  int stored = 0;
  bool failed = false;
  for (; stored < 1000 && !failed; ++stored) {
    try {
      const auto request = good_request(std::to_string(stored));
      journal.add_request(request, 2);
      journal.add_step(request.id(), 0, Bytes(20000));
      journal.commit();
    } catch (const JournalError&) {
      failed = true;
      --stored;
    }
  }
  setrlimit(RLIMIT_FSIZE, &old);
  EXPECT_TRUE(failed);
  EXPECT_GT(stored, 0);
  for (int i = 0; i < stored; ++i) EXPECT_EQ(journal.steps(msg::id_of(std::to_string(i)), 0).size(), 1U);
  EXPECT_FALSE(journal.knows(msg::id_of(std::to_string(stored))));
  journal.add_request(good_request("afterwards"), 3);
  journal.commit();
  EXPECT_TRUE(journal.knows(msg::id_of("afterwards")));
}

// Writes requests of growing number, each with three steps and an end, and says through the pipe what is committed.
[[noreturn]] void write_for_ever(const std::string& path, int pipe_end) {
  SqliteJournal journal(path);
  for (std::uint32_t i = 0;; ++i) {
    const auto request = good_request(std::to_string(i));
    journal.add_request(request, i);
    for (std::uint32_t k = 0; k < 3; ++k) journal.add_step(request.id(), k, step_bytes(request.id(), k, std::string(500, 'x')));
    if (i % 3 != 0) journal.set_final(request.id(), final_event(request, 3));
    journal.commit();
    if (write(pipe_end, &i, sizeof i) != sizeof i) _exit(1);
  }
}

TEST(Journal, SurvivesAKillInMidWriteWithAllThatWasCommitted) {
  const TemporaryFolder folder;
  for (int round = 0; round < 8; ++round) {
    const std::string path = folder / ("journal" + std::to_string(round) + ".db");
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    const pid_t child = fork();
    if (child == 0) write_for_ever(path, ends[1]);
    close(ends[1]);
    std::uint32_t seen = 0;
    while (seen <= 10) ASSERT_EQ(read(ends[0], &seen, sizeof seen), static_cast<ssize_t>(sizeof seen));
    std::this_thread::sleep_for(std::chrono::milliseconds(20 + 37 * round));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    std::uint32_t committed = seen;
    while (read(ends[0], &seen, sizeof seen) == static_cast<ssize_t>(sizeof seen)) committed = seen;
    close(ends[0]);
    ASSERT_GT(committed, 10U);

    SqliteJournal journal(path);
    std::size_t unfinished = 0;
    for (std::uint32_t i = 0; i <= committed; ++i) {
      const auto record = journal.find(msg::id_of(std::to_string(i)));
      ASSERT_TRUE(record) << i;
      ASSERT_EQ(record->steps, 3U);
      ASSERT_EQ(record->final_event.has_value(), i % 3 != 0);
      if (!record->final_event) ++unfinished;
    }
    EXPECT_GE(journal.unfinished().size(), unfinished);
    EXPECT_LE(journal.unfinished().size(), unfinished + 1);
  }
}

}  // namespace
}  // namespace foothold::server::testing
