// The program as a child, its output in a file.
#include "program.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <iterator>

namespace foothold::test {

Program::Program(const std::string& vendor, unsigned domain, const std::string& arguments) {
  static std::atomic<int> count = 0;
  output_ = std::filesystem::path(testing::TempDir()) / ("foothold_" + std::to_string(getpid()) + "_" + std::to_string(++count));
  std::filesystem::remove(output_);
  const std::string command =
      "exec " FOOTHOLD_PROGRAM " --dds " + vendor + " --domain " + std::to_string(domain) + " --timeout 15 " + arguments;
  child_ = std::make_unique<Child>(std::vector<std::string>{"/bin/sh", "-c", command}, output_);
}

Program::~Program() {
  child_.reset();
  std::filesystem::remove(output_);
}

std::string Program::text() const {
  std::ifstream file(output_, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

Printed Program::finish(double seconds) {
  const int code = child_->wait(seconds).value_or(-1);
  return {code, text()};
}

Printed run(const std::string& vendor, unsigned domain, const std::string& arguments) {
  return Program(vendor, domain, arguments).finish();
}

}  // namespace foothold::test
