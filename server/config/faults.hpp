// What is wrong with configuration files: all of it at once, each fault with file, line and field.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace foothold::server {

// "file:line: field: reason"; line 0 (the file as a whole) and an empty field are left out.
class Faults {
 public:
  void add(const std::string& file, int line, const std::string& field, const std::string& reason);
  void add(std::string sentence) { sentences_.push_back(std::move(sentence)); }
  void add(const Faults& others);
  bool empty() const { return sentences_.empty(); }
  const std::vector<std::string>& sentences() const { return sentences_; }

 private:
  std::vector<std::string> sentences_;
};

// what(): one fault a line.
class ConfigError : public std::runtime_error {
 public:
  explicit ConfigError(const Faults& faults);
  const std::vector<std::string>& faults() const { return faults_; }

 private:
  std::vector<std::string> faults_;
};

}  // namespace foothold::server
