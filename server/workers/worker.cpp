// The frames of one worker, its printed words, and its end.
#include "workers/worker.hpp"

#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "foothold/msg/errors.hpp"
#include "log/log.hpp"

namespace foothold::server {
namespace {

// One worker that emits without end must not keep the loop from the others.
constexpr int kReadsPerTurn = 4;
constexpr auto kRetireLimit = std::chrono::seconds(1);
// A process that dies closes its channel a little before it is gone.
constexpr auto kGoneLimit = std::chrono::milliseconds(200);

long steady_second() {
  return static_cast<long>(
      std::chrono::duration_cast<std::chrono::seconds>(std::chrono::steady_clock::now().time_since_epoch()).count());
}

std::string mebibytes(std::uint64_t bytes) { return std::to_string(bytes >> 20) + " MiB"; }

template <class Message>
Message decoded(const Frame& frame) {
  auto message = msg::decode<Message>(frame.payload);
  if (!message) throw FrameFault("a " + frame_name(frame.kind) + " frame whose payload cannot be read");
  return std::move(*message);
}

}  // namespace

Worker::Worker(boost::asio::io_context& loop, WorkerOwner& owner, std::string name, const std::string& program)
    : owner_(owner),
      name_(std::move(name)),
      process_(spawn_worker(program)),
      socket_(loop, process_.socket.release()),
      words_(loop, process_.words.release()),
      exit_(loop, process_.exit.release()),
      timer_(loop),
      last_words_([this](std::string_view line) {
        log::say(log::Level::kInfo, "worker " + std::to_string(process_.pid) + " of " + name_ + " says: " + std::string(line),
                 {{"robot", name_}, {"request", run_ ? msg::to_hex(request_) : std::string()}});
      }) {}

void Worker::abandon() {
  if (std::exchange(departed_, true)) return;
  kill_group(process_.pid);
  reap(process_.pid);
  close_all();
}

void Worker::close_all() {
  timer_.cancel();
  boost::system::error_code ignored;
  for (auto* descriptor : {&socket_, &words_, &exit_}) descriptor->close(ignored);
}

void Worker::load(const frame::Load& load, Duration limit) {
  watch_socket();
  watch_words();
  watch_exit();
  timer_.expires_after(limit);
  timer_.async_wait([self = shared_from_this(), limit](const auto& error) {
    if (error || self->phase_ != Phase::kLoading) return;
    const auto limit_ms = std::chrono::duration_cast<std::chrono::milliseconds>(limit).count();
    self->kill(msg::make_error(msg::WORKER_CRASHED, "the worker was not ready within " + std::to_string(limit_ms) + " ms"), true);
  });
  Bytes frame;
  encode_frame(frame::LOAD, 0, load, frame);
  send(std::move(frame));
}

void Worker::plan(Run run, const frame::Plan& plan) {
  phase_ = Phase::kBusy;
  run_ = run;
  request_ = plan.request().id();
  next_step_ = 0;
  scene_seen_ = false;
  Bytes frame;
  encode_frame(frame::PLAN, run, plan, frame);
  send(std::move(frame));
}

void Worker::stop() {
  Bytes frame;
  seal_frame(frame::STOP, run_.value_or(0), frame);
  send(std::move(frame));
}

void Worker::kill(msg::Error cause, bool crash) {
  if (departed_) return;
  if (!cause_) {
    cause_ = std::move(cause);
    cause_is_crash_ = crash;
  }
  // A killed worker may still have a report on its way, but gets no more work.
  if (phase_ != Phase::kBusy) phase_ = Phase::kLeaving;
  kill_group(process_.pid);
}

void Worker::retire() {
  // The end of the stream is a worker's sign to leave.
  if (socket_.is_open()) ::shutdown(socket_.native_handle(), SHUT_WR);
  let_leave();
}

// From now on its end is no surprise; that it stays would be one.
void Worker::let_leave() {
  phase_ = Phase::kLeaving;
  may_leave_ = true;
  timer_.expires_after(kRetireLimit);
  timer_.async_wait([self = shared_from_this()](const auto& error) {
    if (!error && !self->departed_) kill_group(self->process_.pid);
  });
}

void Worker::check_memory(std::uint64_t bytes) {
  if (departed_ || bytes == 0) return;
  const auto held = resident_memory(process_.pid);
  if (!held || *held <= bytes) return;
  // In a run it was the request that asked for too much; without one it is the planner.
  kill(msg::make_error(msg::OUT_OF_MEMORY,
                       "the worker holds " + mebibytes(*held) + ", at most " + mebibytes(bytes) + " are allowed"),
       phase_ != Phase::kBusy);
}

void Worker::send(Bytes frame) {
  if (!socket_.is_open()) return;
  std::size_t sent = 0;
  if (out_.empty()) {
    const ssize_t count = ::send(socket_.native_handle(), frame.data(), frame.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count > 0) sent = static_cast<std::size_t>(count);
  }
  if (sent == frame.size()) return;
  out_.insert(out_.end(), frame.begin() + static_cast<std::ptrdiff_t>(sent), frame.end());
  flush();
}

void Worker::flush() {
  if (flushing_ || out_.empty() || !socket_.is_open()) return;
  flushing_ = true;
  socket_.async_wait(socket_.wait_write, [self = shared_from_this()](const auto& error) {
    self->flushing_ = false;
    if (error || self->departed_) return;
    const ssize_t count = ::send(self->socket_.native_handle(), self->out_.data(), self->out_.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (count > 0) self->out_.erase(self->out_.begin(), self->out_.begin() + count);
    // A worker that is gone takes nothing more; its exit tells the rest.
    if (count < 0 && errno != EAGAIN && errno != EINTR) self->out_.clear();
    self->flush();
  });
}

void Worker::watch_socket() {
  socket_.async_wait(socket_.wait_read, [self = shared_from_this()](const auto& error) {
    if (error || self->departed_) return;
    for (int turn = 0; turn < kReadsPerTurn && self->receive(); ++turn) {
    }
    if (!self->departed_ && self->socket_.is_open()) self->watch_socket();
  });
}

bool Worker::receive() {
  const auto room = in_.room();
  const ssize_t count = ::recv(socket_.native_handle(), room.data(), room.size(), MSG_DONTWAIT);
  if (count < 0) return errno == EINTR;
  if (count == 0) {
    lose_channel();
    return false;
  }
  in_.filled(static_cast<std::size_t>(count));
  try {
    while (const auto frame = in_.next()) take(*frame);
  } catch (const FrameFault& fault) {
    boost::system::error_code ignored;
    socket_.close(ignored);
    kill(msg::make_error(msg::WORKER_PROTOCOL, std::string("the worker sent ") + fault.what()), true);
    return false;
  }
  return static_cast<std::size_t>(count) == room.size();
}

// Either the process is dying, which its exit will tell, or its plugin closed what is not its own.
void Worker::lose_channel() {
  boost::system::error_code ignored;
  socket_.close(ignored);
  if (may_leave_ || departed_) return;
  timer_.expires_after(kGoneLimit);
  timer_.async_wait([self = shared_from_this()](const auto& error) {
    if (!error && !self->departed_) self->kill(msg::make_error(msg::WORKER_PROTOCOL, "the worker closed its channel"), true);
  });
}

void Worker::take(const Frame& frame) {
  switch (frame.kind) {
    case frame::READY:
    case frame::REFUSED:
      return take_first(frame);
    case frame::SCENE:
    case frame::STEP:
    case frame::REPORT:
      return take_of_run(frame);
    case frame::LOAD:
    case frame::PLAN:
    case frame::STOP:
      break;
  }
  throw FrameFault("a " + frame_name(frame.kind) + " frame, which only the daemon sends");
}

void Worker::take_first(const Frame& frame) {
  // A retired worker may have been about to say that it is ready.
  if (phase_ == Phase::kLeaving) return;
  if (phase_ != Phase::kLoading) throw FrameFault("a second " + frame_name(frame.kind) + " frame");
  timer_.cancel();
  if (frame.kind == frame::READY) {
    auto ready = decoded<frame::Ready>(frame);
    phase_ = Phase::kIdle;
    owner_.on_ready(*this, std::move(ready.info()));
  } else {
    auto refused = decoded<frame::Refused>(frame);
    let_leave();
    owner_.on_refused(*this, std::move(refused.reason()));
  }
}

void Worker::take_of_run(const Frame& frame) {
  if (!run_ || *run_ != frame.run)
    throw FrameFault("a " + frame_name(frame.kind) + " frame of run " + std::to_string(frame.run) + ", which it does not have");
  if (frame.kind == frame::REPORT) return take_report(frame);
  if (frame.kind == frame::SCENE) {
    if (scene_seen_ || next_step_ != 0) throw FrameFault("a scene twice or after a step");
    scene_seen_ = true;
    owner_.on_scene(*run_, std::move(decoded<frame::SceneShapes>(frame).shapes()));
    return;
  }
  const auto head = peek_step(frame.payload);
  if (!head) throw FrameFault("a STEP frame whose payload is no step");
  if (head->request != request_)
    throw FrameFault("a step of request " + msg::to_hex(head->request) + " in a run of " + msg::to_hex(request_));
  if (head->index != next_step_)
    throw FrameFault("step " + std::to_string(head->index) + " where step " + std::to_string(next_step_) + " was due");
  owner_.on_step(*run_, next_step_++, Bytes(frame.payload.begin(), frame.payload.end()));
}

void Worker::take_report(const Frame& frame) {
  auto report = decoded<frame::Report>(frame);
  const auto state = report.state();
  if (state != msg::SUCCEEDED && state != msg::PARTIAL && state != msg::FAILED && state != msg::CANCELLED)
    throw FrameFault("a report of state " + std::string(msg::state_name(state)));
  if (report.summary().steps() != next_step_)
    throw FrameFault("a report of " + std::to_string(report.summary().steps()) + " steps after " + std::to_string(next_step_));
  const Run run = *run_;
  run_.reset();
  phase_ = cause_ || dying_ ? Phase::kLeaving : Phase::kIdle;
  if (report.leave()) let_leave();
  owner_.on_report(*this, run, std::move(report));
}

void Worker::watch_words() {
  words_.async_wait(words_.wait_read, [self = shared_from_this()](const auto& error) {
    if (error || self->departed_) return;
    self->hear();
    if (self->words_.is_open()) self->watch_words();
  });
}

void Worker::hear() {
  std::array<char, 4096> text{};
  // A few pieces a turn: a plugin that prints without end must not hold the loop.
  for (int piece = 0; piece < 16 && words_.is_open(); ++piece) {
    const ssize_t count = ::read(words_.native_handle(), text.data(), text.size());
    if (count > 0) {
      last_words_.hear({text.data(), static_cast<std::size_t>(count)}, steady_second());
      continue;
    }
    if (count < 0 && (errno == EAGAIN || errno == EINTR)) return;
    boost::system::error_code ignored;
    words_.close(ignored);
  }
}

void Worker::watch_exit() {
  exit_.async_wait(exit_.wait_read, [self = shared_from_this()](const auto& error) {
    if (!error && !self->departed_) self->depart();
  });
}

void Worker::depart() {
  dying_ = true;
  // While its leader is not reaped the group's number is its own: what the plugin started goes with it.
  kill_group(process_.pid);
  // What it said before it died still counts.
  while (socket_.is_open() && receive()) {
  }
  hear();
  const auto end = reap(process_.pid);
  departed_ = true;
  close_all();
  phase_ = Phase::kLeaving;
  owner_.on_departure(*this, departure(end));
}

Departure Worker::departure(const std::optional<ProcessEnd>& end) const {
  Departure out{.run = run_, .error = {}, .crash = false};
  const std::string who = "worker " + std::to_string(process_.pid) + " ";
  if (cause_) {
    out.error = *cause_;
    out.crash = cause_is_crash_;
  } else if (!may_leave_ || run_) {
    std::string how = "ended in an unknown way";
    if (end && end->by_signal) {
      const char* name = sigabbrev_np(end->number);
      how = std::string("died of SIG") + (name != nullptr ? name : std::to_string(end->number));
      if (end->number == SIGKILL) how += ", which footholdd did not send; the kernel does so when memory is short";
    } else if (end) {
      how = "exited with code " + std::to_string(end->number);
    }
    out.error = msg::make_error(msg::WORKER_CRASHED, who + how);
    out.crash = true;
  }
  if (out.error.code() != msg::NO_ERROR && !last_words_.text().empty())
    out.error.message(out.error.message() + "; its last words: " + last_words_.text());
  return out;
}

}  // namespace foothold::server
