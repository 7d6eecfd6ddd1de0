// A process that a test started: ended with the test whatever happens, and only ever by the pid that fork() gave.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace foothold::test {

// Thread rule: made and used by the main thread, whose end ends the child too.
class Child {
 public:
  // `command[0]` is the program's path. Its output is appended to `output`, or is ours if that is empty. Throws
  // std::runtime_error.
  explicit Child(const std::vector<std::string>& command, const std::filesystem::path& output = {});
  ~Child();  // SIGKILL if it still runs
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  pid_t pid() const { return pid_; }
  bool running() { return !wait(0.0) && !ended_; }
  // Does nothing when it has ended.
  void signal(int number);
  // Its exit code, or minus the signal that ended it; nothing if it does not end within `seconds`.
  std::optional<int> wait(double seconds);

 private:
  pid_t pid_ = -1;
  std::optional<int> ended_;
};

}  // namespace foothold::test
