// A world for the state machine that is all the test's own: clock, journal, planners, scenes and outbox.
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "foothold/msg/errors.hpp"
#include "jobs/jobs.hpp"

namespace foothold::server::testing {

struct FakeClock final : Clock {
  Time at{std::chrono::hours(1)};
  Stamp wall = 1'700'000'000'000'000'000;
  Time now() const override { return at; }
  Stamp stamp() const override { return wall; }
  void advance(double seconds) {
    const auto by = std::chrono::nanoseconds(static_cast<std::int64_t>(seconds * 1e9));
    at += by;
    wall += by.count();
  }
};

// Keeps what was committed apart from what was written, so that a crash or a full disk takes away exactly the rest.
struct FakeJournal final : Journal {
  struct Entry {
    Record record;
    std::vector<Bytes> steps;
    std::uint64_t turn = 0;
  };
  using Entries = std::map<Id, Entry>;
  Entries durable, current;
  bool full = false;        // commit() fails
  bool unreadable = false;  // every read fails
  int commits = 0;
  std::uint64_t turns = 0;

  void add_request(const msg::PlanRequest& request, Stamp received) override {
    if (current.contains(request.id())) throw JournalError("the same id twice");
    Entry& entry = current[request.id()];
    entry.record.request = request;
    entry.record.received = received;
    entry.turn = turns++;
  }
  void add_step(const Id& id, std::uint32_t index, const Bytes& step) override {
    Entry& entry = current.at(id);
    if (index != entry.steps.size()) throw JournalError("a gap in the steps");
    if (entry.record.final_event) throw JournalError("a step after the end");
    entry.steps.push_back(step);
    entry.record.steps = static_cast<std::uint32_t>(entry.steps.size());
  }
  void set_scene(const Id& id, const std::vector<msg::Shape>& shapes) override { current.at(id).record.scene = shapes; }
  void set_final(const Id& id, const msg::PlanEvent& event) override {
    Entry& entry = current.at(id);
    if (entry.record.final_event) throw JournalError("a second end");
    entry.record.final_event = event;
  }
  void commit() override {
    ++commits;
    if (full) {
      current = durable;
      throw JournalError("the disk is full");
    }
    durable = current;
  }
  bool knows(const Id& id) override { return read().contains(id); }
  std::optional<Record> find(const Id& id) override {
    const auto found = read().find(id);
    return found == current.end() ? std::nullopt : std::optional(found->second.record);
  }
  std::vector<Bytes> steps(const Id& id, std::uint32_t from, std::uint32_t most) override {
    const auto found = read().find(id);
    if (found == current.end() || from > found->second.steps.size()) return {};
    const auto& steps = found->second.steps;
    const auto count = std::min<std::size_t>(most, steps.size() - from);
    return {steps.begin() + from, steps.begin() + from + static_cast<std::ptrdiff_t>(count)};
  }
  std::vector<Record> unfinished() override {
    std::map<std::uint64_t, Record> ordered;
    for (const auto& [id, entry] : read())
      if (!entry.record.final_event) ordered.emplace(entry.turn, entry.record);
    std::vector<Record> records;
    for (auto& [turn, record] : ordered) records.push_back(std::move(record));
    return records;
  }
  bool forget_before(Stamp stamp) override {
    std::erase_if(current,
                  [&](const auto& e) { return e.second.record.final_event && e.second.record.final_event->stamp() < stamp; });
    return false;
  }
  // What a kill -9 leaves.
  void crash() { current = durable; }

 private:
  const Entries& read() const {
    if (unreadable) throw JournalError("the disk cannot be read");
    return current;
  }
};

struct FakePlanners final : Planners {
  struct Robot {
    msg::RobotInfo info;
    double retry_after = 0.0;
    std::size_t idle = 1;
  };
  struct Started {
    msg::PlanRequest request;
    double budget_left = 0;
    std::optional<StoredScene> scene;
    bool stopped = false, killed = false, ended = false;
  };
  std::map<std::string, Robot> robots;
  std::map<Run, Started> runs;
  Run next = 1;

  Robot& add(const std::string& name, std::size_t slots) {
    Robot& robot = robots[name];
    robot.info.name(name);
    robot.info.state(msg::READY);
    robot.info.plugin("plugin of " + name);
    robot.info.plugin_version("1.2.3");
    robot.info.slots(static_cast<std::uint32_t>(slots));
    robot.idle = slots;
    return robot;
  }
  RobotStatus status(const std::string& name) const override {
    const auto found = robots.find(name);
    if (found == robots.end()) return {};
    return {std::make_shared<const msg::RobotInfo>(found->second.info), found->second.retry_after};
  }
  bool has_idle(const std::string& name) const override {
    const auto found = robots.find(name);
    return found != robots.end() && found->second.idle > 0;
  }
  Run start(const msg::PlanRequest& request, double budget_left, const std::optional<StoredScene>& scene) override {
    Robot& robot = robots.at(request.robot());
    if (robot.idle == 0) throw std::logic_error("no idle worker");
    --robot.idle;
    runs[next] = {request, budget_left, scene};
    return next++;
  }
  void stop(Run run) override { runs.at(run).stopped = true; }
  void kill(Run run, const std::string&) override { runs.at(run).killed = true; }
  // The latest run of this request.
  Run run_of(const Id& id) const {
    for (auto entry = runs.rbegin(); entry != runs.rend(); ++entry)
      if (entry->second.request.id() == id) return entry->first;
    return 0;
  }
  std::size_t plans_of(const Id& id) const {
    return static_cast<std::size_t>(std::ranges::count_if(runs, [&](const auto& r) { return r.second.request.id() == id; }));
  }
};

struct FakeShelf final : SceneShelf {
  std::vector<StoredScene> scenes;  // in the order of their storing
  bool knows(const std::string& name) const override {
    return std::ranges::any_of(scenes, [&](const auto& s) { return s.name == name; });
  }
  std::optional<StoredScene> find(const std::string& name, const std::string& revision) const override {
    for (auto scene = scenes.rbegin(); scene != scenes.rend(); ++scene)
      if (scene->name == name && (revision.empty() || scene->revision == revision)) return *scene;
    return std::nullopt;
  }
};

// Remembers what was told to whom, and that it was told after the commit.
struct FakeOutbox final : Outbox {
  struct Message {
    Id client;
    std::optional<msg::PlanEvent> event;
    Bytes step;
  };
  std::vector<Message> messages;
  std::set<Id> opened;
  std::map<Id, std::set<Id>> waiting;  // by client: requests of which steps wait for its reader
  void open(const Id& client) override { opened.insert(client); }
  void event(const Id& client, const msg::PlanEvent& event) override { messages.push_back({client, event, {}}); }
  void step(const Id& client, const Bytes& step) override { messages.push_back({client, std::nullopt, step}); }
  bool waits(const Id& client) const override { return waiting.contains(client); }
  bool waits(const Id& client, const Id& request) const override {
    const auto found = waiting.find(client);
    return found != waiting.end() && found->second.contains(request);
  }
};

// All of it together, and short ways to say what happens.
struct World {
  FakeClock clock;
  FakeJournal journal;
  FakePlanners planners;
  FakeShelf shelf;
  FakeOutbox outbox;
  JobsOptions options;
  std::vector<std::string> complaints;
  bool others_serve = false;
  std::vector<RequestWatch*> watches;
  std::unique_ptr<Jobs> jobs;

  World();
  void restart();  // as after kill -9: what was not committed is gone, so are the runs

  // Inputs, each settled at once.
  void submit(const msg::PlanRequest& request);
  void cancel(const Id& id, const Id& client = kClient, const std::string& reason = {});
  void query(const Id& id, std::uint32_t from = 0, const Id& client = kClient);
  void step(const Id& id, std::uint32_t index, const std::string& label = "a step");
  void end(const Id& id, msg::State state, std::uint16_t code = 0);
  void lose(const Id& id, std::uint16_t code);
  void wait(double seconds);
  void stop();

  // What was told, in order.
  std::vector<msg::PlanEvent> events(const Id& id, const Id& client = kClient) const;
  std::vector<std::uint32_t> steps(const Id& id, const Id& client = kClient) const;
  msg::PlanEvent last(const Id& id, const Id& client = kClient) const;  // the last event; fails the test if there is none
  msg::State state(const Id& id) const { return last(id).state(); }
  void forget_messages() { outbox.messages.clear(); }

  static inline const Id kClient = msg::id_of("a client");
  static inline const Id kOther = msg::id_of("another client");
};

// A request that nothing is wrong with, for robot "walker" with parameters cycles, gain, careful, method, note.
msg::PlanRequest good_request(const std::string& name = "a request");
Bytes step_bytes(const Id& request, std::uint32_t index, const std::string& label);
msg::ParameterSpec parameter_spec(const std::string& name, msg::ParameterKind kind, const std::string& initial, double minimum = 0,
                                  double maximum = 0, std::vector<std::string> choices = {});

}  // namespace foothold::server::testing
