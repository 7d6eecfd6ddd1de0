// The journal on disk.
#include "journal/journal.hpp"

#include "journal/reads.hpp"

namespace foothold::server {
namespace {

constexpr std::size_t kMostRecent = 256u << 20;  // octets that may wait for the database

template <class Message>
Message decoded(const Entry& entry) {
  auto message = msg::decode<Message>(entry.body);
  if (!message) throw JournalError("an entry of the journal's log cannot be read");
  return std::move(*message);
}

}  // namespace

SqliteJournal::SqliteJournal(const std::string& path) : log_(path + "-log") {
  auto writer = std::make_unique<Store>(path);
  reading([&] {
    replay(*writer);
    writer->visit_ids([&](const Id& id) { known_ids_.add(id); });
  });
  log_.restart();
  reader_ = std::make_unique<Store>(path);
  carrier_ = std::make_unique<Carrier>(std::move(writer), log_);
}

SqliteJournal::~SqliteJournal() = default;

void SqliteJournal::replay(Store& store) {
  store.begin();
  log_.replay([&](std::span<const std::byte> batch) { visit_entries(batch, [&](const Entry& entry) { store.apply(entry); }); });
  store.commit();
}

void SqliteJournal::add_request(const msg::PlanRequest& request, Stamp received) {
  msg::encode_into(request, buffer_);
  append_entry(open_, {Entry::Kind::kRequest, request.id(), received, buffer_});
  open_requests_.push_back(request.id());
  recent_requests_.emplace(request.id(), last_number_ + 1);
}

void SqliteJournal::add_step(const Id& request, std::uint32_t index, const Bytes& step) {
  append_entry(open_, {Entry::Kind::kStep, request, index, step});
}

// Kept as an event that carries nothing but the shapes: a message has a form of its own on disk, a sequence has not.
void SqliteJournal::set_scene(const Id& request, const std::vector<msg::Shape>& shapes) {
  msg::PlanEvent event;
  event.scene(shapes);
  msg::encode_into(event, buffer_);
  append_entry(open_, {Entry::Kind::kScene, request, 0, buffer_});
}

void SqliteJournal::set_final(const Id& request, const msg::PlanEvent& event) {
  msg::encode_into(event, buffer_);
  append_entry(open_, {Entry::Kind::kEnding, request, event.stamp(), buffer_});
}

void SqliteJournal::commit() {
  if (open_.empty()) return;
  let_go();
  try {
    if (recent_octets_ + open_.size() > kMostRecent)
      throw JournalError("the database is too far behind the log: " + carrier_->trouble());
    const auto batch = std::make_shared<Batch>();
    batch->segment = log_.append(open_);
    batch->number = ++last_number_;
    batch->octets.swap(open_);
    recent_octets_ += batch->octets.size();
    recent_.push_back(batch);
    carrier_->push(batch);
  } catch (const JournalError&) {
    for (const Id& id : open_requests_) recent_requests_.erase(id);
    open_.clear();
    open_requests_.clear();
    throw;
  }
  for (const Id& id : open_requests_) known_ids_.add(id);
  open_requests_.clear();
}

// Lets go of batches that the database holds by now: before every look at it, so that what it forgot does not come back from them.
void SqliteJournal::let_go() {
  const std::uint64_t carried = carrier_->carried();
  if (recent_.empty() || recent_.front()->number > carried) return;
  while (!recent_.empty() && recent_.front()->number <= carried) {
    recent_octets_ -= recent_.front()->octets.size();
    recent_.pop_front();
  }
  std::erase_if(recent_requests_, [&](const auto& entry) { return entry.second <= carried; });
}

template <class Visit>
void SqliteJournal::visit_recent(const Id& request, Visit&& visit) const {
  const auto look = [&](const Entry& entry) {
    if (entry.request == request) visit(entry);
  };
  for (const BatchPointer& batch : recent_) visit_entries(batch->octets, look);
  visit_entries(open_, look);
}

bool SqliteJournal::knows(const Id& request) {
  let_go();
  if (recent_requests_.contains(request)) return true;
  if (!known_ids_.may_contain(request)) return false;
  return reading([&] { return reader_->knows(request); });
}

std::optional<Record> SqliteJournal::find(const Id& request) {
  let_go();
  auto record = reading([&] { return reader_->find(request); });
  visit_recent(request, [&](const Entry& entry) {
    if (entry.kind == Entry::Kind::kRequest) {
      if (!record) record.emplace(Record{.request = decoded<msg::PlanRequest>(entry), .received = entry.number});
      return;
    }
    if (!record) return;
    if (entry.kind == Entry::Kind::kStep)
      record->steps = std::max(record->steps, static_cast<std::uint32_t>(entry.number + 1));
    else if (entry.kind == Entry::Kind::kScene)
      record->scene = std::move(decoded<msg::PlanEvent>(entry).scene());
    else
      record->final_event = decoded<msg::PlanEvent>(entry);
  });
  return record;
}

std::vector<Bytes> SqliteJournal::steps(const Id& request, std::uint32_t from, std::uint32_t most) {
  let_go();
  auto steps = reading([&] { return reader_->steps(request, from, most); });
  visit_recent(request, [&](const Entry& entry) {
    if (steps.size() < most && entry.kind == Entry::Kind::kStep && entry.number == static_cast<std::int64_t>(from + steps.size()))
      steps.emplace_back(entry.body.begin(), entry.body.end());
  });
  return steps;
}

std::vector<Record> SqliteJournal::unfinished() {
  commit();
  if (!carrier_->wait_carried(last_number_)) throw JournalError(carrier_->trouble());
  return reading([&] { return reader_->unfinished(); });
}

bool SqliteJournal::forget_before(Stamp stamp) {
  carrier_->forget_before(stamp);
  return false;
}

}  // namespace foothold::server
