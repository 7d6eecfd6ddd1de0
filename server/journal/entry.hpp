// One thing that the journal is told, and the batch of them that one commit() makes durable.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "foothold/msg/cdr.hpp"
#include "foothold/msg/ids.hpp"

namespace foothold::server {

struct Entry {
  enum class Kind : std::uint8_t { kRequest = 1, kStep, kScene, kEnding };
  Kind kind = Kind::kRequest;
  msg::Id request{};
  std::int64_t number = 0;          // kRequest: when it was received; kStep: its index; kEnding: its stamp
  std::span<const std::byte> body;  // CDR: PlanRequest, Step, PlanEvent with nothing but the shapes, PlanEvent
};

// Adds an entry to the octets of a batch.
void append_entry(msg::Bytes& batch, const Entry& entry);

// Calls `visit` for each entry in the order of their writing. False if the octets are not whole entries.
bool visit_entries(std::span<const std::byte> batch, const std::function<void(const Entry&)>& visit);

// A batch that was committed: in the log, and on its way into the database.
struct Batch {
  std::uint64_t number = 0;   // from 1, without gaps
  std::uint64_t segment = 0;  // of the log
  msg::Bytes octets;
};
using BatchPointer = std::shared_ptr<const Batch>;

}  // namespace foothold::server
