// See wire.hpp.
#include "wire.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <thread>

#include "foothold/msg/cdr.hpp"

namespace foothold::test {
using transport::Topic;
using namespace std::chrono_literals;

namespace {

template <class Message>
std::vector<Arrival<Message>> of_request(const std::vector<Arrival<Message>>& all, const msg::Id& request) {
  std::vector<Arrival<Message>> found;
  std::ranges::copy_if(all, std::back_inserter(found), [&](const auto& each) { return each.message.request() == request; });
  return found;
}

}  // namespace

bool is_final(msg::State state) { return state != msg::UNKNOWN && state != msg::QUEUED && state != msg::RUNNING; }

msg::PlanRequest request_for(const std::string& robot, double budget,
                             const std::vector<std::pair<std::string, std::string>>& parameters) {
  msg::PlanRequest request;
  request.id(msg::random_id());
  request.robot(robot);
  request.budget(budget);
  for (const auto& [name, value] : parameters) {
    msg::Parameter parameter;
    parameter.name(name);
    parameter.value(value);
    request.parameters().push_back(parameter);
  }
  return request;
}

std::string describe(const msg::PlanEvent& event) {
  return msg::to_hex(event.request()).substr(0, 8) + " state " + std::to_string(event.state()) +
         (event.answer() ? " (answer) " : " ") + std::to_string(event.steps()) + " steps, error " +
         std::to_string(event.error().code()) + " " + event.error().name() + " [" + event.error().field() + "] " +
         event.error().message();
}

template <class Message>
transport::ReaderEvents Wire::into(std::vector<Arrival<Message>>& list) {
  transport::ReaderEvents events;
  events.on_message = [this, &list](std::span<const std::byte> bytes) {
    const auto now = SteadyClock::now();
    std::optional<Message> message = msg::decode<Message>(bytes);
    if (!message) return;
    const std::lock_guard lock(mutex_);
    list.push_back({std::move(*message), now});
    arrived_.notify_all();
  };
  return events;
}

Wire::Wire(const std::string& vendor, std::uint32_t domain, const std::string& partition, const msg::Id& id,
           const std::string& security)
    : id_(id) {
  const std::string own = partition.empty() ? msg::to_hex(id_) : partition;
  bus_ = transport::open_bus({vendor, domain, {}, security});
  event_reader_ = bus_->reader(Topic::kEvent, own, into(events_));
  step_reader_ = bus_->reader(Topic::kStep, own, into(steps_));
  robot_reader_ = bus_->reader(Topic::kRobot, {}, into(robots_));
  server_reader_ = bus_->reader(Topic::kServer, {}, into(servers_));
  requests_ = bus_->writer(Topic::kRequest, {});
  cancels_ = bus_->writer(Topic::kCancel, {});
  queries_ = bus_->writer(Topic::kQuery, {});
}

Wire::~Wire() {
  // Readers first: their callbacks use the lists above.
  server_reader_.reset();
  robot_reader_.reset();
  step_reader_.reset();
  event_reader_.reset();
}

bool Wire::connect(const std::string& name, double seconds) {
  const auto until = SteadyClock::now() + std::chrono::duration<double>(seconds);
  const auto open = [&] {
    const std::optional<msg::RobotInfo> info = robot(name);
    return server() && info && info->state() == msg::READY && requests_->matched() > 0 && cancels_->matched() > 0 &&
           queries_->matched() > 0;
  };
  // A hello may be lost on a way that the server's side has not opened yet: until the answer's way is open it is repeated.
  auto next_hello = SteadyClock::now();
  for (auto now = next_hello; now < until; now = SteadyClock::now()) {
    if (open() && now >= next_hello) {
      query(msg::kNoId);
      next_hello = now + 200ms;
    }
    if (open() && event_reader_->matched() > 0 && step_reader_->matched() > 0) return true;
    std::this_thread::sleep_for(5ms);
  }
  return false;
}

template <class Message>
void Wire::write(transport::Writer& writer, const Message& message) {
  const msg::Bytes bytes = msg::encode(message);
  for (int attempt = 0; attempt < 2000; ++attempt) {
    const auto result = writer.write(bytes);
    if (result == transport::Writer::Result::kSent) return;
    if (result == transport::Writer::Result::kFailed) throw std::runtime_error("write: " + writer.last_error());
    std::this_thread::sleep_for(1ms);
  }
  throw std::runtime_error("write: the history stays full");
}

msg::Id Wire::submit(msg::PlanRequest request) {
  if (request.id() == msg::kNoId) request.id(msg::random_id());
  request.client(id_);
  write(*requests_, request);
  return request.id();
}

void Wire::cancel(const msg::Id& request, const std::string& reason) {
  msg::CancelRequest cancel;
  cancel.id(request);
  cancel.client(id_);
  cancel.reason(reason);
  write(*cancels_, cancel);
}

void Wire::query(const msg::Id& request, std::uint32_t from_step) {
  msg::StateQuery query;
  query.client(id_);
  query.request(request);
  query.from_step(from_step);
  write(*queries_, query);
}

std::vector<Arrival<msg::PlanEvent>> Wire::events(const msg::Id& request) const {
  const std::lock_guard lock(mutex_);
  return of_request(events_, request);
}

std::vector<Arrival<msg::Step>> Wire::steps(const msg::Id& request) const {
  const std::lock_guard lock(mutex_);
  return of_request(steps_, request);
}

bool Wire::heard_of_server(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  return std::ranges::any_of(servers_, [&](const auto& server) { return server.message.name() == name; });
}

std::size_t Wire::total_steps() const {
  const std::lock_guard lock(mutex_);
  return steps_.size();
}

std::optional<msg::RobotInfo> Wire::robot(const std::string& name) const {
  const std::lock_guard lock(mutex_);
  for (auto each = robots_.rbegin(); each != robots_.rend(); ++each)
    if (each->message.name() == name) return each->message;
  return std::nullopt;
}

std::optional<msg::ServerInfo> Wire::server() const {
  const std::lock_guard lock(mutex_);
  return servers_.empty() ? std::nullopt : std::optional(servers_.back().message);
}

bool Wire::wait_until(double seconds, const std::function<bool()>& holds) {
  const auto until = SteadyClock::now() + std::chrono::duration<double>(seconds);
  while (!holds()) {
    std::unique_lock lock(mutex_);
    // The condition is looked at without the lock, so an arrival may slip in between: look again soon.
    arrived_.wait_for(lock, 10ms);
    if (SteadyClock::now() >= until) {
      lock.unlock();
      return holds();
    }
  }
  return true;
}

std::optional<Arrival<msg::PlanEvent>> Wire::final_event(const msg::Id& request, double seconds) {
  std::optional<Arrival<msg::PlanEvent>> found;
  wait_until(seconds, [&] {
    for (const auto& event : events(request))
      if (is_final(event.message.state())) {
        found = event;
        break;
      }
    return found.has_value();
  });
  return found;
}

bool Wire::wait_for_steps(const msg::Id& request, std::size_t count, double seconds) {
  return wait_until(seconds, [&] {
    std::set<std::uint32_t> indices;
    for (const auto& step : steps(request))
      if (step.message.index() < count) indices.insert(step.message.index());
    return indices.size() == count;
  });
}

}  // namespace foothold::test
