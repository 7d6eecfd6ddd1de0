// See attacks.hpp.
#include "attacks.hpp"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <initializer_list>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string_view>

namespace foothold::test {
namespace {

std::vector<std::string> lines_of(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

// A line of its own among those of the vendors, whose threads speak until the end: the first that begins with one of these.
std::string line_of(const std::filesystem::path& path, std::initializer_list<std::string_view> beginnings) {
  for (const std::string& line : lines_of(path))
    if (std::ranges::any_of(beginnings, [&](std::string_view begin) { return line.starts_with(begin); })) return line;
  return {};
}

std::string begin_of(const std::filesystem::path& path) { return line_of(path, {"opened", "refused at home"}); }

}  // namespace

Attacker::Attacker(const AttackerOptions& options, const std::vector<Victim>& victims, const std::filesystem::path& output)
    : options_(options), output_(output) {
  std::vector<std::string> command{
      FOOTHOLD_ATTACKER, options.vendor,  std::to_string(options.domain), options.credentials.empty() ? "-" : options.credentials,
      options.acts,      msg::to_hex(id_)};
  for (const Victim& victim : victims) command.push_back(victim.partition + ":" + msg::to_hex(victim.request));
  child_ = std::make_unique<Child>(command, output);
}

bool Attacker::begun() const { return !begin_of(output_).empty(); }

Outcome Attacker::finish() {
  child_->signal(SIGTERM);
  const auto code = child_->wait(20.0);
  Outcome outcome;
  outcome.attack = options_.attack;
  outcome.attacker = options_.vendor;
  outcome.note = begin_of(output_);
  std::istringstream figures(line_of(output_, {"in all:"}));
  figures.ignore(std::numeric_limits<std::streamsize>::max(), ':');
  if (!code || *code != 0 || !(figures >> outcome.steps >> outcome.events >> outcome.requests >> outcome.sent))
    throw std::runtime_error(options_.attack + " by " + options_.vendor + ": the attacker ended with " +
                             (code ? std::to_string(*code) : "nothing") + ", having begun so: " + outcome.note);
  return outcome;
}

void print_table(const std::vector<Outcome>& rows) {
  std::printf("%-38s %-8s %-8s %8s %6s %6s %7s %9s %7s\n", "attack", "server", "attacker", "sent", "plans", "steps", "events",
              "requests", "forged");
  for (const Outcome& row : rows)
    std::printf("%-38s %-8s %-8s %8u %6u %6u %7u %9u %7u%s\n", row.attack.c_str(), row.server.c_str(), row.attacker.c_str(),
                row.sent, row.plans, row.steps, row.events, row.requests, row.forged,
                row.note.starts_with("refused") ? "  (refused by its own library)" : "");
}

}  // namespace foothold::test
