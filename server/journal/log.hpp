// The journal's log: batches one behind the other in files, one call of the kernel each. What append() has returned for survives
// the end of this process; a batch that was cut short by it is left out when the log is read.
//
// Segments `<path>.1`, `<path>.2` and so on: one is written, older ones are removed when the database holds what is in them.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "foothold/msg/cdr.hpp"

namespace foothold::server {

// The batches of one segment's octets, in order, as far as they are whole.
void visit_batches(std::span<const std::byte> segment, const std::function<void(std::span<const std::byte> batch)>& visit);

class Log {
 public:
  static constexpr std::uint64_t kSegmentOctets = 8u << 20;

  // Nothing is written yet.
  explicit Log(std::string path) : path_(std::move(path)) {}
  ~Log();
  Log(const Log&) = delete;
  Log& operator=(const Log&) = delete;

  // Every whole batch of the segments that are there, in order. Throws JournalError.
  void replay(const std::function<void(std::span<const std::byte> batch)>& visit) const;
  // Removes every segment and begins a new one. Throws JournalError.
  void restart();
  // Throws JournalError (disk full): then nothing of the batch is kept. Gives the number of its segment.
  std::uint64_t append(std::span<const std::byte> batch);
  // Any thread.
  void remove_before(std::uint64_t segment) const;

 private:
  void open(std::uint64_t segment);
  std::string file(std::uint64_t segment) const { return path_ + "." + std::to_string(segment); }

  std::string path_;
  std::uint64_t segment_ = 0;
  int descriptor_ = -1;
  std::uint64_t size_ = 0;  // of the segment
  msg::Bytes buffer_;
};

}  // namespace foothold::server
