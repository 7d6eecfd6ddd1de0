// Starting foothold-worker: a process group of its own, one end of a socket pair as descriptor 3, its stdout and stderr in a pipe.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

namespace foothold::server {

// A descriptor that closes itself.
class OwnedFd {
 public:
  OwnedFd() = default;
  explicit OwnedFd(int fd) : fd_(fd) {}
  OwnedFd(OwnedFd&& other) noexcept : fd_(other.release()) {}
  OwnedFd& operator=(OwnedFd&& other) noexcept;
  ~OwnedFd();
  int get() const { return fd_; }
  int release();

 private:
  int fd_ = -1;
};

// A running child. Whoever holds it reaps it: reap() once `exit` is readable.
struct Process {
  pid_t pid = -1;
  OwnedFd socket;  // blocking; use MSG_DONTWAIT
  OwnedFd words;   // what it prints; non-blocking
  OwnedFd exit;    // pidfd: readable when it has ended
};

// How a process ended.
struct ProcessEnd {
  bool by_signal = false;
  int number = 0;  // signal or exit code
};

// Call from the thread that outlives every worker: a worker dies with the thread that started it. Throws std::system_error.
Process spawn_worker(const std::string& program);

// SIGKILL to the process and all that it started. Only before reap().
void kill_group(pid_t pid);

// Waits for the end, which must be near or there. Nothing if it is not our child (any more).
std::optional<ProcessEnd> reap(pid_t pid);

// Octets of memory that the process holds now; nothing if it has ended.
std::optional<std::uint64_t> resident_memory(pid_t pid);

}  // namespace foothold::server
