// A ring of lines.
#include "workers/last_words.hpp"

#include "text/text.hpp"

namespace foothold::server {

void LastWords::hear(std::string_view text, long second) {
  for (const char c : text) {
    if (c == '\n') {
      finish_line(second);
    } else if (open_.size() < kLineOctets) {
      open_ += c;
    } else if (open_.size() == kLineOctets) {
      open_ += " [...]";
    }
  }
}

void LastWords::finish_line(long second) {
  open_ = cleaned(open_);
  if (second != second_) {
    if (left_out_ > 0) line_("(" + std::to_string(left_out_) + " more lines left out)");
    second_ = second;
    logged_ = left_out_ = 0;
  }
  if (++logged_ <= kLoggedPerSecond)
    line_(open_);
  else
    ++left_out_;
  kept_.push_back(std::move(open_));
  open_.clear();
  if (kept_.size() > kLines) kept_.pop_front();
}

std::string LastWords::text() const {
  std::string out;
  for (const std::string& line : kept_) out += (out.empty() ? "" : " | ") + line;
  if (!open_.empty()) out += (out.empty() ? "" : " | ") + cleaned(open_);
  return out;
}

}  // namespace foothold::server
