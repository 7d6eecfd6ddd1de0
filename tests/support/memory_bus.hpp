// A Bus with no network: every bus made on the same MemoryNetwork sees the others. It keeps the promises of bus.hpp (partitions,
// late readers, limits of the history, one thread for all callbacks) and breaks them on demand: loss, duplicates, reordering,
// delay, full writers, servers that fall silent.
//
// Thread rule: a network and its buses may be used from any thread. Callbacks run on the network's one thread; to write inside one
// throws std::logic_error, because a real bus may deadlock there.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "foothold/transport/bus.hpp"

namespace foothold::test {

// What a topic does to its messages. Probabilities in 0..1.
struct Faults {
  double loss = 0.0;
  double duplicate = 0.0;
  double reorder = 0.0;                // held back for up to `reorder_by`
  std::chrono::microseconds delay{0};  // of every message
  std::chrono::microseconds reorder_by{2000};
  bool full = false;     // every write answers kFull
  bool stalled = false;  // nothing is delivered: what is written waits, until the history is full
};

class MemoryNetwork {
 public:
  explicit MemoryNetwork(std::uint64_t seed = 1);
  // Precondition: every bus, writer and reader of it is gone.
  ~MemoryNetwork();
  MemoryNetwork(const MemoryNetwork&) = delete;
  MemoryNetwork& operator=(const MemoryNetwork&) = delete;

  std::unique_ptr<transport::Bus> bus();
  void set_faults(transport::Topic topic, const Faults& faults);
  // Messages that writers handed over on this topic, before any fault.
  std::uint64_t written(transport::Topic topic) const;
  // Waits until nothing is under way; false after `seconds`. Stalled topics count as idle.
  bool settle(double seconds = 5.0);

  class Core;

 private:
  std::shared_ptr<Core> core_;
};

}  // namespace foothold::test
