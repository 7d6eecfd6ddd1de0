// Whatever comes in whatever order, crashes of workers and of the server included: each request ends in exactly one final state,
// the count of its steps is the journal's, and nothing is planned twice.
#include <gtest/gtest.h>

#include <random>

#include "fakes.hpp"

namespace foothold::server::testing {
namespace {

class Storm {
 public:
  Storm(std::uint64_t seed, bool storage_fails) : random_(seed), storage_fails_(storage_fails) {
    world_.options.limits.queued = 6;
    world_.others_serve = seed % 2 == 0;
    world_.restart();
    world_.journal.turns = 0;
  }

  void blow(int inputs) {
    for (int i = 0; i < inputs; ++i) {
      input();
      if (chance(0.4)) settle();
    }
    settle();
  }

  // Lets everything come to its end.
  void calm() {
    world_.journal.full = false;
    for (int i = 0; i < 400; ++i) {
      world_.clock.advance(0.5);
      world_.jobs->tick();
      for (const Run run : active()) end_run(run);
      settle();
    }
    EXPECT_TRUE(world_.jobs->idle());
  }

  void verify() {
    world_.restart();
    for (const Id& id : ids_) {
      const auto stored = world_.journal.durable.find(id);
      if (stored == world_.journal.durable.end()) {
        EXPECT_TRUE(!finals_.contains(id) || (storage_fails_ && restarts_ > 0)) << "told, but not stored";
        continue;
      }
      const auto& final_event = stored->second.record.final_event;
      ASSERT_TRUE(final_event) << "left unfinished";
      EXPECT_EQ(final_event->steps(), stored->second.steps.size());
      const auto& finals = finals_[id];
      if (!storage_fails_ || restarts_ == 0) {
        ASSERT_EQ(finals.size(), 1U) << "told " << finals.size() << " ends";
        EXPECT_EQ(finals.front(), *final_event);
      }
      EXPECT_LE(world_.planners.plans_of(id), 1U + restarts_);
      if (const auto closed = closed_.find(id); closed != closed_.end()) {
        EXPECT_EQ(world_.planners.plans_of(id), closed->second) << "planned again after a restart";
      }
      for (const std::uint32_t index : steps_[id]) EXPECT_LT(index, final_event->steps());
      if (restarts_ == 0 && !storage_fails_) {
        EXPECT_EQ(steps_[id].size(), final_event->steps());
      }
    }
  }

  std::size_t restarts() const { return restarts_; }
  std::set<msg::State> states() const {
    std::set<msg::State> all;
    for (const auto& [id, finals] : finals_)
      for (const auto& event : finals) all.insert(event.state());
    return all;
  }
  void allow_restarts() { may_restart_ = true; }

 private:
  bool chance(double p) { return std::uniform_real_distribution<>(0, 1)(random_) < p; }
  std::size_t pick(std::size_t n) { return std::uniform_int_distribution<std::size_t>(0, n - 1)(random_); }

  std::vector<Run> active() const {
    std::vector<Run> runs;
    for (const auto& [run, started] : world_.planners.runs)
      if (!started.ended) runs.push_back(run);
    return runs;
  }

  Id some_id() {
    if (ids_.empty() || chance(0.1)) ids_.push_back(msg::id_of("id " + std::to_string(ids_.size())));
    // Mostly of late ones, so that all states are met.
    return ids_[ids_.size() - 1 - pick(std::min<std::size_t>(ids_.size(), 12))];
  }

  void input() {
    switch (pick(10)) {
      case 0:
      case 1:
      case 2:
        return submit(chance(0.7) ? fresh() : some_id());
      case 3:
        return chance(0.3) ? move(some_id()) : cancel(some_id());
      case 4:
        return query(some_id());
      case 5:
        world_.clock.advance(std::uniform_real_distribution<>(0, 0.7)(random_));
        return world_.jobs->tick();
      case 6:
        if (may_restart_ && chance(0.1)) return restart();
        if (storage_fails_ && chance(0.2)) world_.journal.full = !world_.journal.full;
        return;
      default:
        return run_event();
    }
  }

  Id fresh() {
    ids_.push_back(msg::id_of("id " + std::to_string(ids_.size())));
    return ids_.back();
  }

  void submit(const Id& id) {
    auto request = good_request();
    request.id(id);
    request.budget(0.2 + static_cast<double>(pick(40)) / 10.0);
    request.priority(static_cast<std::int32_t>(pick(3)));
    request.resume(chance(0.5));
    request.shapes(chance(0.2));
    if (chance(0.2)) request.robot("climber");
    if (chance(0.1)) request.robot("nobody");
    if (chance(0.4)) request.server(world_.options.server);
    world_.jobs->request(request);
  }

  // Its client submits it to another server.
  void move(const Id& id) {
    auto request = good_request();
    request.id(id);
    request.server(msg::id_of("another server"));
    world_.jobs->request(request);
  }

  void cancel(const Id& id) {
    msg::CancelRequest message;
    message.id(id);
    message.client(chance(0.5) ? World::kClient : World::kOther);
    world_.jobs->cancel(message);
  }

  void query(const Id& id) {
    msg::StateQuery message;
    message.request(id);
    message.client(World::kOther);
    message.from_step(static_cast<std::uint32_t>(pick(4)));
    world_.jobs->query(message);
  }

  void run_event() {
    const auto runs = active();
    if (runs.empty()) return;
    const Run run = runs[pick(runs.size())];
    auto& started = world_.planners.runs.at(run);
    const Id id = started.request.id();
    if (started.killed || chance(0.15)) return end_run(run);
    if (chance(0.1)) return world_.jobs->on_run_scene(run, {msg::Shape()});
    const std::uint32_t index = emitted_[run]++;
    world_.jobs->on_run_step(run, index, step_bytes(id, index, "always the same"));
  }

  void end_run(Run run) {
    auto& started = world_.planners.runs.at(run);
    started.ended = true;
    RunEnd end;
    if (started.killed || chance(0.2)) {
      end.kind = RunEnd::Kind::kLost;
      end.error = msg::make_error(started.killed ? msg::WORKER_KILLED : msg::WORKER_CRASHED, "gone");
    } else {
      constexpr msg::State kReports[] = {msg::SUCCEEDED, msg::PARTIAL, msg::FAILED};
      end.state = started.stopped ? msg::CANCELLED : kReports[pick(3)];
      if (end.state != msg::SUCCEEDED) end.error = msg::make_error(msg::NO_PATH, "none");
    }
    const std::string robot = started.request.robot();
    world_.jobs->on_run_end(run, end);
    ++world_.planners.robots.at(robot).idle;
    world_.jobs->on_slots_changed(robot);
  }

  void restart() {
    ++restarts_;
    world_.journal.full = false;
    for (const auto& [id, entry] : world_.journal.durable)
      if (!entry.record.request.resume() || entry.record.final_event) closed_.emplace(id, world_.planners.plans_of(id));
    read_outbox();
    world_.restart();
    read_outbox();
  }

  void settle() {
    world_.jobs->settle();
    read_outbox();
  }

  void read_outbox() {
    for (const auto& message : world_.outbox.messages) {
      if (message.event) {
        const auto& event = *message.event;
        auto& finals = finals_[event.request()];
        if (!event.answer() && msg::is_final(event.state())) finals.push_back(event);
        if (finals.empty()) {
          finals_.erase(event.request());
          continue;
        }
        if (event.answer() && !storage_fails_) {
          auto same = event;
          same.answer(false);
          same.scene().clear();
          EXPECT_EQ(same, finals.front()) << "an answer after the end is the end";
        }
        if (!event.answer() && !storage_fails_) {
          EXPECT_TRUE(msg::is_final(event.state())) << "a change of state after the end";
        }
      } else if (const auto step = msg::decode<msg::Step>(message.step)) {
        if (message.client == World::kClient && !finals_.contains(step->request())) steps_[step->request()].insert(step->index());
      }
    }
    world_.forget_messages();
  }

  World world_;
  std::mt19937_64 random_;
  bool storage_fails_;
  bool may_restart_ = false;
  std::size_t restarts_ = 0;
  std::vector<Id> ids_;
  std::map<Id, std::size_t> closed_;  // how often these were planned when a restart found them; never again
  std::map<Run, std::uint32_t> emitted_;
  std::map<Id, std::vector<msg::PlanEvent>> finals_;
  std::map<Id, std::set<std::uint32_t>> steps_;  // told before the end
};

TEST(RandomInterleavings, EveryRequestEndsExactlyOnce) {
  std::set<msg::State> met;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Storm storm(seed, false);
    storm.blow(400);
    storm.calm();
    storm.verify();
    met.merge(storm.states());
    ASSERT_FALSE(::testing::Test::HasFailure());
  }
  EXPECT_EQ(met.size(), 7U) << "every final state was met";
}

TEST(RandomInterleavings, AlsoAcrossRestartsOfTheServer) {
  std::size_t restarts = 0;
  for (std::uint64_t seed = 100; seed < 160; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Storm storm(seed, false);
    storm.allow_restarts();
    storm.blow(600);
    storm.calm();
    storm.verify();
    restarts += storm.restarts();
    ASSERT_FALSE(::testing::Test::HasFailure());
  }
  EXPECT_GT(restarts, 100U);
}

TEST(RandomInterleavings, AlsoWhenTheDiskIsFullAtTimes) {
  for (std::uint64_t seed = 200; seed < 260; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Storm storm(seed, true);
    storm.blow(400);
    storm.calm();
    storm.verify();
    ASSERT_FALSE(::testing::Test::HasFailure());
  }
}

TEST(RandomInterleavings, AlsoWithBoth) {
  for (std::uint64_t seed = 300; seed < 360; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Storm storm(seed, true);
    storm.allow_restarts();
    storm.blow(600);
    storm.calm();
    storm.verify();
    ASSERT_FALSE(::testing::Test::HasFailure());
  }
}

}  // namespace
}  // namespace foothold::server::testing
