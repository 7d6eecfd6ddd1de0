// One request between its receipt and the commit of its final state.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "jobs/ports.hpp"
#include "jobs/queue.hpp"

namespace foothold::server {

// A final state that is decided and waits: for the worker to heed its stop token, or to die.
struct Ending {
  msg::State state = msg::FAILED;
  msg::Error error;
};

struct Job {
  msg::PlanRequest request;
  Stamp received = 0;
  Time deadline{};         // the budget's end
  Time arrived{};          // receipt, on this process's clock
  std::uint64_t turn = 0;  // place in the order of receipt

  msg::PlanEvent last;            // the last change of state, as told (without the scene)
  bool told = false;              // false while a RUNNING event waits for the scene's shapes
  std::vector<msg::Shape> scene;  // the shapes that the RUNNING event shall carry

  std::optional<Run> run;
  Time started{};  // of the run
  Time stepped{};  // its latest step, or its start; none before this process has started it
  Time over{};     // its final state was entered
  std::optional<Ending> ending;

  std::uint32_t steps = 0;      // written to the journal, the running batch's included
  std::uint32_t committed = 0;  // of these, made durable
  std::uint32_t seen = 0;       // that the current run has handed over
  std::vector<Bytes> replay;    // steps of a run before a restart, which this run must repeat

  bool held = false;          // found after a restart, waits for its client's word (P36)
  bool word = false;          // which has come
  bool ran = false;           // it was RUNNING once
  bool killed = false;        // its worker did not heed the stop token
  bool accepted = false;      // its receipt is durable
  bool touched = false;       // the running batch writes of it
  std::optional<Time> alarm;  // its entry among the timers

  Queue::Place place() const { return {request.robot(), request.priority(), request.client(), turn}; }
  bool ended() const { return last.state() >= msg::SUCCEEDED; }
};

}  // namespace foothold::server
