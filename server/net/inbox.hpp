// What clients send: read and decoded on the vendor's threads, handed to the loop in batches, with one wake-up for a burst.
#pragma once

#include <utility>  // before Asio, whose 1.74 forgets it under C++20

#include <array>
#include <atomic>
#include <boost/asio/io_context.hpp>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <variant>
#include <vector>

#include "foothold/transport/bus.hpp"
#include "jobs/ports.hpp"

namespace foothold::server {

using ClientMessage = std::variant<msg::PlanRequest, msg::CancelRequest, msg::StateQuery, msg::SceneChunk>;

// Thread rule: made and destroyed on the loop's thread; `take` and `batch_end` are called there.
class Inbox {
 public:
  static constexpr std::size_t kMostOctets = 256u << 20;  // that wait for the loop; what comes beyond is lost and counted

  // `batch_end`: after the last message of a batch. `proven`: senders are (security is on), and a message in the name of a client
  // whose id does not begin with its sender is left out and counted. Throws BusError.
  Inbox(boost::asio::io_context& loop, transport::Bus& bus, std::function<void(ClientMessage)> take,
        std::function<void()> batch_end, bool proven = false);
  ~Inbox();  // no callback runs after it

  // A sentence for the log if, since the last call, messages came that could not be read (P9) or were lost; else empty.
  std::string take_complaint();

  // Of a topic that clients write: writers matched now, and messages since the start that could not be read.
  struct TopicFigures {
    transport::Topic topic;
    std::size_t matched;
    std::uint64_t unreadable;
  };
  std::vector<TopicFigures> figures() const;
  std::uint64_t lost() const;              // since the start
  std::uint64_t in_anothers_name() const;  // the same

 private:
  struct Shared;

  template <class Message>
  void read(transport::Bus& bus, transport::Topic topic);
  void drain();

  std::shared_ptr<Shared> shared_;
  boost::asio::io_context& loop_;
  std::function<void(ClientMessage)> take_;
  std::function<void()> batch_end_;
  const bool proven_;
  std::vector<ClientMessage> batch_;
  std::vector<std::pair<transport::Topic, std::unique_ptr<transport::Reader>>> readers_;
  std::array<std::uint64_t, transport::kTopicCount> unreadable_told_{};  // in complaints
  std::uint64_t lost_told_ = 0, in_anothers_name_told_ = 0;
};

}  // namespace foothold::server
