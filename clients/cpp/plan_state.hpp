// Private: one plan as the client sees it. Knows the rules (what is new, what is missing, when to ask, when to send again, when it
// is over) and who waits for it; knows no bus and starts no thread.
#pragma once

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "foothold/client/client.hpp"
#include "step_order.hpp"

namespace foothold::client {

class Outgoing;

// Thread rule: any thread; locks itself. Callbacks run in deliver() only, outside the lock.
class PlanState {
 public:
  using Clock = std::chrono::steady_clock;
  using Time = Clock::time_point;
  enum class Origin { kSubmitted, kAskedFor };

  PlanState(msg::PlanRequest request, Origin origin, std::uint32_t from, PlanCallbacks callbacks, const ClientOptions& options,
            std::weak_ptr<Outgoing> outgoing);

  // ---- what arrives. True if callbacks have something to do.
  bool accept(msg::Step step, Time now);
  // `alive`: the servers that could know the request.
  bool accept(const msg::PlanEvent& event, std::span<const msg::Id> alive, Time now);
  bool set_server_lost(const msg::Id& server, bool lost, Time now);

  // ---- another server instead (P34 to P38)
  // True if this plan's server is lost, or has ended it for a reason that another may not have: then, in whatever order,
  // move() if there is another server, or stay().
  bool wants_another() const;
  std::vector<msg::Id> left() const;  // who had it before; never asked again
  bool move(const msg::Id& server, Time now);
  bool stay(Time now);  // the end stands; a lost server is waited for
  // A cancel that is still to be sent for a plan that is over here, but not at its server.
  std::optional<msg::CancelRequest> take_farewell();

  // ---- what is to be done now
  enum class Due { kNothing, kSend, kAsk };
  // Counts as done, and sets the time of the next.
  Due due(Time now);
  // This process was halted: what has come meanwhile is looked at before anything is asked for.
  void wait_for_news(Time now);
  bool unsent() const;  // kept until a server is known
  // Before the first kSend. `revision`: of its scene, as far as known, in case another server has to plan the same.
  // The first choice stays: the caller's thread and the keeper may choose at the same time.
  void choose(const msg::Id& server, const std::string& revision = {});
  msg::StateQuery question(const msg::Id& client) const;
  // What was cancelled and has not ended: sent again with every question, for a server that was away the first time.
  std::optional<msg::CancelRequest> unanswered_cancel() const;
  void deliver();
  void detach();  // the client is gone

  // ---- what the handle reads
  const msg::Id& id() const { return request_.id(); }
  msg::PlanRequest request() const;
  const msg::Step* next(std::size_t& place, double seconds);
  std::optional<msg::PlanEvent> wait(double seconds) const;
  msg::Id server() const;  // who has it, zeros while that is not known
  msg::State state() const;
  std::optional<msg::PlanEvent> last_event() const;
  bool ended() const;
  bool over() const;  // ended and told
  bool server_lost() const;
  std::size_t steps_ready() const;
  PlanTraffic traffic() const;
  PlanTimes times() const;
  PlanRecord record() const;
  bool wants_callbacks() const { return callbacks_.any(); }
  void cancel(const std::string& reason);

 private:
  bool has_ended() const;
  bool misses_steps() const;
  bool is_of_another(const msg::Id& server) const;
  bool may_move() const;
  void accept_final(const msg::PlanEvent& event, std::span<const msg::Id> alive, Time now);
  void end_as(msg::PlanEvent event);
  void end_as_different(std::uint32_t index);
  void progress(Time now);
  void accept_unknown(const msg::PlanEvent& event, std::span<const msg::Id> alive, Time now);
  bool note_end(Time now);  // true if it has ended
  void tell_over();

  msg::PlanRequest request_;
  const Origin origin_;
  const PlanCallbacks callbacks_;
  const double repair_after_, resend_after_;
  const bool fixed_;  // to the server that the caller named
  const std::weak_ptr<Outgoing> outgoing_;

  mutable std::mutex mutex_;
  mutable std::condition_variable arrived_, over_;  // next() waits for the one, wait() for the other
  StepOrder steps_;
  std::uint32_t announced_ = 0;  // steps that the server says it has sent
  msg::Id server_{};
  msg::State state_ = msg::UNKNOWN;
  std::optional<msg::PlanEvent> final_, last_;
  std::vector<msg::Shape> scene_;
  bool sent_ = false, heard_ = false, lost_ = false, detached_ = false;
  std::optional<msg::CancelRequest> cancel_;
  std::vector<msg::Id> left_;
  std::string revision_;
  std::optional<msg::PlanEvent> refusal_;     // the end as the last server said it, while another may be found
  std::optional<msg::PlanEvent> moved_away_;  // of a plan asked for: what a server said that has it no more
  bool cut_ = false;                          // the end stands although the last server has not sent so many steps
  bool word_ = false;                         // its server was restarted and asks whether it is still wanted
  std::optional<msg::CancelRequest> farewell_;
  std::vector<msg::Id> not_known_to_;
  int not_known_ = 0;  // answers in a row that said so
  Time next_due_{};
  double patience_;     // s until the next due
  bool asked_ = false;  // and neither answered nor overtaken by progress
  PlanTraffic traffic_;
  PlanTimes times_;

  // What deliver() has still to tell.
  struct News {
    std::optional<msg::PlanEvent> event;
    bool lost = false;
  };
  std::deque<News> untold_;
  std::size_t told_steps_ = 0;
  bool told_end_ = false;
};

}  // namespace foothold::client
