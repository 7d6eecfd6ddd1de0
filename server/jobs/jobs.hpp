// Jobs: the state machine of every request, as idl/PROTOCOL.md describes it. It knows no network, no process and no file: what it
// needs comes through the ports, time included.
//
// The loop hands it a batch of inputs (messages, run events, tick) and then calls settle(), which commits the journal and only then
// tells the clients. A request that can start at once goes to its worker before that commit, so that both overlap.
//
// Sources: requests.cpp (from clients), runs.cpp (from workers), endings.cpp (budget, cancel, stop, final states),
// settling.cpp (commit, answers, failing storage), recovery.cpp (after a restart).
//
// Thread rule: the server's one loop. A JournalError is handled inside, except in recover().
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <variant>
#include <vector>

#include "jobs/admission/admission.hpp"
#include "jobs/early_cancels.hpp"
#include "jobs/events.hpp"
#include "jobs/job.hpp"
#include "jobs/ports.hpp"
#include "jobs/queue.hpp"
#include "jobs/repeats.hpp"
#include "jobs/watch.hpp"

namespace foothold::server {

// How much may wait and run. May be changed while the server runs: what was accepted stays.
struct AdmissionLimits {
  std::size_t queued = 1000;            // requests that wait, of all clients and robots
  std::size_t queued_per_client = 250;  // of these, of one client
  std::size_t running_per_client = 0;   // plans of one client at the same time, of all robots; 0: as many as there are slots
};

struct JobsOptions {
  Id server{};
  std::string version;
  AdmissionLimits limits;
  double budget_max = 3600.0;      // s
  double grace = 0.25;             // s, from the stop token to the kill
  double cancel_memory = 10.0;     // s
  double retention = 7 * 86400.0;  // s
  double word_settles = 1.0;       // s after a client's word that it still counts on this server (P36)
  double word_wait = 5.0;          // s without that word, if no other server is heard
};

class Jobs final : public RunEvents {
 public:
  struct Ports {
    Journal& journal;
    Planners& planners;
    const SceneShelf& scenes;
    Outbox& outbox;
    const Clock& clock;
    std::vector<RequestWatch*> watches = {};
    std::function<bool()> others_serve = {};  // other servers are heard in this domain; nothing: never
  };
  // Figures for the heartbeat.
  struct Load {
    std::size_t queued = 0;
    std::size_t running = 0;
  };
  // Failures of the storage that did not reach a client by themselves, for the log.
  using Complain = std::function<void(const std::string&)>;

  Jobs(JobsOptions options, Ports ports, Complain complain = {});

  // Other limits from now on; what was taken keeps its budget. `server` and `version` stay.
  void set_options(JobsOptions options);

  // Ends or restarts what the journal holds as unfinished (P22). Once, before any other input; needs the robots' planners. Throws
  // JournalError.
  void recover();

  void request(msg::PlanRequest request);
  void cancel(const msg::CancelRequest& cancel);
  void query(const msg::StateQuery& query);

  void on_run_scene(Run run, std::vector<msg::Shape> shapes) override;
  void on_run_step(Run run, std::uint32_t index, Bytes step) override;
  void on_run_end(Run run, RunEnd end) override;
  void on_slots_changed(const std::string& robot) override;

  // Acts on budgets, graces and memories that are due.
  void tick();
  // When tick() has something to do next.
  std::optional<Time> next_deadline() const;

  // Ends everything as SERVER_STOPPING and takes nothing more (P23). Done when idle().
  void stop();
  // Nothing is unfinished and nothing is left to tell.
  bool idle() const { return jobs_.empty() && outgoing_.empty() && repeats_.empty(); }

  bool unfinished() const { return !jobs_.empty(); }

  // For the requests that come from now on.
  void set_limits(const AdmissionLimits& limits);

  // Ends the batch: commit, then tell.
  void settle();
  // Steps that were asked for are still to be sent: call repeat() every few milliseconds.
  bool repeating() const { return !repeats_.empty(); }
  void repeat();
  // False if the batch holds nothing but receipts of requests that have just gone to their workers. It may wait a moment then: what
  // the worker says can go with it, in one commit and one burst.
  bool urgent() const { return urgent_; }

  Load load() const { return {queue_.size(), runs_.size()}; }
  bool stopping() const { return stopping_; }
  // False while the journal refuses writes.
  bool storage_works() const { return storage_works_; }
  // True if a request of this client is unfinished.
  bool busy_for(const Id& client) const;

 private:
  // What waits for the commit, in order.
  struct Told {
    Id request;
    std::unique_ptr<msg::PlanEvent> event;
  };
  struct Sent {
    Id request, client;
    Bytes step;
  };
  struct Asked {
    Id request, client;
    std::optional<std::uint32_t> from_step;  // nothing: the event only
  };
  using Outgoing = std::variant<Told, Sent, Asked>;
  // A final state that the journal could not take yet.
  struct Unsaved {
    msg::PlanRequest request;
    Stamp received = 0;
    msg::PlanEvent event;
    bool accepted = false;  // the journal holds its receipt
  };

  // requests.cpp
  void take(msg::PlanRequest request);
  void moved_on(const msg::PlanRequest& request);
  void refuse_request(msg::PlanRequest request, msg::State state, msg::Error error);
  std::optional<bool> known(const Id& id);
  Refusal check_room(const msg::PlanRequest& request) const;
  double time_to_a_place(const msg::PlanRequest& request) const;
  Job& add_job(msg::PlanRequest request);
  void ask(const Id& request, const Id& client, std::optional<std::uint32_t> from_step);

  // runs.cpp
  Job* job_of(Run run);
  bool can_start(const msg::PlanRequest& request) const;
  void enqueue(Job& job);
  void dispatch(const std::string& robot);
  void dispatch_all();
  std::optional<Ending> hindrance(const Job& job) const;
  void start(Job& job);
  void tell_running(Job& job);
  void run_is_over(Job& job);
  void abandon(Job& job);
  void replayed(Job& job, std::uint32_t index, Bytes step);

  // endings.cpp
  void finish(Job& job, Ending ending);
  void halt(Job& job, Ending ending);
  void expire(Job& job);
  void set_alarm(Job& job, std::optional<Time> at);
  msg::Error budget_error(const Job& job) const;

  // settling.cpp
  template <class Write>
  void write(Job& job, Write&& write);
  bool commit();
  void settle_batch();
  void give_up(Job& job);
  void flush();
  void answer(const Asked& asked);
  void answer_with(const Asked& asked, msg::PlanEvent event);
  void save_unsaved();
  void forget_old();

  // recovery.cpp
  void resume(Record record);
  void hold(Job& job);
  void hear_word(Job& job, const msg::PlanRequest& again);
  void end_hold(Job& job);
  void run_again(Job& job);

  void tell(Job& job, msg::State state, msg::Error error);
  void show_end(const Job& job) const;
  void push(const Id& request, msg::PlanEvent event);

  JobsOptions options_;
  Ports ports_;
  Complain complain_;
  Speaker speaker_;
  bool stopping_ = false;
  std::uint64_t turns_ = 0;
  double mean_run_ = 1.0;  // s, of recent runs

  std::unordered_map<Id, Job, msg::IdHash> jobs_;
  std::unordered_map<Run, Id> runs_;
  std::unordered_map<Run, Time> abandoned_;  // told to stop; killed then
  Queue queue_;
  Shares shares_;
  bool look_again_ = false;  // a client that waited for one of its own plans to end may go on
  EarlyCancels early_cancels_;
  std::set<std::pair<Time, Id>> alarms_;

  std::vector<Outgoing> outgoing_;
  Repeats repeats_;
  bool urgent_ = false;
  std::vector<Id> touched_;           // what the running batch writes of
  std::optional<std::string> fault_;  // why the running batch cannot be stored
  bool storage_works_ = true;
  std::unordered_map<Id, Unsaved, msg::IdHash> unsaved_;
  Time save_again_{};
  Time forget_again_{};
};

// Writes to the journal for `job`. After a failure the rest of the batch is not even tried: none of it would be kept.
template <class Write>
void Jobs::write(Job& job, Write&& write) {
  if (!job.touched) touched_.push_back(job.request.id());
  job.touched = true;
  if (fault_) return;
  try {
    write();
  } catch (const JournalError& error) {
    fault_ = error.what();
  }
}

}  // namespace foothold::server
