// From the vendor's threads to the loop.
#include "net/inbox.hpp"

#include <algorithm>
#include <boost/asio/post.hpp>

#include "foothold/msg/cdr.hpp"

namespace foothold::server {

using transport::Topic;

// Outlives the inbox in handlers that are posted already.
struct Inbox::Shared {
  std::mutex mutex;  // of all below but the counters
  std::vector<ClientMessage> messages;
  std::size_t octets = 0;
  Inbox* inbox = nullptr;  // nothing when it is gone; read by the loop only
  std::array<std::atomic<std::uint64_t>, transport::kTopicCount> unreadable{};
  std::atomic<std::uint64_t> lost = 0;
  std::atomic<std::uint64_t> in_anothers_name = 0;
};

Inbox::Inbox(boost::asio::io_context& loop, transport::Bus& bus, std::function<void(ClientMessage)> take,
             std::function<void()> batch_end, bool proven)
    : shared_(std::make_shared<Shared>()), loop_(loop), take_(std::move(take)), batch_end_(std::move(batch_end)), proven_(proven) {
  shared_->inbox = this;
  read<msg::PlanRequest>(bus, Topic::kRequest);
  read<msg::CancelRequest>(bus, Topic::kCancel);
  read<msg::StateQuery>(bus, Topic::kQuery);
  read<msg::SceneChunk>(bus, Topic::kScene);
}

Inbox::~Inbox() {
  readers_.clear();
  shared_->inbox = nullptr;
}

template <class Message>
void Inbox::read(transport::Bus& bus, Topic topic) {
  const auto take = [shared = shared_, &loop = loop_, topic](std::span<const std::byte> bytes, const transport::Sender* sender) {
    auto message = msg::decode<Message>(bytes);
    if (!message) {
      ++shared->unreadable[static_cast<std::size_t>(topic)];
      return;
    }
    if (sender != nullptr && !std::equal(sender->begin(), sender->end(), message->client().begin())) {
      ++shared->in_anothers_name;
      return;
    }
    bool first = false;
    {
      const std::lock_guard lock(shared->mutex);
      if (shared->octets + bytes.size() > kMostOctets) {
        ++shared->lost;
        return;
      }
      first = shared->messages.empty();
      shared->octets += bytes.size();
      shared->messages.emplace_back(std::move(*message));
    }
    if (!first) return;  // the loop is on its way already
    boost::asio::post(loop, [shared] {
      if (shared->inbox != nullptr) shared->inbox->drain();
    });
  };
  transport::ReaderEvents events;
  if (proven_)
    events.on_message_from = [take](std::span<const std::byte> bytes, const transport::Sender& sender) { take(bytes, &sender); };
  else
    events.on_message = [take](std::span<const std::byte> bytes) { take(bytes, nullptr); };
  readers_.emplace_back(topic, bus.reader(topic, "", std::move(events)));
}

void Inbox::drain() {
  {
    const std::lock_guard lock(shared_->mutex);
    batch_.swap(shared_->messages);
    shared_->octets = 0;
  }
  for (ClientMessage& message : batch_) take_(std::move(message));
  batch_.clear();
  batch_end_();
}

std::string Inbox::take_complaint() {
  const auto news = [](const std::atomic<std::uint64_t>& count, std::uint64_t& told) {
    const std::uint64_t now = count;
    return now - std::exchange(told, now);
  };
  std::string complaint;
  for (std::size_t i = 0; i < transport::kTopicCount; ++i)
    if (const auto count = news(shared_->unreadable[i], unreadable_told_[i]); count != 0)
      complaint += (complaint.empty() ? "" : "; ") + std::to_string(count) + " messages on " +
                   std::string(transport::kTopics[i].name) + " are not messages of its type";
  if (const auto count = news(shared_->lost, lost_told_); count != 0)
    complaint += (complaint.empty() ? "" : "; ") + std::to_string(count) + " messages were lost: too many wait for the loop";
  if (const auto count = news(shared_->in_anothers_name, in_anothers_name_told_); count != 0)
    complaint += (complaint.empty() ? "" : "; ") + std::to_string(count) + " messages were left out: sent in another client's name";
  return complaint;
}

std::uint64_t Inbox::in_anothers_name() const { return shared_->in_anothers_name; }

std::vector<Inbox::TopicFigures> Inbox::figures() const {
  std::vector<TopicFigures> figures;
  for (const auto& [topic, reader] : readers_)
    figures.push_back({topic, reader->matched(), shared_->unreadable[static_cast<std::size_t>(topic)]});
  return figures;
}

std::uint64_t Inbox::lost() const { return shared_->lost; }

}  // namespace foothold::server
