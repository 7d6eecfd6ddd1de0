// The server's log: sentences for people, with fields for machines.
//
// Under systemd a line goes to the journal with its fields: journalctl -u footholdd FOOTHOLD_REQUEST=0123... (also FOOTHOLD_ROBOT,
// FOOTHOLD_STATE and so on). Otherwise it goes to stderr, the fields behind the sentence:
//
//   2026-01-31T12:00:00.000Z info request ended request=0123... robot=walker state=SUCCEEDED
//
// What is said by spdlog alone goes the same way, without fields.
//
// Thread rule: any thread.
#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace foothold::server::log {

enum class Level { kDebug, kInfo, kWarn, kError };

// `name`: lower-case letters and '_'. An empty value is left out.
struct Field {
  std::string_view name;
  std::string_view value;
};

// `level`: as in footholdd.yaml. Before this everything goes to spdlog's own default.
void open(const std::string& level);
void set_level(const std::string& level);

void say(Level level, const std::string& sentence, std::span<const Field> fields);
inline void say(Level level, const std::string& sentence, std::initializer_list<Field> fields) {
  say(level, sentence, std::span<const Field>(fields.begin(), fields.size()));
}

// The latest lines as they would stand on stderr, the oldest first; kTail at most.
inline constexpr std::size_t kTail = 200;
std::vector<std::string> tail();

// " name=value name2=\"with spaces\"": values that hold more than letters, digits and ._:/+- are quoted, with \" and \\ inside.
std::string as_text(std::span<const Field> fields);
// What the journal is given: "MESSAGE=...", "PRIORITY=6", "SYSLOG_IDENTIFIER=footholdd", "FOOTHOLD_ROBOT=walker".
std::vector<std::string> as_journal_entry(Level level, std::string_view sentence, std::span<const Field> fields);

}  // namespace foothold::server::log
