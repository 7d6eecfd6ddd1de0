// The loop between a plan and the terminal.
#include "follow.hpp"

#include <chrono>

#include "foothold/client/plan_file.hpp"
#include "foothold/msg/errors.hpp"
#include "interrupt.hpp"
#include "report.hpp"
#include "terminal.hpp"

namespace foothold::cli {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kLook = 0.05;  // s between looks at Ctrl-C and at the server

double since(Clock::time_point time) { return std::chrono::duration<double>(Clock::now() - time).count(); }

class Follower {
 public:
  Follower(client::Plan& plan, const Common& common, const Following& following)
      : plan_(plan), common_(common), following_(following) {}

  msg::PlanEvent run() {
    while (!plan_.ended() || plan_.steps_ready() > shown_) {
      const msg::Step* step = plan_.next(kLook);
      look_at_state();
      if (step != nullptr) show(*step);
      look_at_server();
      look_at_interrupt();
      if (since(begin_) > following_.patience && !plan_.ended()) give_up("did not end in time");
    }
    if (lost_ && !common_.json) std::puts("the server is back");
    return plan_.wait(0.0).value();
  }

 private:
  void show(const msg::Step& step) {
    ++shown_;
    if (common_.json)
      std::puts(client::to_json_line(step).c_str());
    else if (following_.show_steps)
      print_step(step, since(plan_.times().submitted), following_.verbose, label_width_);
    std::fflush(stdout);
  }

  void look_at_state() {
    const msg::State state = plan_.state();
    if (state == state_) return;
    state_ = state;
    if (msg::is_final(state) || state == msg::UNKNOWN) return;
    if (common_.json)
      std::puts(client::to_json_line(*plan_.last_event()).c_str());
    else if (state == msg::QUEUED)
      std::puts("waiting: every planner of this robot is busy");
    std::fflush(stdout);
  }

  void look_at_server() {
    if (const std::size_t moves = plan_.traffic().moves; moves != moves_) {
      moves_ = moves;
      lost_.reset();
      if (!common_.json)
        std::printf("its server cannot go on; server %s has the request now\n", msg::to_hex(plan_.server()).c_str());
      std::fflush(stdout);
    }
    if (!plan_.server_lost()) {
      if (lost_ && !common_.json) std::puts("the server is back");
      lost_.reset();
      return;
    }
    if (!lost_) {
      lost_ = Clock::now();
      if (!common_.json) std::puts("the server is silent; waiting for it");
      std::fflush(stdout);
    }
    if (since(*lost_) > common_.timeout) give_up("lost its server");
  }

  void look_at_interrupt() {
    if (cancelled_ || !interrupted()) return;
    cancelled_ = true;
    plan_.cancel("Ctrl-C");
    std::fputs("\ncancelling; Ctrl-C again to leave at once\n", stderr);
  }

  [[noreturn]] void give_up(const char* what) const {
    const std::string id = msg::to_hex(plan_.id());
    throw Complaint(Exit::kNoServer, "request " + id + " " + what, "ask for it later: foothold state " + id);
  }

  client::Plan& plan_;
  const Common& common_;
  const Following& following_;
  const Clock::time_point begin_ = Clock::now();
  std::size_t shown_ = 0;
  msg::State state_ = msg::UNKNOWN;
  std::optional<Clock::time_point> lost_;
  std::size_t moves_ = 0;
  bool cancelled_ = false;
  std::size_t label_width_ = 0;
};

}  // namespace

msg::PlanEvent follow(client::Plan& plan, const Common& common, const Following& following) {
  return Follower(plan, common, following).run();
}

}  // namespace foothold::cli
