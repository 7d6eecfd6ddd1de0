// Reading a journal without touching it.
#include "journal/view.hpp"

#include <sqlite3.h>

#include <algorithm>

#include "journal/log.hpp"
#include "journal/reads.hpp"
#include "journal/store.hpp"

namespace foothold::server {
namespace {

constexpr std::uint32_t kMostSteps = 1U << 20;

// In this order: received, request, end, number of the last step.
constexpr const char* kColumns =
    "SELECT r.received, r.body, e.event, (SELECT max(number) FROM step WHERE request = r.row) FROM request r LEFT JOIN ending e ON "
    "e.row = r.row ";

template <class Message>
Message decoded(std::span<const std::byte> bytes) {
  auto message = msg::decode<Message>(bytes);
  if (!message) throw JournalError("an entry of the journal cannot be read: it is damaged, or of another version of foothold");
  return std::move(*message);
}

Record row_of(const sqlite::Statement& row) {
  Record record{.request = decoded<msg::PlanRequest>(row.bytes(1)), .received = row.integer(0)};
  if (!row.is_null(2)) record.final_event = decoded<msg::PlanEvent>(row.bytes(2));
  if (!row.is_null(3)) record.steps = static_cast<std::uint32_t>(row.integer(3) + 1);
  return record;
}

// A server may remove a segment between the look at the folder and at the file: what was in it is in the database then.
EntryView log_of(const std::string& path) {
  for (int tries = 1;; ++tries) {
    try {
      EntryView view;
      Log(path + "-log").replay([&](std::span<const std::byte> batch) {
        visit_entries(batch, [&](const Entry& entry) { view.add(entry); });
      });
      return view;
    } catch (const JournalError&) {
      if (tries == 5) throw;
    }
  }
}

// The database as it is at the first look, whatever its server carries over meanwhile.
class Snapshot {
 public:
  explicit Snapshot(sqlite::Database& database) : database_(database) { database_.run("BEGIN"); }
  ~Snapshot() {
    if (database_.in_transaction()) sqlite3_exec(database_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
  }
  Snapshot(const Snapshot&) = delete;
  Snapshot& operator=(const Snapshot&) = delete;

 private:
  sqlite::Database& database_;
};

// What the log knows beyond the database.
void complete(Record& record, const EntryView::Known* known) {
  if (known == nullptr) return;
  if (!record.final_event) record.final_event = known->record.final_event;
  if (record.scene.empty()) record.scene = known->record.scene;
  record.steps = std::max(record.steps, known->record.steps);
}

}  // namespace

void EntryView::add(const Entry& entry) {
  Known& known = requests_[entry.request];
  switch (entry.kind) {
    case Entry::Kind::kRequest:
      known.record.request = decoded<msg::PlanRequest>(entry.body);
      known.record.received = entry.number;
      known.has_request = true;
      return;
    case Entry::Kind::kStep: {
      if (entry.number < 0 || entry.number >= kMostSteps)
        throw JournalError("an entry of the journal is damaged: its step's number");
      const auto index = static_cast<std::uint32_t>(entry.number);
      known.record.steps = std::max(known.record.steps, index + 1);
      known.steps[index].assign(entry.body.begin(), entry.body.end());
      return;
    }
    case Entry::Kind::kScene:
      known.record.scene = std::move(decoded<msg::PlanEvent>(entry.body).scene());
      return;
    case Entry::Kind::kEnding:
      known.record.final_event = decoded<msg::PlanEvent>(entry.body);
      return;
  }
}

const EntryView::Known* EntryView::find(const Id& id) const {
  const auto found = requests_.find(id);
  return found == requests_.end() ? nullptr : &found->second;
}

JournalView::JournalView(const std::string& path) {
  log_ = log_of(path);
  reading([&] {
    database_.emplace(path, sqlite::Database::Access::kRead);
    const std::int64_t version = database_->integer("PRAGMA user_version");
    if (version != Store::kSchemaVersion)
      throw JournalError(path + ": has schema version " + std::to_string(version) + ", this program reads version " +
                         std::to_string(Store::kSchemaVersion));
    all_ = database_->prepare(std::string(kColumns) + "ORDER BY r.row DESC");
    one_ = database_->prepare(std::string(kColumns) + "WHERE r.id = ?");
    scene_ = database_->prepare("SELECT event FROM scene WHERE row = (SELECT row FROM request WHERE id = ?)");
    steps_ = database_->prepare("SELECT body FROM step WHERE request = (SELECT row FROM request WHERE id = ?) ORDER BY number");
  });
}

std::vector<Record> JournalView::latest(std::size_t most, const std::function<bool(const Record&)>& wanted) {
  std::vector<Record> found;
  std::vector<Record> only_in_log;
  reading([&] {
    const Snapshot snapshot(*database_);
    for (const auto& [id, known] : log_.requests()) {
      if (!known.has_request) continue;
      const sqlite::Reset reset(one_);
      if (!one_.bind(1, std::span<const std::uint8_t>(id)).step()) only_in_log.push_back(known.record);
    }
    std::ranges::sort(only_in_log, std::greater{}, &Record::received);
    for (Record& record : only_in_log)
      if (found.size() < most && wanted(record)) found.push_back(std::move(record));
    const sqlite::Reset reset(all_);
    while (found.size() < most && all_.step()) {
      Record record = row_of(all_);
      complete(record, log_.find(record.request.id()));
      if (wanted(record)) found.push_back(std::move(record));
    }
  });
  return found;
}

std::optional<Record> JournalView::find(const Id& request) {
  return reading([&]() -> std::optional<Record> {
    const auto* known = log_.find(request);
    const sqlite::Reset reset(one_), reset_scene(scene_);
    if (!one_.bind(1, std::span<const std::uint8_t>(request)).step())
      return known != nullptr && known->has_request ? std::optional(known->record) : std::nullopt;
    Record record = row_of(one_);
    if (scene_.bind(1, std::span<const std::uint8_t>(request)).step())
      record.scene = std::move(decoded<msg::PlanEvent>(scene_.bytes(0)).scene());
    complete(record, known);
    return record;
  });
}

std::vector<Bytes> JournalView::steps(const Id& request) {
  return reading([&] {
    std::vector<Bytes> steps;
    const sqlite::Reset reset(steps_);
    steps_.bind(1, std::span<const std::uint8_t>(request));
    while (steps_.step()) {
      const auto bytes = steps_.bytes(0);
      steps.emplace_back(bytes.begin(), bytes.end());
    }
    const auto* known = log_.find(request);
    if (known != nullptr)
      for (auto next = known->steps.find(static_cast<std::uint32_t>(steps.size()));
           next != known->steps.end() && next->first == steps.size(); ++next)
        steps.push_back(next->second);
    return steps;
  });
}

}  // namespace foothold::server
