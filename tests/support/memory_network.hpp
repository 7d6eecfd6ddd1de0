// Private to the memory bus: the ends of its writers and readers, and the one thread that carries messages between them.
#pragma once

#include <array>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <queue>
#include <random>
#include <thread>
#include <vector>

#include "memory_bus.hpp"

namespace foothold::test {

using Clock = std::chrono::steady_clock;
using Payload = std::shared_ptr<const std::vector<std::byte>>;

struct WriterEnd {
  transport::Topic topic;
  std::string partition;
  std::deque<Payload> kept;     // for late readers
  std::size_t outstanding = 0;  // on the way to some reader
  Clock::time_point asserted = Clock::now();
  bool alive = true;
};

struct ReaderEnd {
  transport::Topic topic;
  std::string partition;
  transport::ReaderEvents events;
  bool open = true;
};

class MemoryNetwork::Core {
 public:
  explicit Core(std::uint64_t seed);
  ~Core();

  std::shared_ptr<WriterEnd> add_writer(transport::Topic topic, const std::string& partition);
  std::shared_ptr<ReaderEnd> add_reader(transport::Topic topic, const std::string& partition, transport::ReaderEvents events);
  void remove(const std::shared_ptr<WriterEnd>& writer);
  void remove(const std::shared_ptr<ReaderEnd>& reader);  // waits until its callback has returned

  transport::Writer::Result write(const std::shared_ptr<WriterEnd>& writer, std::span<const std::byte> message);
  void assert_liveliness(WriterEnd& writer);
  bool wait_acknowledged(const WriterEnd& writer, double seconds);
  std::size_t matched(const WriterEnd& writer) const;
  std::size_t matched(const ReaderEnd& reader) const;

  void set_faults(transport::Topic topic, const Faults& faults);
  std::uint64_t written(transport::Topic topic) const;
  bool settle(double seconds);

 private:
  struct Delivery {
    Clock::time_point due;
    std::uint64_t order;
    std::shared_ptr<ReaderEnd> reader;
    std::shared_ptr<WriterEnd> writer;                   // of a message
    Payload message;                                     // else nothing
    std::function<void(transport::ReaderEvents&)> tell;  // else a change of matches or liveliness
  };
  struct Later {
    bool operator()(const Delivery& a, const Delivery& b) const { return a.due != b.due ? a.due > b.due : a.order > b.order; }
  };

  void run();
  void deliver(std::unique_lock<std::mutex>& lock, Delivery delivery);
  void send(const std::shared_ptr<WriterEnd>& writer, const std::shared_ptr<ReaderEnd>& reader, const Payload& message);
  void tell_matched(const std::shared_ptr<ReaderEnd>& reader);
  void tell_liveliness(transport::Topic topic);
  void look_at_liveliness();
  void push(Delivery delivery);
  std::size_t writers_of(const ReaderEnd& reader) const;
  bool chance(double probability);

  mutable std::mutex mutex_;
  std::condition_variable work_, idle_;
  std::mt19937_64 random_;
  std::array<Faults, transport::kTopicCount> faults_;
  std::array<std::uint64_t, transport::kTopicCount> written_{};
  std::array<std::vector<Delivery>, transport::kTopicCount> stalled_;
  std::vector<std::shared_ptr<WriterEnd>> writers_;
  std::vector<std::shared_ptr<ReaderEnd>> readers_;
  std::priority_queue<Delivery, std::vector<Delivery>, Later> queue_;
  std::uint64_t order_ = 0;
  const ReaderEnd* busy_ = nullptr;
  bool stop_ = false;
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace foothold::test
