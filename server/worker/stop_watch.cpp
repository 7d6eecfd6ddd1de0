// A timer that is armed when a run begins, and a poll while a long run lasts.
#include "worker/stop_watch.hpp"

#include <poll.h>
#include <pthread.h>
#include <sys/eventfd.h>
#include <sys/timerfd.h>
#include <unistd.h>

#include <csignal>
#include <system_error>

namespace foothold::server {
namespace {

constexpr long kUnwatched = 1'000'000;  // ns; a tenth of what heeding a stop token may take

void arm(int timer, long nanoseconds) {
  const itimerspec when{.it_interval = {0, 0}, .it_value = {0, nanoseconds}};
  timerfd_settime(timer, 0, &when, nullptr);
}

// Waits until the descriptor of a timer or an event rings, and takes the ring.
void take_ring(int descriptor) {
  std::uint64_t count = 0;
  while (::read(descriptor, &count, sizeof(count)) < 0 && errno == EINTR) {
  }
}

void ring(int event) {
  const std::uint64_t one = 1;
  while (::write(event, &one, sizeof(one)) < 0 && errno == EINTR) {
  }
}

}  // namespace

StopWatch::StopWatch(Channel& channel) : channel_(channel) {
  timer_ = timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC);
  wake_ = eventfd(0, EFD_CLOEXEC);
  if (timer_ < 0 || wake_ < 0) throw std::system_error(errno, std::generic_category(), "timerfd or eventfd");
  // A plugin's process signals shall meet the plugin's thread.
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  thread_ = std::thread([this] { watch(); });
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

StopWatch::~StopWatch() {
  {
    const std::lock_guard lock(mutex_);
    leaving_ = true;
  }
  arm(timer_, 1);
  thread_.join();
  close(timer_);
  close(wake_);
}

void StopWatch::begin(std::uint64_t run, std::stop_source source) {
  {
    const std::lock_guard lock(mutex_);
    run_ = run;
    source_ = std::move(source);
    running_ = true;
  }
  arm(timer_, kUnwatched);
}

void StopWatch::end() {
  arm(timer_, 0);
  const std::lock_guard lock(mutex_);
  running_ = false;
  source_ = std::stop_source(std::nostopstate);
  if (watching_) ring(wake_);
  watching_ = false;
}

void StopWatch::watch() {
  for (;;) {
    take_ring(timer_);
    {
      const std::lock_guard lock(mutex_);
      if (leaving_) return;
      if (!running_) continue;
      watching_ = true;
    }
    watch_one_run();
  }
}

void StopWatch::watch_one_run() {
  bool ended = false;
  for (;;) {
    {
      // First of all: a STOP may have come in one piece with the PLAN.
      const std::lock_guard lock(mutex_);
      if (running_) ended = look();
    }
    pollfd watched[] = {{wake_, POLLIN, 0}, {channel_.descriptor(), POLLIN, 0}};
    // Once the daemon is gone its end would ring for ever.
    if (::poll(watched, ended ? 1 : 2, -1) < 0) continue;
    if (watched[0].revents != 0) {
      take_ring(wake_);
      return;
    }
  }
}

bool StopWatch::look() {
  try {
    while (const auto frame = channel_.take())
      if (frame->kind == frame::STOP && frame->run == run_) source_.request_stop();
  } catch (const FrameFault&) {
    // The main thread meets the same fault when the run is over.
    source_.request_stop();
  }
  if (channel_.ended()) source_.request_stop();
  return channel_.ended();
}

}  // namespace foothold::server
