// What is printed and how: colours on a terminal only, tables, complaints.
#pragma once

#include <foothold.h>

#include <cstdio>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "exit_code.hpp"

namespace foothold::cli {

// printf into a string.
[[gnu::format(printf, 1, 2)]] std::string format(const char* form, ...);

// A number with as many digits as it needs, six at most.
std::string number(double value);
// "12.3 ms", "4.2 s".
std::string duration(double seconds);

enum class Colour { kGood, kBad, kWarn, kDim, kBold };
// The text in a colour, if stdout is a terminal and NO_COLOR is not set.
std::string coloured(Colour colour, const std::string& text);
// "SUCCEEDED" in its colour.
std::string coloured(msg::State state);

// Columns as wide as their widest cell; the last one is not padded. Characters count, not octets.
void print_table(const std::vector<std::vector<std::string>>& rows, std::string_view indent = "");

// Text without control characters, so that what a server or a file says cannot steer the terminal.
std::string printable(std::string_view text);

// An end of a command that is no success: what happened, what to do, exit code.
class Complaint : public std::runtime_error {
 public:
  Complaint(Exit code, const std::string& message, std::string advice = {})
      : std::runtime_error(message), code_(code), advice_(std::move(advice)) {}
  Exit code() const noexcept { return code_; }
  const std::string& advice() const noexcept { return advice_; }

 private:
  Exit code_;
  std::string advice_;
};

// "foothold: message" and "  what to do" to stderr.
void print(const Complaint& complaint);

// An error of the protocol, over several lines: name, field, message, hint.
void print(const msg::Error& error, std::FILE* out);

}  // namespace foothold::cli
