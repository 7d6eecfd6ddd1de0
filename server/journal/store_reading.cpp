// The journal's database: reading.
#include "journal/store.hpp"

namespace foothold::server {
namespace {

template <class Message>
Message decoded(std::span<const std::byte> bytes, const std::string& what) {
  auto message = msg::decode<Message>(bytes);
  if (!message) throw JournalError("the journal is damaged: " + what + " cannot be read");
  return std::move(*message);
}

}  // namespace

std::optional<Store::Row> Store::row_of(const Id& request) {
  if (const auto known = rows_.find(request); known != rows_.end()) return known->second;
  const sqlite::Reset reset(sql_.row_of);
  sql_.row_of.bind(1, std::span<const std::uint8_t>(request));
  if (!sql_.row_of.step()) return std::nullopt;
  return sql_.row_of.integer(0);
}

bool Store::knows(const Id& request) { return row_of(request).has_value(); }

std::optional<Record> Store::find(const Id& request) {
  const auto row = row_of(request);
  return row ? record(*row) : std::nullopt;
}

// Nothing if it was forgotten just now.
std::optional<Record> Store::record(Row row) {
  const std::string name = "request row " + std::to_string(row);
  Record record;
  {
    const sqlite::Reset reset(sql_.request);
    if (!sql_.request.bind(1, row).step()) return std::nullopt;
    record.received = sql_.request.integer(0);
    record.request = decoded<msg::PlanRequest>(sql_.request.bytes(1), name);
  }
  {
    const sqlite::Reset reset(sql_.ending);
    if (sql_.ending.bind(1, row).step()) record.final_event = decoded<msg::PlanEvent>(sql_.ending.bytes(0), "the end of " + name);
  }
  {
    const sqlite::Reset reset(sql_.scene);
    if (sql_.scene.bind(1, row).step())
      record.scene = std::move(decoded<msg::PlanEvent>(sql_.scene.bytes(0), "the scene of " + name).scene());
  }
  const sqlite::Reset reset(sql_.last_step);
  if (sql_.last_step.bind(1, row).step() && !sql_.last_step.is_null(0))
    record.steps = static_cast<std::uint32_t>(sql_.last_step.integer(0) + 1);
  return record;
}

std::vector<Bytes> Store::steps(const Id& request, std::uint32_t from, std::uint32_t most) {
  std::vector<Bytes> steps;
  const auto row = row_of(request);
  if (!row) return steps;
  const sqlite::Reset reset(sql_.steps);
  sql_.steps.bind(1, *row).bind(2, std::int64_t{from}).bind(3, std::int64_t{most});
  while (sql_.steps.step()) {
    const auto bytes = sql_.steps.bytes(0);
    steps.emplace_back(bytes.begin(), bytes.end());
  }
  return steps;
}

std::vector<Record> Store::unfinished() {
  std::vector<Row> rows;
  {
    const sqlite::Reset reset(sql_.unfinished);
    while (sql_.unfinished.step()) rows.push_back(sql_.unfinished.integer(0));
  }
  std::vector<Record> records;
  for (const Row row : rows)
    if (auto found = record(row)) records.push_back(std::move(*found));
  return records;
}

void Store::visit_ids(const std::function<void(const Id&)>& visit) {
  const sqlite::Reset reset(sql_.ids);
  while (sql_.ids.step()) {
    const auto bytes = sql_.ids.bytes(0);
    Id id{};
    if (bytes.size() != id.size()) continue;
    for (std::size_t i = 0; i < id.size(); ++i) id[i] = std::to_integer<std::uint8_t>(bytes[i]);
    visit(id);
  }
}

}  // namespace foothold::server
