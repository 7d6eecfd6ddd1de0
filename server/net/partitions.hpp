// The ways to the clients: a pair of writers (events, steps) in each client's partition, opened by its first message, closed when
// it has been quiet for long, or is read by nobody, and has nothing unfinished (idl/PROTOCOL.md P1).
#pragma once

#include <functional>
#include <unordered_map>

#include "jobs/ports.hpp"
#include "net/channel.hpp"

namespace foothold::server {

// Thread rule: the loop.
class Partitions final : public Outbox {
 public:
  static constexpr auto kQuiet = std::chrono::minutes(5);
  static constexpr auto kUnread = std::chrono::seconds(30);  // the same, if nobody reads it any more
  static constexpr std::size_t kMost = 1000;                 // open at the same time; the quietest makes room for another

  struct Hooks {
    std::function<bool(const Id&)> busy;               // has this client something unfinished?
    std::function<void()> waiting;                     // something waits since now: call retry() soon
    std::function<void(const std::string&)> complain;  // for the log
  };

  Partitions(transport::Bus& bus, const Clock& clock, Hooks hooks);

  void open(const Id& client) override;
  void event(const Id& client, const msg::PlanEvent& event) override;
  void step(const Id& client, const Bytes& step) override;
  bool waits(const Id& client) const override;
  bool waits(const Id& client, const Id& request) const override;

  // Tries what waits again. True if nothing waits any more.
  bool retry();
  // Closes quiet partitions and tells of what was left out. Now and then.
  void sweep();
  // Waits until every reader has acknowledged everything, at the latest until then. Blocks.
  bool wait_acknowledged(double seconds);
  std::size_t size() const { return partitions_.size(); }
  // Readers of events and of steps that are matched now, over all partitions.
  std::pair<std::size_t, std::size_t> matched() const;
  // Messages left out since the start, as far as sweep() has told of them.
  std::uint64_t left_out() const { return left_out_; }

 private:
  struct Partition {
    Channel events, steps;
    Time last_used;
  };

  Partition* use(const Id& client);
  bool may_close(const Id& client, const Partition& partition) const;
  bool make_room();
  void send(Channel& channel, std::span<const std::byte> message);
  void tell_left_out(const Id& client, Channel& channel, const char* what);

  transport::Bus& bus_;
  const Clock& clock_;
  Hooks hooks_;
  std::unordered_map<Id, Partition, msg::IdHash> partitions_;
  Bytes buffer_;
  std::uint64_t left_out_ = 0;
};

}  // namespace foothold::server
