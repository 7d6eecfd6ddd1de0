// A plan under way: steps in order and without gaps, as an iterator or by callbacks, and how it ended.
#pragma once

#include <foothold.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "foothold/client/plan_record.hpp"
#include "foothold/msg/ids.hpp"

namespace foothold::client {

class PlanState;

inline constexpr double kForever = std::numeric_limits<double>::infinity();

// What a plan tells by callbacks; each is optional. All run on the client's one delivery thread, one at a time, in the order of the
// plan: on_event (RUNNING, left out by a short plan), on_step (0, 1, ...), on_event (final, always last and only when every step
// was delivered). Inside a callback submit(), query(), cancel() and the reading functions of Plan may be called; wait() and next()
// on another plan would hold up every other callback, and the client must not be destroyed there. A callback that throws ends the
// process.
struct PlanCallbacks {
  std::function<void(const msg::Step&)> on_step;
  std::function<void(const msg::PlanEvent&)> on_event;  // each change of state
  // The plan's server fell silent (true), or is back, or another has the request now (false; Plan::server() says which).
  std::function<void(bool lost)> on_server;
  bool any() const { return on_step || on_event || on_server; }
};

// What it took to get the plan.
struct PlanTraffic {
  std::size_t requests = 0;    // how often the request was sent (the same id: never a second plan)
  std::size_t queries = 0;     // how often the client asked for what it missed
  std::size_t duplicates = 0;  // steps that arrived again
  std::size_t moves = 0;       // how often it was submitted to another server, because one was lost or could not take it
};

// When things happened, on this machine; zero time points did not happen yet.
struct PlanTimes {
  std::chrono::steady_clock::time_point submitted, first_step, ended;
};

// A handle; copies share the plan and have each their own place in the steps. Valid after its client is gone, but then nothing
// more arrives. Dropping it cancels nothing: the plan runs on at the server. Thread rule: a handle is used by one thread at a time;
// copies may be used by several at once.
class Plan {
 public:
  explicit Plan(std::shared_ptr<PlanState> state);

  const msg::Id& id() const;
  msg::PlanRequest request() const;

  // The next step in order, as soon as it is there. nullptr after `seconds`, when the plan has no more steps (ended()), or when the
  // client is gone. The step lives as long as any handle of this plan.
  const msg::Step* next(double seconds = kForever);

  // for (const msg::Step& step : plan) waits for each step and ends with the plan.
  class Iterator {
   public:
    using value_type = msg::Step;
    using difference_type = std::ptrdiff_t;
    Iterator() = default;
    explicit Iterator(Plan* plan) : plan_(plan), step_(plan->next()) {}
    const msg::Step& operator*() const { return *step_; }
    Iterator& operator++() {
      step_ = plan_->next();
      return *this;
    }
    void operator++(int) { ++*this; }
    bool operator==(std::default_sentinel_t) const { return step_ == nullptr; }

   private:
    Plan* plan_ = nullptr;
    const msg::Step* step_ = nullptr;
  };
  Iterator begin() { return Iterator(this); }
  std::default_sentinel_t end() const { return {}; }

  // The final event, once it and every step are there; nothing after `seconds`.
  std::optional<msg::PlanEvent> wait(double seconds = kForever) const;

  // The state as last heard; UNKNOWN before the server answered.
  msg::State state() const;
  // What the server said last, also in answers; nothing before it answered.
  std::optional<msg::PlanEvent> last_event() const;
  // True once the final event and every step have arrived. A plan asked for by an id that no server knows ends in state UNKNOWN.
  bool ended() const;
  // Who has the request; zeros while that is not known.
  msg::Id server() const;
  // The plan's server is silent, and no other can take its place. The plan goes on by itself when it is back.
  bool server_lost() const;
  // Steps that are there in order.
  std::size_t steps_ready() const;
  PlanTraffic traffic() const;
  PlanTimes times() const;
  // Everything so far, as values.
  PlanRecord record() const;

  // Asks the server to stop. Returns at once; the answer is the plan's final event, which may also be another than CANCELLED.
  void cancel(const std::string& reason);

 private:
  std::shared_ptr<PlanState> state_;
  std::size_t read_ = 0;
};

}  // namespace foothold::client
