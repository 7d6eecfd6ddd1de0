// What the state machine of requests asks of the world: a journal, planners, an outbox, scenes. Interfaces, so that every rule of
// idl/PROTOCOL.md is tested with no network, no process and a clock of the test's own.
//
// Thread rule for all of them: called from the server's one loop only.
#pragma once

#include <foothold.h>

#include <chrono>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "foothold/msg/cdr.hpp"
#include "foothold/msg/ids.hpp"

namespace foothold::server {

using msg::Bytes;
using msg::Id;

// A point in time of the loop: steady, for budgets and grace.
using Time = std::chrono::steady_clock::time_point;
using Duration = std::chrono::steady_clock::duration;

// Wall-clock nanoseconds since 1970, for stamps and for budgets across restarts.
using Stamp = std::int64_t;

class Clock {
 public:
  virtual ~Clock() = default;
  virtual Time now() const = 0;
  virtual Stamp stamp() const = 0;
};

// --------------------------------------------------------------------------------------------- journal

// A request as the journal keeps it.
struct Record {
  msg::PlanRequest request;
  Stamp received = 0;
  std::optional<msg::PlanEvent> final_event;  // of the final state; nothing while unfinished
  std::vector<msg::Shape> scene;              // if the request asked for shapes
  std::uint32_t steps = 0;
};

inline constexpr std::uint32_t kAllSteps = std::numeric_limits<std::uint32_t>::max();

// The memory that survives kill -9. Writes are collected and made durable by commit(); reads see what was written before.
// A failure (disk full) throws JournalError; what was written since the last commit() is then not kept.
class Journal {
 public:
  virtual ~Journal() = default;
  virtual void add_request(const msg::PlanRequest& request, Stamp received) = 0;
  virtual void add_step(const Id& request, std::uint32_t index, const Bytes& step) = 0;
  virtual void set_scene(const Id& request, const std::vector<msg::Shape>& shapes) = 0;
  virtual void set_final(const Id& request, const msg::PlanEvent& event) = 0;
  virtual void commit() = 0;
  virtual bool knows(const Id& request) = 0;
  virtual std::optional<Record> find(const Id& request) = 0;
  // `most` of them, from that number on.
  virtual std::vector<Bytes> steps(const Id& request, std::uint32_t from, std::uint32_t most) = 0;
  virtual std::vector<Record> unfinished() = 0;  // in the order of receipt
  // Forgets some requests that ended before `stamp`, and their steps. False when there are no more of them. To be committed.
  virtual bool forget_before(Stamp stamp) = 0;
};

class JournalError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// --------------------------------------------------------------------------------------------- scenes

struct StoredScene {
  std::string name, revision, format, path;
  std::uint64_t size = 0;
  Stamp stamp = 0;
};

class SceneShelf {
 public:
  virtual ~SceneShelf() = default;
  virtual bool knows(const std::string& name) const = 0;
  // Empty revision: the newest of that name.
  virtual std::optional<StoredScene> find(const std::string& name, const std::string& revision) const = 0;
};

// --------------------------------------------------------------------------------------------- planners

// A run of a request on a worker. Never used twice.
using Run = std::uint64_t;

struct RunEnd {
  enum class Kind { kReport, kLost };
  Kind kind = Kind::kReport;
  // kReport: what the worker said. SUCCEEDED, PARTIAL, FAILED, or CANCELLED if it heeded its stop token.
  msg::State state = msg::FAILED;
  msg::Error error;
  msg::Summary summary;
  // kLost: `error` is WORKER_CRASHED, WORKER_KILLED or OUT_OF_MEMORY with the signal and the last words.
};

struct RobotStatus {
  // Null: no such robot. State READY, QUARANTINED or UNAVAILABLE with its reason. The same object as long as nothing in it changes.
  std::shared_ptr<const msg::RobotInfo> info;
  double retry_after = 0.0;  // s, when QUARANTINED
};

// How the workers answer. Jobs implements it. After on_run_end nothing follows for that run.
class RunEvents {
 public:
  virtual ~RunEvents() = default;
  virtual void on_run_scene(Run run, std::vector<msg::Shape> shapes) = 0;
  // `step` is the CDR of foothold::msg::Step; its request and index are `run`'s next ones, which Planners has checked.
  virtual void on_run_step(Run run, std::uint32_t index, Bytes step) = 0;
  virtual void on_run_end(Run run, RunEnd end) = 0;
  // A slot of this robot became idle, or the robot's state changed.
  virtual void on_slots_changed(const std::string& robot) = 0;
};

// The workers of every robot, seen as slots. Answers come through RunEvents, never from inside one of these calls.
class Planners {
 public:
  virtual ~Planners() = default;
  virtual RobotStatus status(const std::string& robot) const = 0;
  // True if a worker of this robot waits for work.
  virtual bool has_idle(const std::string& robot) const = 0;
  // Precondition: has_idle. Gives the request to a worker.
  virtual Run start(const msg::PlanRequest& request, double budget_left, const std::optional<StoredScene>& scene) = 0;
  virtual void stop(Run run) = 0;                          // sets the stop token
  virtual void kill(Run run, const std::string& why) = 0;  // SIGKILL; on_run_end follows
};

// --------------------------------------------------------------------------------------------- outbox

// What goes to clients, at once: Jobs calls it only when the journal has committed what it tells of.
class Outbox {
 public:
  virtual ~Outbox() = default;
  virtual void open(const Id& client) = 0;  // the client's partition, if it is not open
  virtual void event(const Id& client, const msg::PlanEvent& event) = 0;
  virtual void step(const Id& client, const Bytes& step) = 0;  // CDR of foothold::msg::Step
  // Steps wait for this client, because its reader does not keep up; of this request.
  virtual bool waits(const Id& client) const = 0;
  virtual bool waits(const Id& client, const Id& request) const = 0;
};

}  // namespace foothold::server
