// Carries the write-ahead log over into the database in a thread of its own, because that waits for the disk and the loop must not.
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace foothold::server {

class Checkpoints {
 public:
  // The thread opens `path` for itself.
  explicit Checkpoints(std::string path);
  ~Checkpoints();  // waits for a running checkpoint
  Checkpoints(const Checkpoints&) = delete;
  Checkpoints& operator=(const Checkpoints&) = delete;

  // Wakes the thread. Any thread, never waits for the disk.
  void start();
  // A checkpoint is under way or asked for.
  bool busy() const { return busy_; }

 private:
  void work();

  std::string path_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool due_ = false;
  bool stopping_ = false;
  std::atomic<bool> busy_ = false;
  std::thread thread_;
};

}  // namespace foothold::server
