// Private: what the client writes. A message that meets a full history waits here and goes out in order, a little later.
#pragma once

#include <deque>
#include <memory>
#include <mutex>

#include "foothold/client/client.hpp"
#include "foothold/msg/cdr.hpp"

namespace foothold::client {

// Any thread, except inside a callback of the bus.
class Outgoing {
 public:
  explicit Outgoing(transport::Bus& bus);

  // Throws SendError if the vendor refuses the octets.
  void send(const msg::PlanRequest& request) { send(request_, request); }
  void send(const msg::CancelRequest& cancel) { send(cancel_, cancel); }
  void send(const msg::StateQuery& query) { send(query_, query); }
  // False: the history is full, try again later. Chunks do not wait here: an upload paces itself.
  bool try_send(const msg::SceneChunk& chunk);

  // Sends what waits; true if nothing is left.
  bool flush();
  // Readers of requests, cancels and queries that are matched: the least of the three.
  std::size_t matched() const;
  std::size_t scene_matched() const { return scene_.writer->matched(); }
  bool scene_acknowledged(double seconds) { return scene_.writer->wait_acknowledged(seconds); }

 private:
  struct Lane {
    transport::Topic topic;
    std::unique_ptr<transport::Writer> writer;
    std::mutex mutex;
    msg::Bytes scratch;
    std::deque<msg::Bytes> waiting;
  };
  template <class Message>
  void send(Lane& lane, const Message& message);
  static bool flush(Lane& lane);

  Lane request_, cancel_, query_, scene_;
};

}  // namespace foothold::client
