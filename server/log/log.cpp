// One sink of spdlog for both ways.
#include "log/log.hpp"

#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/base_sink.h>
#include <spdlog/spdlog.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <systemd/sd-journal.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <deque>
#include <mutex>

namespace foothold::server::log {
namespace {

// Of the line that this thread is saying: spdlog carries none.
thread_local std::span<const Field> fields_of_line;

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
         std::string_view("._:/+-").find(c) != std::string_view::npos;
}

// stderr leads to systemd's journal: JOURNAL_STREAM names it by device and inode (systemd.exec(5)).
bool is_journal() {
  const char* stream = std::getenv("JOURNAL_STREAM");
  struct stat error {};
  if (stream == nullptr || fstat(STDERR_FILENO, &error) != 0) return false;
  return std::to_string(error.st_dev) + ":" + std::to_string(error.st_ino) == stream;
}

Level level_of(spdlog::level::level_enum level) {
  if (level <= spdlog::level::debug) return Level::kDebug;
  if (level == spdlog::level::info) return Level::kInfo;
  return level == spdlog::level::warn ? Level::kWarn : Level::kError;
}

spdlog::level::level_enum spdlog_level(Level level) {
  constexpr spdlog::level::level_enum kLevels[] = {spdlog::level::debug, spdlog::level::info, spdlog::level::warn,
                                                   spdlog::level::err};
  return kLevels[static_cast<std::size_t>(level)];
}

class Sink final : public spdlog::sinks::base_sink<std::mutex> {
 public:
  Sink() : journal_(is_journal()) {}

  std::vector<std::string> tail() {
    const std::lock_guard lock(mutex_);
    return {tail_.begin(), tail_.end()};
  }

 private:
  void sink_it_(const spdlog::details::log_msg& message) override {
    spdlog::memory_buf_t formatted;
    formatter_->format(message, formatted);
    std::string line(formatted.data(), formatted.size());
    while (!line.empty() && line.back() == '\n') line.pop_back();
    line += as_text(fields_of_line);
    tail_.push_back(line);
    if (tail_.size() > kTail) tail_.pop_front();
    const std::string_view sentence(message.payload.data(), message.payload.size());
    if (journal_ && to_journal(level_of(message.level), sentence)) return;
    line += '\n';
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, line.data(), line.size());
  }
  void flush_() override {}

  static bool to_journal(Level level, std::string_view sentence) {
    const auto entry = as_journal_entry(level, sentence, fields_of_line);
    std::vector<iovec> parts;
    for (const std::string& field : entry) parts.push_back({const_cast<char*>(field.data()), field.size()});
    return sd_journal_sendv(parts.data(), static_cast<int>(parts.size())) == 0;
  }

  const bool journal_;
  std::deque<std::string> tail_;
};

std::shared_ptr<Sink> the_sink;

}  // namespace

void open(const std::string& level) {
  the_sink = std::make_shared<Sink>();
  auto log = std::make_shared<spdlog::logger>("footholdd", the_sink);
  log->set_pattern("%Y-%m-%dT%H:%M:%S.%eZ %l %v", spdlog::pattern_time_type::utc);
  log->set_level(spdlog::level::from_str(level));
  spdlog::set_default_logger(log);
}

void set_level(const std::string& level) { spdlog::set_level(spdlog::level::from_str(level)); }

void say(Level level, const std::string& sentence, std::span<const Field> fields) {
  fields_of_line = fields;
  spdlog::log(spdlog_level(level), "{}", sentence);
  fields_of_line = {};
}

std::vector<std::string> tail() { return the_sink ? the_sink->tail() : std::vector<std::string>{}; }

std::string as_text(std::span<const Field> fields) {
  std::string text;
  for (const Field& field : fields) {
    if (field.value.empty()) continue;
    text += ' ';
    text += field.name;
    text += '=';
    const bool plain = std::ranges::all_of(field.value, is_plain);
    if (!plain) text += '"';
    for (const char c : field.value) {
      if (c == '"' || c == '\\') text += '\\';
      text += c == '\n' ? ' ' : c;
    }
    if (!plain) text += '"';
  }
  return text;
}

std::vector<std::string> as_journal_entry(Level level, std::string_view sentence, std::span<const Field> fields) {
  constexpr const char* kPriorities[] = {"PRIORITY=7", "PRIORITY=6", "PRIORITY=4", "PRIORITY=3"};
  std::vector<std::string> entry = {"MESSAGE=" + std::string(sentence), kPriorities[static_cast<std::size_t>(level)],
                                    "SYSLOG_IDENTIFIER=footholdd"};
  for (const Field& field : fields) {
    if (field.value.empty()) continue;
    std::string line = "FOOTHOLD_";
    for (const char c : field.name) line += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    entry.push_back(line + "=" + std::string(field.value));
  }
  return entry;
}

}  // namespace foothold::server::log
