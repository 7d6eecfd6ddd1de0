// Printing.
#include "terminal.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdlib>

#include "foothold/msg/errors.hpp"

namespace foothold::cli {
namespace {

bool colours_on() {
  static const bool on = [] {
    const char* no_colour = std::getenv("NO_COLOR");
    const char* kind = std::getenv("TERM");
    return isatty(STDOUT_FILENO) == 1 && (no_colour == nullptr || *no_colour == '\0') &&
           (kind == nullptr || std::string_view(kind) != "dumb");
  }();
  return on;
}

const char* code_of(Colour colour) {
  switch (colour) {
    case Colour::kGood:
      return "32";
    case Colour::kBad:
      return "31";
    case Colour::kWarn:
      return "33";
    case Colour::kDim:
      return "2";
    case Colour::kBold:
      return "1";
  }
  return "0";
}

// What a cell takes on the screen: UTF-8's continuation octets and colour sequences take nothing.
std::size_t width(std::string_view text) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\033')
      i = std::min(text.find('m', i), text.size());
    else if ((static_cast<unsigned char>(text[i]) & 0xC0) != 0x80)
      ++count;
  }
  return count;
}

}  // namespace

std::string format(const char* form, ...) {
  va_list arguments, again;
  va_start(arguments, form);
  va_copy(again, arguments);
  std::string text(static_cast<std::size_t>(std::vsnprintf(nullptr, 0, form, arguments)), '\0');
  std::vsnprintf(text.data(), text.size() + 1, form, again);
  va_end(again);
  va_end(arguments);
  return text;
}

std::string number(double value) { return format("%.6g", value == 0.0 ? 0.0 : value); }

std::string duration(double seconds) {
  if (std::abs(seconds) < 1e-3) return format("%.0f us", seconds * 1e6);
  if (std::abs(seconds) < 1.0) return format("%.1f ms", seconds * 1e3);
  return format("%.2f s", seconds);
}

std::string coloured(Colour colour, const std::string& text) {
  return colours_on() ? format("\033[%sm", code_of(colour)) + text + "\033[0m" : text;
}

std::string coloured(msg::State state) {
  const std::string name(msg::state_name(state));
  if (state == msg::SUCCEEDED) return coloured(Colour::kGood, name);
  if (state == msg::PARTIAL || state == msg::CANCELLED || state == msg::EXPIRED) return coloured(Colour::kWarn, name);
  return msg::is_final(state) ? coloured(Colour::kBad, name) : coloured(Colour::kBold, name);
}

void print_table(const std::vector<std::vector<std::string>>& rows, std::string_view indent) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()), 0);
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width(row[i]));
  }
  for (const auto& row : rows) {
    std::string line(indent);
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += row[i];
      if (i + 1 < row.size()) line.append(widths[i] - width(row[i]) + 2, ' ');
    }
    line.erase(line.find_last_not_of(' ') + 1);
    std::puts(line.c_str());
  }
}

std::string printable(std::string_view text) {
  std::string clean;
  for (const char c : text) clean += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
  return clean;
}

void print(const Complaint& complaint) {
  std::fflush(stdout);
  std::fprintf(stderr, "foothold: %s\n", complaint.what());
  if (!complaint.advice().empty()) std::fprintf(stderr, "  %s\n", complaint.advice().c_str());
}

void print(const msg::Error& error, std::FILE* out) {
  // Many messages begin with the field themselves.
  const bool named = error.field().empty() || error.message().starts_with(error.field());
  const std::string field = named ? "" : printable(error.field()) + ": ";
  std::fprintf(out, "%s: %s%s\n", printable(error.name()).c_str(), field.c_str(), printable(error.message()).c_str());
  if (error.retry_after() > 0.0) std::fprintf(out, "  try again in %s\n", duration(error.retry_after()).c_str());
  if (!error.hint().empty()) std::fprintf(out, "  %s\n", printable(error.hint()).c_str());
}

}  // namespace foothold::cli
