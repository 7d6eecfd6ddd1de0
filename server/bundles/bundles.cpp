// Making bundles and keeping their number.
#include "bundles/bundles.hpp"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <vector>

#include "bundles/report.hpp"
#include "foothold/msg/errors.hpp"
#include "foothold/msg/times.hpp"
#include "journal/view.hpp"
#include "log/log.hpp"

namespace foothold::server {
namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kLeastFree = 64u << 20;  // octets

std::string folder_name(const Incident& incident) {
  const std::int64_t stamp = incident.end.stamp();
  char milliseconds[8];
  std::snprintf(milliseconds, sizeof milliseconds, ".%03d-", static_cast<int>(stamp / 1'000'000 % 1000));
  return msg::utc_text(stamp / 1'000'000'000, "%Y%m%dT%H%M%S") + milliseconds + msg::to_hex(incident.request.id());
}

// Request, scene, steps and end; the steps as the journal holds them, if it can be read.
msg::Bytes entries_of(const Incident& incident, const std::string& journal) {
  const Id& id = incident.request.id();
  msg::Bytes entries;
  append_entry(entries, {Entry::Kind::kRequest, id, incident.end.stamp(), msg::encode(incident.request)});
  try {
    const auto steps = JournalView(journal).steps(id);
    for (std::size_t i = 0; i < steps.size(); ++i)
      append_entry(entries, {Entry::Kind::kStep, id, static_cast<std::int64_t>(i), steps[i]});
  } catch (const JournalError&) {
    // The report and the request are worth having without them.
  }
  append_entry(entries, {Entry::Kind::kEnding, id, incident.end.stamp(), msg::encode(incident.end)});
  return entries;
}

void write(const fs::path& file, const void* octets, std::size_t size) {
  std::ofstream out(file, std::ios::binary);
  out.write(static_cast<const char*>(octets), static_cast<std::streamsize>(size));
  out.close();
  if (!out) throw std::runtime_error(file.string() + ": cannot be written");
}

// Names begin with the time. What a server before left half-made goes too.
void keep_newest(const fs::path& folder, std::size_t most) {
  std::vector<fs::path> bundles;
  for (const auto& entry : fs::directory_iterator(folder)) bundles.push_back(entry.path());
  std::ranges::sort(bundles, std::greater{});
  for (std::size_t i = most; i < bundles.size(); ++i) fs::remove_all(bundles[i]);
}

// Gives the bundle's folder. Throws std::exception.
std::string make(const Incident& incident, const fs::path& folder, const std::string& journal, std::size_t most) {
  const fs::path place = folder / folder_name(incident), part = place.string() + ".part";
  fs::create_directories(folder);
  // The journal is on the same disk, and goes before.
  if (fs::space(folder).available < kLeastFree) throw std::runtime_error(folder.string() + ": less than 64 MiB are free");
  fs::create_directory(part);
  try {
    const std::string report = report_of(incident);
    write(part / "report.txt", report.data(), report.size());
    const msg::Bytes entries = entries_of(incident, journal);
    write(part / "plan.entries", entries.data(), entries.size());
    fs::rename(part, place);
  } catch (const std::exception&) {
    std::error_code ignored;
    fs::remove_all(part, ignored);
    throw;
  }
  keep_newest(folder, most);
  return place.string();
}

}  // namespace

Bundles::Bundles(std::string folder, std::string journal, std::string server, BundlesConfig config, Hooks hooks)
    : folder_(std::move(folder)),
      journal_(std::move(journal)),
      server_(std::move(server)),
      config_(config),
      hooks_(std::move(hooks)) {}

void Bundles::on_ended(const EndedRequest& ended) {
  const bool crashed = ended.event.state() == msg::CRASHED || ended.killed;
  const bool slow = ended.ran && config_.slow > 0.0 && ended.planned >= config_.slow;
  if (config_.keep == 0 || (!crashed && !slow)) return;
  if (waiting_ >= kMostWaiting) {
    if (left_out_++ == 0) hooks_.complain("too many plans crash or are slow at once: some get no bundle");
    return;
  }
  auto incident = std::make_shared<Incident>();
  incident->request = ended.request;
  incident->end = ended.event;
  incident->server = server_;
  incident->waited = ended.waited;
  incident->planned = ended.planned;
  incident->log = log::tail();
  incident->why = ended.killed ? "its worker had to be killed: it did not heed its stop token"
                  : ended.event.state() == msg::CRASHED
                      ? "its worker died"
                      : "the plan took longer than bundles.slow, " + std::to_string(config_.slow) + " s";
  struct Outcome {
    std::string place, fault;
  };
  const auto outcome = std::make_shared<Outcome>();
  ++waiting_;
  const auto work = [incident, outcome, folder = fs::path(folder_) / (crashed ? "crashed" : "slow"), journal = journal_,
                     most = config_.keep] {
    try {
      outcome->place = make(*incident, folder, journal, most);
    } catch (const std::exception& error) {
      outcome->fault = error.what();
    }
  };
  hooks_.background(work, [this, outcome, alive = std::weak_ptr(alive_)] {
    if (alive.expired()) return;
    --waiting_;
    if (outcome->fault.empty())
      hooks_.tell(outcome->place);
    else
      hooks_.complain("no bundle of a plan: " + outcome->fault);
    if (waiting_ == 0 && left_out_ > 0) hooks_.complain(std::to_string(std::exchange(left_out_, 0)) + " plans got no bundle");
  });
}

}  // namespace foothold::server
