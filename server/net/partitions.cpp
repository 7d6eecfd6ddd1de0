// Writers per client.
#include "net/partitions.hpp"

#include <algorithm>
#include <vector>

namespace foothold::server {

using transport::Topic;

Partitions::Partitions(transport::Bus& bus, const Clock& clock, Hooks hooks) : bus_(bus), clock_(clock), hooks_(std::move(hooks)) {}

void Partitions::open(const Id& client) { use(client); }

// Nothing if it cannot be opened: the client asks again, and finds out then.
Partitions::Partition* Partitions::use(const Id& client) {
  const Time now = clock_.now();
  if (const auto found = partitions_.find(client); found != partitions_.end()) {
    found->second.last_used = now;
    return &found->second;
  }
  if (partitions_.size() >= kMost && !make_room()) {
    hooks_.complain("client " + msg::to_hex(client) + " gets no answer: " + std::to_string(kMost) +
                    " partitions are open already, and each has something unfinished");
    return nullptr;
  }
  try {
    const std::string name = msg::to_hex(client);
    Partition partition{Channel(bus_.writer(Topic::kEvent, name)), Channel(bus_.writer(Topic::kStep, name)), now};
    return &partitions_.emplace(client, std::move(partition)).first->second;
  } catch (const transport::BusError& error) {
    hooks_.complain("client " + msg::to_hex(client) + " gets no answer: " + error.what());
    return nullptr;
  }
}

bool Partitions::may_close(const Id& client, const Partition& partition) const {
  return !partition.events.waits() && !partition.steps.waits() && !hooks_.busy(client);
}

// Closes the one that has been quiet the longest.
bool Partitions::make_room() {
  std::vector<std::pair<Time, Id>> by_use;
  for (const auto& [client, partition] : partitions_) by_use.emplace_back(partition.last_used, client);
  std::ranges::sort(by_use);
  for (const auto& [time, client] : by_use) {
    if (!may_close(client, partitions_.at(client))) continue;
    partitions_.erase(client);
    return true;
  }
  return false;
}

void Partitions::event(const Id& client, const msg::PlanEvent& event) {
  Partition* partition = use(client);
  if (partition == nullptr) return;
  msg::encode_into(event, buffer_);
  send(partition->events, buffer_);
}

void Partitions::step(const Id& client, const Bytes& step) {
  if (Partition* partition = use(client)) send(partition->steps, step);
}

bool Partitions::waits(const Id& client) const {
  const auto found = partitions_.find(client);
  return found != partitions_.end() && found->second.steps.waits();
}

bool Partitions::waits(const Id& client, const Id& request) const {
  const auto found = partitions_.find(client);
  return found != partitions_.end() && found->second.steps.waits_of(request);
}

void Partitions::send(Channel& channel, std::span<const std::byte> message) {
  const bool waited = channel.waits();
  channel.send(message);
  if (!waited && channel.waits()) hooks_.waiting();
}

bool Partitions::retry() {
  bool done = true;
  for (auto& [client, partition] : partitions_) {
    done = partition.events.retry() && done;
    done = partition.steps.retry() && done;
  }
  return done;
}

void Partitions::tell_left_out(const Id& client, Channel& channel, const char* what) {
  std::string why;
  const auto count = channel.take_left_out(why);
  left_out_ += count;
  if (count != 0)
    hooks_.complain(std::to_string(count) + " " + what + " for client " + msg::to_hex(client) + " were left out: " + why);
}

void Partitions::sweep() {
  const Time now = clock_.now();
  for (auto entry = partitions_.begin(); entry != partitions_.end();) {
    auto& [client, partition] = *entry;
    tell_left_out(client, partition.events, "events");
    tell_left_out(client, partition.steps, "steps");
    const auto unused = now - partition.last_used;
    const bool read = partition.events.writer().matched() > 0 || partition.steps.writer().matched() > 0;
    const bool over = unused >= kQuiet || (unused >= kUnread && !read);
    entry = over && may_close(client, partition) ? partitions_.erase(entry) : std::next(entry);
  }
}

std::pair<std::size_t, std::size_t> Partitions::matched() const {
  std::pair<std::size_t, std::size_t> count{0, 0};
  for (const auto& [client, partition] : partitions_) {
    count.first += partition.events.writer().matched();
    count.second += partition.steps.writer().matched();
  }
  return count;
}

bool Partitions::wait_acknowledged(double seconds) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  const auto left = [&] { return std::max(0.0, std::chrono::duration<double>(end - std::chrono::steady_clock::now()).count()); };
  bool all = true;
  for (auto& [client, partition] : partitions_) {
    all = partition.events.writer().wait_acknowledged(left()) && all;
    all = partition.steps.writer().wait_acknowledged(left()) && all;
  }
  return all;
}

}  // namespace foothold::server
