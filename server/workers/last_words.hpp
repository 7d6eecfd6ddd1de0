// What a worker printed last: kept for the message of its death, and handed on line by line for the log.
#pragma once

#include <cstddef>
#include <deque>
#include <functional>
#include <string>
#include <string_view>

namespace foothold::server {

// Bounded and clean whatever is printed: long lines are cut, and of a flood only the first lines of each second are handed on.
class LastWords {
 public:
  static constexpr std::size_t kLines = 24, kLineOctets = 240, kLoggedPerSecond = 50;

  // `line` is called for each whole line to be logged.
  explicit LastWords(std::function<void(std::string_view)> line) : line_(std::move(line)) {}

  // `second`: of any steady clock, for the bound on the log.
  void hear(std::string_view text, long second);
  // The kept lines joined by " | ", an unfinished one included.
  std::string text() const;

 private:
  void finish_line(long second);

  std::function<void(std::string_view)> line_;
  std::deque<std::string> kept_;
  std::string open_;
  long second_ = -1;
  std::size_t logged_ = 0, left_out_ = 0;
};

}  // namespace foothold::server
