// A child process that speaks frames (frames.hpp) on its stdin and stdout, and a mailbox to wait for what it says.
#pragma once

#include <sys/types.h>

#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "frames.hpp"

namespace foothold::test {

class Peer {
 public:
  enum class Errors { kShown, kHidden };  // what it says on stderr
  // `command[0]` is a program of this build's bin folder. Throws std::runtime_error.
  explicit Peer(const std::vector<std::string>& command, Errors errors = Errors::kShown);
  ~Peer();  // closes its stdin and waits for it, 20 s at most, then kills it
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;

  bool send(std::span<const std::byte> message);  // as kMessage
  void kill_hard();                               // kill -9
  int finish();                                   // closes stdin; its exit code, or minus the signal
  pid_t pid() const { return pid_; }

  // True as soon as `enough` holds of all frames so far; false after `seconds`.
  bool wait(double seconds, const std::function<bool(const std::vector<Frame>&)>& enough);
  bool wait_ready(double seconds = 20.0);
  bool wait_number(Kind kind, std::uint64_t number, double seconds = 20.0);  // the latest of that kind
  bool wait_messages(std::size_t count, double seconds = 60.0);
  std::vector<std::vector<std::byte>> messages();

 private:
  void collect();

  pid_t pid_ = -1;
  int to_ = -1;
  int from_ = -1;
  int status_ = 0;
  std::mutex mutex_;  // of frames_ and ended_
  std::condition_variable changed_;
  std::vector<Frame> frames_;
  std::size_t message_count_ = 0;
  bool ended_ = false;
  std::thread collector_;
};

}  // namespace foothold::test
