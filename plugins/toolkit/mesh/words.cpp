// Words, lines and numbers.
#include "mesh/words.hpp"

#include <algorithm>
#include <charconv>

#include "foothold/errors.hpp"

namespace foothold::mesh {
namespace {

bool ends_line(char c) { return c == '\n' || c == '\r'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

template <class Number>
bool whole(std::string_view word, Number& value) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc() && end == word.data() + word.size() && !word.empty();
}

}  // namespace

void Words::skip_blanks() {
  rest_.remove_prefix(static_cast<std::size_t>(std::find_if_not(rest_.begin(), rest_.end(), is_blank) - rest_.begin()));
}

std::string_view Words::next_in_line() {
  skip_blanks();
  const auto end = std::find_if(rest_.begin(), rest_.end(), [](char c) { return is_blank(c) || ends_line(c); });
  const std::string_view word = rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
  rest_.remove_prefix(word.size());
  return word;
}

std::string_view Words::next() {
  for (;;) {
    if (const std::string_view word = next_in_line(); !word.empty() || at_end()) return word;
    skip_line();
  }
}

void Words::skip_line() {
  rest_.remove_prefix(static_cast<std::size_t>(std::find_if(rest_.begin(), rest_.end(), ends_line) - rest_.begin()));
  if (rest_.empty()) return;
  rest_.remove_prefix(rest_.starts_with("\r\n") ? 2 : 1);
  ++line_;
}

double Words::number(std::string_view word) const {
  double value = 0.0;
  if (!whole(word, value)) fail(word.empty() ? "a number is missing" : shown(word) + " is no number");
  return value;
}

std::int64_t Words::integer(std::string_view word) const {
  std::int64_t value = 0;
  if (!whole(word, value)) fail(word.empty() ? "a whole number is missing" : shown(word) + " is no whole number");
  return value;
}

void Words::fail(const std::string& reason) const { throw InvalidScene("", "line " + std::to_string(line_) + ": " + reason); }

std::string shown(std::string_view word) {
  constexpr std::size_t kMost = 40;
  return "'" + std::string(word.substr(0, kMost)) + (word.size() > kMost ? "...'" : "'");
}

}  // namespace foothold::mesh
