// Hears all that the server sends to all clients, and holds it against the protocol's promises while it comes.
#pragma once

#include <foothold.h>

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>
#include <vector>

#include "foothold/msg/ids.hpp"
#include "foothold/transport/bus.hpp"

namespace foothold::faults {

// The final state of a request as it was told.
struct Final {
  std::uint32_t state = 0;
  std::uint16_t code = 0;
  std::uint32_t steps = 0;
  bool operator==(const Final&) const = default;
};

// Thread rule: any; the bus's threads fill it.
class Observer {
 public:
  Observer(const std::string& vendor, std::uint32_t domain);
  ~Observer();

  std::size_t finals() const;  // requests whose final state was heard
  std::map<msg::Id, Final> final_states() const;
  std::uint64_t events() const;
  std::uint64_t steps() const;
  // Sentences, one for each promise that was broken: two final states of a request, RUNNING told twice or behind the end, two
  // contents of one step, a step behind the count of the final state, a margin below its least.
  std::vector<std::string> complaints() const;

 private:
  struct Heard {
    bool running = false, ended = false;
    std::int64_t ended_at = 0;  // the final state's stamp
    Final end;
    std::vector<std::uint64_t> steps;  // hash of each step's octets; 0: not heard
  };
  void take(const msg::PlanEvent& event);
  void take(const msg::Step& step, std::span<const std::byte> octets);
  void complain(const msg::Id& request, const std::string& what);

  mutable std::mutex mutex_;
  std::unordered_map<msg::Id, Heard, msg::IdHash> heard_;
  std::size_t finals_ = 0;
  std::uint64_t events_ = 0, steps_ = 0;
  std::vector<std::string> complaints_;
  std::unique_ptr<transport::Bus> bus_;
  std::unique_ptr<transport::Reader> event_reader_, step_reader_;
};

}  // namespace foothold::faults
