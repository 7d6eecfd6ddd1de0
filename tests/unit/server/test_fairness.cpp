// Who waits how long: P7's bounds, P32 and P33, one by one and as properties of random loads.
#include <gtest/gtest.h>

#include <random>

#include "fakes.hpp"

namespace foothold::server::testing {
namespace {

msg::PlanRequest request_of(const std::string& client, const std::string& name, const std::string& robot = "climber") {
  auto request = good_request(name);
  request.parameters().clear();
  request.client(msg::id_of(client));
  request.robot(robot);
  request.budget(3000.0);
  return request;
}

// Clients send, plans last as long as they are told, time goes on.
class Load {
 public:
  explicit Load(std::size_t slots, AdmissionLimits limits = {}) {
    world.planners.robots.clear();
    world.planners.add("climber", slots);
    world.options.limits = limits;
    world.restart();
  }

  // Gives the state right after; its plan lasts `seconds` when it starts.
  msg::PlanEvent submit(const std::string& client, double seconds, std::int32_t priority = 0) {
    auto request = request_of(client, "request " + std::to_string(++sent_));
    request.priority(priority);
    durations_[request.id()] = seconds;
    names_[request.id()] = client;
    priorities_[request.id()] = priority;
    world.submit(request);
    note_starts();
    const auto event = world.last(request.id(), request.client());
    world.forget_messages();
    if (event.state() == msg::QUEUED) waiting_[{priority, client}].push_back(request.id());
    return event;
  }

  // Lets time pass; plans that are done end one by one, in order.
  void pass(double seconds) {
    const double end = now_ + seconds;
    while (!running_.empty() && running_.begin()->first <= end) {
      const auto [at, id] = *running_.begin();
      running_.erase(running_.begin());
      world.clock.advance(at - now_);
      now_ = at;
      --holds_[names_.at(id)];
      world.end(id, msg::SUCCEEDED);
      world.forget_messages();
      note_starts();
    }
    world.clock.advance(end - now_);
    now_ = end;
  }

  std::size_t waiting(const std::string& client) const {
    const auto found = waiting_.find({0, client});
    return found == waiting_.end() ? 0 : found->second.size();
  }
  std::size_t holds(const std::string& client) { return holds_[client]; }
  bool busy() const { return !running_.empty(); }

  struct Start {
    std::string client;
    std::int32_t priority;
    std::set<std::string> waiting;               // of this priority, before it
    std::map<std::string, std::size_t> holding;  // before it
    bool higher_waits;
    bool waited;
  };
  std::vector<Start> starts;
  World world;

 private:
  void note_starts() {
    for (auto run = world.planners.runs.upper_bound(last_run_); run != world.planners.runs.end(); ++run) {
      last_run_ = run->first;
      const Id id = run->second.request.id();
      Start start{names_.at(id), priorities_.at(id), {}, holds_, false, false};
      for (auto& [key, line] : waiting_) {
        if (line.empty()) continue;
        if (key.first == start.priority) start.waiting.insert(key.second);
        start.higher_waits = start.higher_waits || key.first > start.priority;
      }
      auto& line = waiting_[{start.priority, start.client}];
      start.waited = !line.empty() && line.front() == id;
      if (start.waited) line.erase(line.begin());
      starts.push_back(start);
      ++holds_[start.client];
      running_.emplace(now_ + durations_.at(id), id);
    }
  }

  double now_ = 0.0;
  std::size_t sent_ = 0;
  Run last_run_ = 0;
  std::multimap<double, Id> running_;
  std::map<Id, double> durations_;
  std::map<Id, std::string> names_;
  std::map<Id, std::int32_t> priorities_;
  std::map<std::pair<std::int32_t, std::string>, std::vector<Id>> waiting_;
  std::map<std::string, std::size_t> holds_;
};

TEST(P32, AClientWithOneRequestDoesNotWaitForAHundredOfAnother) {
  Load load(1);
  for (int i = 0; i < 100; ++i) load.submit("greedy", 1.0);
  load.submit("modest", 1.0);
  load.pass(2.5);
  ASSERT_EQ(load.starts.size(), 3U);
  EXPECT_EQ(load.starts[1].client, "greedy") << "it has waited longer";
  EXPECT_EQ(load.starts[2].client, "modest");
}

TEST(P32, OneWorkerWhileAClientWaitsNoOtherStartsTwice) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    Load load(1);
    const auto clients = 2 + random() % 6;
    for (int i = 0; i < 400; ++i) {
      const std::string client = "client " + std::to_string(random() % clients);
      for (auto burst = random() % 10 == 0 ? random() % 20 : 1; burst > 0; --burst)
        load.submit(client, 0.1 + static_cast<double>(random() % 30) / 10.0, static_cast<std::int32_t>(random() % 2));
      load.pass(static_cast<double>(random() % 40) / 10.0);
    }
    while (load.busy()) load.pass(10.0);
    // Starts of others, of each priority apart, since this client's last start or since it began to wait.
    std::map<std::pair<std::int32_t, std::string>, std::map<std::string, int>> passed;
    for (const auto& start : load.starts) {
      if (!start.waited) continue;
      EXPECT_FALSE(start.higher_waits);
      for (auto& [key, others] : passed)
        if (key.first == start.priority && !start.waiting.contains(key.second)) others.clear();
      for (const auto& other : start.waiting) {
        if (other == start.client) continue;
        const int starts = ++passed[std::pair(start.priority, other)][start.client];
        EXPECT_LE(starts, 1) << other << " waits";
      }
      passed[{start.priority, start.client}].clear();
    }
    ASSERT_FALSE(::testing::Test::HasFailure());
  }
}

TEST(P32, TheNextIsAlwaysOfAClientThatHoldsTheFewestWorkers) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937_64 random(seed);
    Load load(1 + random() % 6);
    for (int i = 0; i < 400; ++i) {
      load.submit("client " + std::to_string(random() % 5), static_cast<double>(1 + random() % 100) / 10.0);
      load.pass(static_cast<double>(random() % 10) / 10.0);
    }
    while (load.busy()) load.pass(10.0);
    std::size_t waited = 0;
    for (auto& start : load.starts) {
      if (!start.waited) continue;
      ++waited;
      for (const auto& other : start.waiting) EXPECT_LE(start.holding[start.client], start.holding[other]);
    }
    EXPECT_GT(waited, 50U);
    ASSERT_FALSE(::testing::Test::HasFailure());
  }
}

// However long a client's plans last and however many it sends: who always has something waiting has its share of the workers.
TEST(P32, WhoWaitsHasItsShareOfTheWorkers) {
  for (const auto& [slots, clients] : {std::pair<std::size_t, std::size_t>{4, 4}, {6, 3}, {5, 2}, {7, 3}}) {
    SCOPED_TRACE(std::to_string(slots) + " workers, " + std::to_string(clients) + " clients");
    std::mt19937_64 random(slots * 10 + clients);
    Load load(slots);
    const auto name = [](std::size_t i) { return "client " + std::to_string(i); };
    double longest = 0.0;
    const auto feed = [&](std::size_t i) {
      // The first one's plans last twenty times as long, and it sends many at once.
      const double seconds = (i == 0 ? 20.0 : 1.0) * (1.0 + static_cast<double>(random() % 10) / 10.0);
      longest = std::max(longest, seconds);
      for (std::size_t n = i == 0 ? 20 : slots; n > 0; --n) load.submit(name(i), seconds);
    };
    for (int tick = 0; tick < 2000; ++tick) {
      for (std::size_t i = 0; i < clients; ++i)
        while (load.waiting(name(i)) < slots) feed(i);
      for (std::size_t i = 0; i < clients && tick * 0.1 > 2.0 * longest; ++i)
        ASSERT_GE(load.holds(name(i)), slots / clients) << name(i) << " at " << tick;
      // Shorter than any plan: whatever ends meanwhile, a line that was filled does not run empty.
      load.pass(0.1);
    }
  }
}

TEST(P33, OneClientCannotFillTheQueue) {
  Load load(1, {.queued = 10, .queued_per_client = 3});
  for (int i = 0; i < 4; ++i) EXPECT_NE(load.submit("greedy", 1.0).state(), msg::REJECTED);
  const auto refused = load.submit("greedy", 1.0);
  EXPECT_EQ(refused.state(), msg::REJECTED);
  EXPECT_EQ(refused.error().code(), msg::QUEUE_FULL);
  EXPECT_NE(refused.error().message().find("3 requests of this client"), std::string::npos) << refused.error().message();
  EXPECT_TRUE(refused.error().retryable());
  EXPECT_EQ(load.submit("modest", 1.0).state(), msg::QUEUED);
}

TEST(P33, WhoWaitsAsLongAsHeIsToldFindsAPlace) {
  for (const std::size_t others : {0U, 1U, 4U}) {
    SCOPED_TRACE(std::to_string(others) + " other clients");
    Load load(2, {.queued = 1000, .queued_per_client = 5});
    for (int i = 0; i < 9; ++i)
      for (std::size_t other = 0; other <= others; ++other) load.submit("client " + std::to_string(other), 1.0);
    const auto refused = load.submit("client 0", 1.0);
    ASSERT_EQ(refused.state(), msg::REJECTED);
    load.pass(refused.error().retry_after());
    EXPECT_EQ(load.submit("client 0", 1.0).state(), msg::QUEUED) << "after " << refused.error().retry_after() << " s";
  }
}

TEST(P33, AClientAtItsLimitOfPlansWaitsAndHoldsUpNobody) {
  Load load(3, {.running_per_client = 1});
  EXPECT_EQ(load.submit("a", 5.0).state(), msg::RUNNING);
  EXPECT_EQ(load.submit("a", 5.0).state(), msg::QUEUED) << "two workers are idle, but not for it";
  EXPECT_EQ(load.submit("b", 1.0).state(), msg::RUNNING);
  EXPECT_EQ(load.holds("a"), 1U);
  load.pass(5.5);
  EXPECT_EQ(load.holds("a"), 1U);
  EXPECT_EQ(load.waiting("a"), 0U);
}

TEST(P33, TheLimitOfPlansIsOfAllRobotsTogether) {
  World world;
  world.options.limits.running_per_client = 1;
  world.restart();
  world.submit(request_of("a", "first", "climber"));
  world.submit(request_of("a", "second", "walker"));
  const Id second = msg::id_of("second");
  EXPECT_EQ(world.last(second, msg::id_of("a")).state(), msg::QUEUED);
  world.end(msg::id_of("first"), msg::SUCCEEDED);
  EXPECT_EQ(world.last(second, msg::id_of("a")).state(), msg::RUNNING) << "another robot's worker ended its client's plan";
  world.cancel(second, msg::id_of("a"));
  world.submit(request_of("a", "third", "climber"));
  EXPECT_EQ(world.last(msg::id_of("third"), msg::id_of("a")).state(), msg::QUEUED) << "the second is being stopped";
  world.end(second, msg::CANCELLED);
  EXPECT_EQ(world.last(msg::id_of("third"), msg::id_of("a")).state(), msg::RUNNING);
}

TEST(P33, LimitsCanBeChangedWhileTheServerRuns) {
  World world;
  world.options.limits = {.queued_per_client = 1, .running_per_client = 1};
  world.restart();
  for (const char* name : {"1", "2"}) world.submit(request_of("a", name, "walker"));
  world.submit(request_of("a", "3", "walker"));
  EXPECT_EQ(world.last(msg::id_of("3"), msg::id_of("a")).state(), msg::REJECTED);
  world.jobs->set_limits({.queued_per_client = 5, .running_per_client = 0});
  world.jobs->settle();
  EXPECT_EQ(world.last(msg::id_of("2"), msg::id_of("a")).state(), msg::RUNNING);
  world.submit(request_of("a", "4", "walker"));
  EXPECT_EQ(world.last(msg::id_of("4"), msg::id_of("a")).state(), msg::QUEUED);
}

}  // namespace
}  // namespace foothold::server::testing
