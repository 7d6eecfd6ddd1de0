// A journal as somebody else reads it: nothing of it is changed, whether its server runs or not. For `foothold history` and
// `foothold replay`.
//
// The log is read before the database: what the server carries over in between is then in both, never in neither.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "jobs/ports.hpp"
#include "journal/entry.hpp"
#include "sqlite/sqlite.hpp"

namespace foothold::server {

// What a batch of entries tells of requests: of the journal's log, or of a bundle.
class EntryView {
 public:
  struct Known {
    Record record;
    bool has_request = false;
    std::map<std::uint32_t, Bytes> steps;  // by their number
  };
  // Throws JournalError for octets that are no messages.
  void add(const Entry& entry);
  const std::unordered_map<Id, Known, msg::IdHash>& requests() const { return requests_; }
  const Known* find(const Id& id) const;

 private:
  std::unordered_map<Id, Known, msg::IdHash> requests_;
};

// Thread rule: one thread. All throw JournalError.
class JournalView {
 public:
  // `path`: of the database, as in SqliteJournal.
  explicit JournalView(const std::string& path);

  // The newest that `wanted` holds for, `most` of them, the newest first. Without scenes.
  std::vector<Record> latest(std::size_t most, const std::function<bool(const Record&)>& wanted);
  // With the scene's shapes.
  std::optional<Record> find(const Id& request);
  std::vector<Bytes> steps(const Id& request);

 private:
  EntryView log_;
  std::optional<sqlite::Database> database_;
  sqlite::Statement all_, one_, scene_, steps_;
};

}  // namespace foothold::server
