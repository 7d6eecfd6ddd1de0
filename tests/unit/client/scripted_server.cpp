// The scripted server: messages are posted to one thread, which answers.
#include "scripted_server.hpp"

namespace foothold::test {
namespace {

using transport::Topic;
using transport::Writer;

template <class Message>
void write(Writer& writer, const Message& message) {
  const msg::Bytes bytes = msg::encode(message);
  for (int tries = 0; writer.write(bytes) == Writer::Result::kFull && tries < 1000; ++tries)
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

}  // namespace

msg::Step numbered_step(const msg::Id& request, std::uint32_t index, const msg::Id& server) {
  msg::Step step;
  step.server(server);
  step.request(request);
  step.index(index);
  step.label("step " + std::to_string(index));
  step.cost(0.5 * (index + 1));
  return step;
}

ScriptedServer::ScriptedServer(MemoryNetwork& network, Script script, const msg::Id& id)
    : id_(id), script_(std::move(script)), bus_(network.bus()) {
  server_ = bus_->writer(Topic::kServer, "");
  robot_ = bus_->writer(Topic::kRobot, "");
  request_reader_ = listen(Topic::kRequest, requests_);
  query_reader_ = listen(Topic::kQuery, queries_);
  cancel_reader_ = listen(Topic::kCancel, cancels_);
  thread_ = std::thread([this] { run(); });
}

ScriptedServer::~ScriptedServer() {
  request_reader_.reset();
  query_reader_.reset();
  cancel_reader_.reset();
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  work_.notify_one();
  thread_.join();
}

template <class Message>
std::unique_ptr<transport::Reader> ScriptedServer::listen(Topic topic, std::vector<Message>& log) {
  transport::ReaderEvents events;
  events.on_message = [this, &log](std::span<const std::byte> bytes) {
    auto message = msg::decode<Message>(bytes);
    const std::lock_guard lock(mutex_);
    if (!message || silent_) return;
    log.push_back(*message);
    tasks_.push_back([this, message = *std::move(message)] { on(message); });
    work_.notify_one();
  };
  return bus_->reader(topic, "", std::move(events));
}

void ScriptedServer::set_script(const Script& script) {
  const std::lock_guard lock(mutex_);
  script_ = script;
}

void ScriptedServer::fall_silent(bool silent) {
  const std::lock_guard lock(mutex_);
  silent_ = silent;
}

void ScriptedServer::forget_everything() {
  const std::lock_guard lock(mutex_);
  tasks_.push_back([this] { known_.clear(); });
}

void ScriptedServer::send(const msg::Id& client, const msg::PlanEvent& event) {
  const std::lock_guard lock(mutex_);
  tasks_.push_back([this, client, event] { write(*partition(client).events, event); });
  work_.notify_one();
}

void ScriptedServer::send(const msg::Id& client, const msg::Step& step) {
  const std::lock_guard lock(mutex_);
  tasks_.push_back([this, client, step] { write(*partition(client).steps, step); });
  work_.notify_one();
}

std::vector<msg::PlanRequest> ScriptedServer::requests() const {
  const std::lock_guard lock(mutex_);
  return requests_;
}

std::vector<msg::StateQuery> ScriptedServer::queries() const {
  const std::lock_guard lock(mutex_);
  return queries_;
}

std::vector<msg::CancelRequest> ScriptedServer::cancels() const {
  const std::lock_guard lock(mutex_);
  return cancels_;
}

void ScriptedServer::run() {
  std::unique_lock lock(mutex_);
  auto next_beat = std::chrono::steady_clock::now();
  while (!stop_) {
    if (!tasks_.empty()) {
      const auto task = std::move(tasks_.front());
      tasks_.pop_front();
      lock.unlock();
      task();
      lock.lock();
    } else {
      work_.wait_until(lock, next_beat, [this] { return stop_ || !tasks_.empty(); });
    }
    if (std::chrono::steady_clock::now() < next_beat || silent_) continue;
    next_beat += std::chrono::milliseconds(50);
    lock.unlock();
    announce();
    lock.lock();
  }
}

void ScriptedServer::announce() {
  msg::ServerInfo server;
  server.key(id_);
  server.name("scripted");
  server.slots(1);
  server.heartbeat(++beat_);
  server_->assert_liveliness();
  write(*server_, server);
  if (beat_ != 1) return;
  msg::RobotInfo robot;
  robot.server(id_);
  robot.name(script_.robot);
  robot.key(msg::id_of(msg::to_hex(id_) + script_.robot));
  robot.state(msg::READY);
  write(*robot_, robot);
}

ScriptedServer::Partition& ScriptedServer::partition(const msg::Id& client) {
  Partition& partition = partitions_[client];
  if (!partition.events) {
    partition.events = bus_->writer(Topic::kEvent, msg::to_hex(client));
    partition.steps = bus_->writer(Topic::kStep, msg::to_hex(client));
  }
  return partition;
}

msg::PlanEvent ScriptedServer::event(const msg::Id& request, const msg::Id& client, msg::State state) const {
  msg::PlanEvent event;
  event.request(request);
  event.client(client);
  event.server(id_);
  event.state(state);
  return event;
}

void ScriptedServer::on(const msg::PlanRequest& request) {
  Script script;
  {
    const std::lock_guard lock(mutex_);
    script = script_;
  }
  if (script.deaf || (request.server() != msg::kNoId && request.server() != id_)) return;
  Partition& out = partition(request.client());
  const auto [entry, is_new] = known_.try_emplace(request.id());
  Known& known = entry->second;
  if (!is_new) return answer(request.client(), request.id(), 0);
  known.request = request;
  if (script.refuse != 0 || script.fail != 0) {
    known.event = event(request.id(), request.client(), script.refuse != 0 ? msg::REJECTED : msg::FAILED);
    known.event.error(msg::make_error(script.refuse != 0 ? script.refuse : script.fail, "as the script says"));
    return write(*out.events, known.event);
  }
  known.event = event(request.id(), request.client(), early_cancels_.contains(request.id()) ? msg::CANCELLED : msg::RUNNING);
  write(*out.events, known.event);
  if (known.event.state() == msg::CANCELLED) return;
  for (std::uint32_t i = 0; i < script.steps; ++i) known.steps.push_back(numbered_step(request.id(), i, id_));
  for (std::uint32_t i = script.other_from; i < script.steps; ++i) known.steps[i].label("another");
  known.event.steps(script.steps);
  if (script.ends) known.event.state(msg::SUCCEEDED);
  if (script.ends && script.final_first) write(*out.events, known.event);
  for (const msg::Step& step : known.steps) write(*out.steps, step);
  if (script.ends && !script.final_first) write(*out.events, known.event);
}

void ScriptedServer::on(const msg::CancelRequest& cancel) {
  const auto known = known_.find(cancel.id());
  if (known == known_.end()) {
    early_cancels_[cancel.id()] = cancel;
    return answer(cancel.client(), cancel.id(), 0);
  }
  if (msg::is_final(known->second.event.state())) return answer(cancel.client(), cancel.id(), 0);
  known->second.event.state(msg::CANCELLED);
  known->second.event.error(msg::make_error(msg::CANCELLED_BY_CLIENT, cancel.reason()));
  write(*partition(known->second.request.client()).events, known->second.event);
}

void ScriptedServer::on(const msg::StateQuery& query) {
  if (query.request() == msg::kNoId)
    partition(query.client());
  else
    answer(query.client(), query.request(), query.from_step());
}

void ScriptedServer::answer(const msg::Id& client, const msg::Id& request, std::uint32_t from) {
  Partition& out = partition(client);
  const auto known = known_.find(request);
  msg::PlanEvent answer = known == known_.end() ? event(request, client, msg::UNKNOWN) : known->second.event;
  answer.answer(true);
  write(*out.events, answer);
  if (known == known_.end()) return;
  for (std::size_t i = from; i < known->second.steps.size(); ++i) write(*out.steps, known->second.steps[i]);
}

}  // namespace foothold::test
