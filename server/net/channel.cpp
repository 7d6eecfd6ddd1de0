// One writer and what waits for it.
#include "net/channel.hpp"

#include "foothold/msg/first_id.hpp"

namespace foothold::server {
namespace {

// Events and steps begin with the id of their request.
msg::Id request_of(std::span<const std::byte> message) { return msg::first_id(message).value_or(msg::kNoId); }

}  // namespace

bool Channel::write(std::span<const std::byte> message) {
  switch (writer_->write(message)) {
    case transport::Writer::Result::kSent:
      return true;
    case transport::Writer::Result::kFull:
      return false;
    case transport::Writer::Result::kFailed:
      break;
  }
  ++left_out_;  // again would fail again
  why_ = writer_->last_error();
  return true;
}

void Channel::send(std::span<const std::byte> message) {
  if (waiting_.empty() && write(message)) return;
  if (waiting_.size() >= kMostMessages || waiting_octets_ + message.size() > kMostOctets) {
    ++left_out_;
    why_ = "its reader does not acknowledge, and " + std::to_string(waiting_.size()) + " messages wait already";
    return;
  }
  waiting_.emplace_back(message.begin(), message.end());
  waiting_octets_ += message.size();
  ++waiting_of_[request_of(message)];
}

bool Channel::retry() {
  while (!waiting_.empty() && write(waiting_.front())) {
    waiting_octets_ -= waiting_.front().size();
    const auto of = waiting_of_.find(request_of(waiting_.front()));
    if (--of->second == 0) waiting_of_.erase(of);
    waiting_.pop_front();
  }
  return waiting_.empty();
}

std::uint64_t Channel::take_left_out(std::string& why) {
  why = std::move(why_);
  why_.clear();
  return std::exchange(left_out_, 0);
}

}  // namespace foothold::server
