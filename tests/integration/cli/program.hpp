// Runs `foothold` as a user does: arguments in, what it printed and its exit code out.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "child.hpp"

namespace foothold::test {

struct Printed {
  int code = -1;
  std::string text;  // stdout and stderr
  bool has(const std::string& words) const { return text.find(words) != std::string::npos; }
};

// One that runs: so that a test can press Ctrl-C or stop the server meanwhile.
class Program {
 public:
  // Arguments as a shell takes them, without the program's name.
  Program(const std::string& vendor, unsigned domain, const std::string& arguments);
  ~Program();
  std::string text() const;  // so far
  bool has(const std::string& words) const { return text().find(words) != std::string::npos; }
  void signal(int number) { child_->signal(number); }
  // Waits for its end. After `seconds` the code stays -1.
  Printed finish(double seconds = 30.0);

 private:
  std::filesystem::path output_;
  std::unique_ptr<Child> child_;
};

Printed run(const std::string& vendor, unsigned domain, const std::string& arguments);

}  // namespace foothold::test
