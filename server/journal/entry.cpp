// Entries to octets and back. Little endian on every machine that this runs on; the log never leaves its machine.
#include "journal/entry.hpp"

#include <cstring>

namespace foothold::server {
namespace {

struct Header {
  std::uint64_t size;  // of the body
  std::int64_t number;
  msg::Id request;
  Entry::Kind kind;
};

}  // namespace

void append_entry(msg::Bytes& batch, const Entry& entry) {
  Header header{};
  header.size = entry.body.size();
  header.number = entry.number;
  header.request = entry.request;
  header.kind = entry.kind;
  const std::size_t begin = batch.size();
  batch.resize(begin + sizeof header + entry.body.size());
  std::memcpy(batch.data() + begin, &header, sizeof header);
  if (!entry.body.empty()) std::memcpy(batch.data() + begin + sizeof header, entry.body.data(), entry.body.size());
}

bool visit_entries(std::span<const std::byte> batch, const std::function<void(const Entry&)>& visit) {
  while (!batch.empty()) {
    Header header{};
    if (batch.size() < sizeof header) return false;
    std::memcpy(&header, batch.data(), sizeof header);
    batch = batch.subspan(sizeof header);
    if (header.size > batch.size() || header.kind < Entry::Kind::kRequest || header.kind > Entry::Kind::kEnding) return false;
    visit({header.kind, header.request, header.number, batch.first(static_cast<std::size_t>(header.size))});
    batch = batch.subspan(static_cast<std::size_t>(header.size));
  }
  return true;
}

}  // namespace foothold::server
