// The network of the memory bus: one queue ordered by time, one thread.
#include "memory_network.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

namespace foothold::test {
namespace {

using transport::Topic;
using transport::Writer;

constexpr auto kLiveliness = std::chrono::seconds(1);
constexpr auto kLookAtLiveliness = std::chrono::milliseconds(50);

bool match(const WriterEnd& writer, const ReaderEnd& reader) {
  return writer.topic == reader.topic && (reader.partition == "*" || reader.partition == writer.partition);
}

// A key is the first 16 octets behind the encapsulation.
bool same_key(const Payload& a, const Payload& b) {
  return a->size() >= 20 && b->size() >= 20 && std::memcmp(a->data() + 4, b->data() + 4, 16) == 0;
}

std::size_t index(Topic topic) { return static_cast<std::size_t>(topic); }

}  // namespace

MemoryNetwork::Core::Core(std::uint64_t seed) : random_(seed), thread_([this] { run(); }) {}

MemoryNetwork::Core::~Core() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  work_.notify_all();
  thread_.join();
}

std::shared_ptr<WriterEnd> MemoryNetwork::Core::add_writer(Topic topic, const std::string& partition) {
  auto writer = std::make_shared<WriterEnd>();
  writer->topic = topic;
  writer->partition = partition;
  const std::lock_guard lock(mutex_);
  writers_.push_back(writer);
  for (const auto& reader : readers_)
    if (match(*writer, *reader)) tell_matched(reader);
  tell_liveliness(topic);
  return writer;
}

std::shared_ptr<ReaderEnd> MemoryNetwork::Core::add_reader(Topic topic, const std::string& partition,
                                                           transport::ReaderEvents events) {
  auto reader = std::make_shared<ReaderEnd>();
  reader->topic = topic;
  reader->partition = partition;
  reader->events = std::move(events);
  const std::lock_guard lock(mutex_);
  readers_.push_back(reader);
  if (writers_of(*reader) > 0) tell_matched(reader);
  tell_liveliness(topic);
  for (const auto& writer : writers_)
    if (match(*writer, *reader))
      for (const Payload& message : writer->kept) send(writer, reader, message);
  return reader;
}

void MemoryNetwork::Core::remove(const std::shared_ptr<WriterEnd>& writer) {
  const std::lock_guard lock(mutex_);
  std::erase(writers_, writer);
  for (const auto& reader : readers_)
    if (match(*writer, *reader)) tell_matched(reader);
  tell_liveliness(writer->topic);
}

void MemoryNetwork::Core::remove(const std::shared_ptr<ReaderEnd>& reader) {
  std::unique_lock lock(mutex_);
  reader->open = false;
  std::erase(readers_, reader);
  idle_.wait(lock, [&] { return busy_ != reader.get(); });
}

Writer::Result MemoryNetwork::Core::write(const std::shared_ptr<WriterEnd>& writer, std::span<const std::byte> message) {
  if (std::this_thread::get_id() == thread_.get_id()) throw std::logic_error("a callback of the bus writes to the bus");
  if (message.size() < 4) return Writer::Result::kFailed;
  const std::lock_guard lock(mutex_);
  const transport::TopicTraits& traits = transport::traits(writer->topic);
  ++written_[index(writer->topic)];
  if (faults_[index(writer->topic)].full || writer->outstanding >= static_cast<std::size_t>(traits.history))
    return Writer::Result::kFull;
  const auto payload = std::make_shared<const std::vector<std::byte>>(message.begin(), message.end());
  if (traits.keep_last_one) std::erase_if(writer->kept, [&](const Payload& kept) { return same_key(kept, payload); });
  writer->kept.push_back(payload);
  if (writer->kept.size() > static_cast<std::size_t>(traits.history)) writer->kept.pop_front();
  writer->asserted = Clock::now();
  for (const auto& reader : readers_)
    if (match(*writer, *reader)) send(writer, reader, payload);
  return Writer::Result::kSent;
}

void MemoryNetwork::Core::send(const std::shared_ptr<WriterEnd>& writer, const std::shared_ptr<ReaderEnd>& reader,
                               const Payload& message) {
  const Faults& faults = faults_[index(writer->topic)];
  if (chance(faults.loss)) return;
  const int copies = chance(faults.duplicate) ? 2 : 1;
  for (int copy = 0; copy < copies; ++copy) {
    auto due = Clock::now() + faults.delay;
    if (chance(faults.reorder))
      due += std::chrono::microseconds(std::uniform_int_distribution<std::int64_t>(0, faults.reorder_by.count())(random_));
    ++writer->outstanding;
    push({due, order_++, reader, writer, message, {}});
  }
}

void MemoryNetwork::Core::assert_liveliness(WriterEnd& writer) {
  const std::lock_guard lock(mutex_);
  writer.asserted = Clock::now();
}

bool MemoryNetwork::Core::wait_acknowledged(const WriterEnd& writer, double seconds) {
  std::unique_lock lock(mutex_);
  return idle_.wait_for(lock, std::chrono::duration<double>(seconds), [&] { return writer.outstanding == 0; });
}

std::size_t MemoryNetwork::Core::matched(const WriterEnd& writer) const {
  const std::lock_guard lock(mutex_);
  return static_cast<std::size_t>(std::ranges::count_if(readers_, [&](const auto& reader) { return match(writer, *reader); }));
}

std::size_t MemoryNetwork::Core::matched(const ReaderEnd& reader) const {
  const std::lock_guard lock(mutex_);
  return writers_of(reader);
}

std::size_t MemoryNetwork::Core::writers_of(const ReaderEnd& reader) const {
  return static_cast<std::size_t>(std::ranges::count_if(writers_, [&](const auto& writer) { return match(*writer, reader); }));
}

void MemoryNetwork::Core::set_faults(Topic topic, const Faults& faults) {
  const std::lock_guard lock(mutex_);
  faults_[index(topic)] = faults;
  if (faults.stalled) return;
  for (Delivery& delivery : stalled_[index(topic)]) push(std::move(delivery));
  stalled_[index(topic)].clear();
}

std::uint64_t MemoryNetwork::Core::written(Topic topic) const {
  const std::lock_guard lock(mutex_);
  return written_[index(topic)];
}

bool MemoryNetwork::Core::settle(double seconds) {
  std::unique_lock lock(mutex_);
  return idle_.wait_for(lock, std::chrono::duration<double>(seconds), [&] { return queue_.empty() && busy_ == nullptr; });
}

void MemoryNetwork::Core::tell_matched(const std::shared_ptr<ReaderEnd>& reader) {
  push({Clock::now(), order_++, reader, nullptr, nullptr, [count = writers_of(*reader)](transport::ReaderEvents& events) {
          if (events.on_matched) events.on_matched(count);
        }});
}

void MemoryNetwork::Core::tell_liveliness(Topic topic) {
  if (!transport::traits(topic).liveliness) return;
  const auto count = static_cast<std::size_t>(
      std::ranges::count_if(writers_, [&](const auto& writer) { return writer->topic == topic && writer->alive; }));
  for (const auto& reader : readers_)
    if (reader->topic == topic)
      push({Clock::now(), order_++, reader, nullptr, nullptr, [count](transport::ReaderEvents& events) {
              if (events.on_liveliness) events.on_liveliness(count);
            }});
}

void MemoryNetwork::Core::look_at_liveliness() {
  for (const auto& writer : writers_) {
    const bool alive = !transport::traits(writer->topic).liveliness || Clock::now() - writer->asserted < kLiveliness;
    if (std::exchange(writer->alive, alive) != alive) tell_liveliness(writer->topic);
  }
}

void MemoryNetwork::Core::push(Delivery delivery) {
  queue_.push(std::move(delivery));
  work_.notify_one();
}

bool MemoryNetwork::Core::chance(double probability) {
  return probability > 0.0 && std::uniform_real_distribution<double>(0.0, 1.0)(random_) < probability;
}

void MemoryNetwork::Core::run() {
  std::unique_lock lock(mutex_);
  while (!stop_) {
    look_at_liveliness();
    const auto until =
        queue_.empty() ? Clock::now() + kLookAtLiveliness : std::min(queue_.top().due, Clock::now() + kLookAtLiveliness);
    if (queue_.empty() || queue_.top().due > Clock::now()) {
      work_.wait_until(lock, until);
      continue;
    }
    Delivery next = queue_.top();
    queue_.pop();
    if (next.message && faults_[index(next.reader->topic)].stalled)
      stalled_[index(next.reader->topic)].push_back(std::move(next));
    else
      deliver(lock, std::move(next));
    idle_.notify_all();
  }
}

void MemoryNetwork::Core::deliver(std::unique_lock<std::mutex>& lock, Delivery delivery) {
  ReaderEnd& reader = *delivery.reader;
  if (reader.open) {
    busy_ = &reader;
    lock.unlock();
    if (delivery.message)
      reader.events.on_message(*delivery.message);
    else
      delivery.tell(reader.events);
    lock.lock();
    busy_ = nullptr;
  }
  if (delivery.writer) --delivery.writer->outstanding;
}

}  // namespace foothold::test
