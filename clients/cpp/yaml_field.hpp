// Private: a value in a YAML file that knows its place, so that every refusal names file, line and field.
#pragma once

#include <yaml-cpp/yaml.h>

#include <array>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "foothold/client/request_file.hpp"

namespace foothold::client {

class YamlField {
 public:
  YamlField(std::string file, std::string path, YAML::Node node) : file_(std::move(file)), path_(std::move(path)), node_(node) {}

  [[noreturn]] void refuse(const std::string& reason) const;
  const std::string& path() const { return path_; }

  // Refuses what is not a mapping, has a key twice or one that is not known.
  void expect_mapping(std::initializer_list<std::string_view> known) const;
  bool is_text() const { return node_.IsScalar(); }
  // The value of a key, if it is there.
  std::optional<YamlField> find(std::string_view key) const;
  // Refuses if it is missing.
  YamlField at(std::string_view key) const;

  std::string text() const;
  bool flag() const;
  double number() const;  // finite
  std::int64_t integer(std::int64_t least, std::int64_t most) const;
  std::uint64_t natural() const;
  std::vector<double> numbers() const;
  std::vector<YamlField> items() const;
  std::vector<std::pair<std::string, std::string>> texts() const;  // of a mapping, in the order of the file

 private:
  void expect_unique_keys() const;
  std::string scalar(const char* wanted) const;

  std::string file_, path_;
  YAML::Node node_;
};

}  // namespace foothold::client
