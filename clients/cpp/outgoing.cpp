// Writers of the client, and the queue in front of each.
#include "outgoing.hpp"

#include <algorithm>

namespace foothold::client {
namespace {

using transport::Topic;
using Result = transport::Writer::Result;

[[noreturn]] void refuse(Topic topic, const transport::Writer& writer) {
  throw SendError("cannot send on " + std::string(transport::traits(topic).name) + ": " + writer.last_error());
}

}  // namespace

Outgoing::Outgoing(transport::Bus& bus)
    : request_{Topic::kRequest, bus.writer(Topic::kRequest, ""), {}, {}, {}},
      cancel_{Topic::kCancel, bus.writer(Topic::kCancel, ""), {}, {}, {}},
      query_{Topic::kQuery, bus.writer(Topic::kQuery, ""), {}, {}, {}},
      scene_{Topic::kScene, bus.writer(Topic::kScene, ""), {}, {}, {}} {}

template <class Message>
void Outgoing::send(Lane& lane, const Message& message) {
  const std::lock_guard lock(lane.mutex);
  msg::encode_into(message, lane.scratch);
  const Result result = lane.waiting.empty() ? lane.writer->write(lane.scratch) : Result::kFull;
  if (result == Result::kFull) lane.waiting.push_back(lane.scratch);
  if (result == Result::kFailed) refuse(lane.topic, *lane.writer);
}

template void Outgoing::send(Lane&, const msg::PlanRequest&);
template void Outgoing::send(Lane&, const msg::CancelRequest&);
template void Outgoing::send(Lane&, const msg::StateQuery&);

bool Outgoing::try_send(const msg::SceneChunk& chunk) {
  const std::lock_guard lock(scene_.mutex);
  msg::encode_into(chunk, scene_.scratch);
  const Result result = scene_.writer->write(scene_.scratch);
  if (result == Result::kFailed) refuse(scene_.topic, *scene_.writer);
  return result == Result::kSent;
}

bool Outgoing::flush(Lane& lane) {
  const std::lock_guard lock(lane.mutex);
  // What the vendor refuses now is left to the plan's own timers, which send and ask again.
  while (!lane.waiting.empty() && lane.writer->write(lane.waiting.front()) != Result::kFull) lane.waiting.pop_front();
  return lane.waiting.empty();
}

bool Outgoing::flush() {
  const bool request = flush(request_);
  const bool cancel = flush(cancel_);
  return flush(query_) && request && cancel;
}

std::size_t Outgoing::matched() const {
  return std::min({request_.writer->matched(), cancel_.writer->matched(), query_.writer->matched()});
}

}  // namespace foothold::client
