// Reading YAML values strictly.
#include "yaml_field.hpp"

#include <charconv>
#include <cmath>
#include <set>

#include "foothold/client/nearest_name.hpp"

namespace foothold::client {
namespace {

// The whole text as a number, or nothing. YAML's own readings (octal, sexagesimal, .5) are left out on purpose.
template <class N>
std::optional<N> parse(const std::string& text) {
  const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
  N number{};
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace

void YamlField::refuse(const std::string& reason) const {
  const YAML::Mark mark = node_.Mark();
  throw RequestFileError(file_ + ":" + std::to_string(std::max(mark.line, 0) + 1) + ": " + (path_.empty() ? "" : path_ + ": ") +
                         reason);
}

void YamlField::expect_unique_keys() const {
  std::set<std::string> seen;
  for (const auto& entry : node_) {
    if (!entry.first.IsScalar()) YamlField(file_, path_, entry.first).refuse("a key must be a word");
    if (!seen.insert(entry.first.Scalar()).second)
      YamlField(file_, path_, entry.first).refuse("'" + entry.first.Scalar() + "' is given twice");
  }
}

void YamlField::expect_mapping(std::initializer_list<std::string_view> known) const {
  if (!node_.IsMap()) refuse("expected keys with values");
  expect_unique_keys();
  for (const auto& entry : node_) {
    const std::string key = entry.first.Scalar();
    if (std::ranges::find(known, key) != known.end()) continue;
    const std::string full = path_.empty() ? key : path_ + "." + key;
    YamlField(file_, full, entry.first).refuse("is not known" + suggestion(key, known));
  }
}

std::optional<YamlField> YamlField::find(std::string_view key) const {
  const YAML::Node value = node_[std::string(key)];
  if (!value) return std::nullopt;
  return YamlField(file_, path_.empty() ? std::string(key) : path_ + "." + std::string(key), value);
}

YamlField YamlField::at(std::string_view key) const {
  if (auto field = find(key)) return *field;
  YamlField(file_, path_.empty() ? std::string(key) : path_ + "." + std::string(key), node_).refuse("is missing");
}

std::string YamlField::scalar(const char* wanted) const {
  if (!node_.IsScalar()) refuse(std::string("expected ") + wanted);
  return node_.Scalar();
}

std::string YamlField::text() const {
  const std::string words = scalar("text");
  if (words.empty()) refuse("is empty");
  return words;
}

bool YamlField::flag() const {
  const std::string word = scalar("true or false");
  if (word != "true" && word != "false") refuse("expected true or false, not '" + word + "'");
  return word == "true";
}

double YamlField::number() const {
  const std::string word = scalar("a number");
  const auto number = parse<double>(word);
  if (!number) refuse("expected a number, not '" + word + "'");
  if (!std::isfinite(*number)) refuse("expected a finite number, not '" + word + "'");
  return *number;
}

std::int64_t YamlField::integer(std::int64_t least, std::int64_t most) const {
  const std::string word = scalar("an integer");
  const auto number = parse<std::int64_t>(word);
  if (!number) refuse("expected an integer, not '" + word + "'");
  if (*number < least || *number > most) refuse(word + " is not between " + std::to_string(least) + " and " + std::to_string(most));
  return *number;
}

std::uint64_t YamlField::natural() const {
  const std::string word = scalar("an integer of 0 or more");
  const auto number = parse<std::uint64_t>(word);
  if (!number) refuse("expected an integer of 0 or more, not '" + word + "'");
  return *number;
}

std::vector<YamlField> YamlField::items() const {
  if (!node_.IsSequence()) refuse("expected a list");
  std::vector<YamlField> list;
  for (std::size_t i = 0; i < node_.size(); ++i) list.emplace_back(file_, path_ + "[" + std::to_string(i) + "]", node_[i]);
  return list;
}

std::vector<double> YamlField::numbers() const {
  std::vector<double> list;
  for (const YamlField& item : items()) list.push_back(item.number());
  return list;
}

std::vector<std::pair<std::string, std::string>> YamlField::texts() const {
  if (!node_.IsMap()) refuse("expected keys with values");
  expect_unique_keys();
  std::vector<std::pair<std::string, std::string>> list;
  for (const auto& entry : node_)
    list.emplace_back(entry.first.Scalar(), YamlField(file_, path_ + "." + entry.first.Scalar(), entry.second).scalar("one value"));
  return list;
}

}  // namespace foothold::client
