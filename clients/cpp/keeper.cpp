// The keeper: everything that a client does by itself, on a thread of its own.
#include <algorithm>

#include "client_impl.hpp"

namespace foothold::client {
namespace {

using std::chrono::milliseconds;

constexpr auto kConnecting = milliseconds(5);  // while the ways to the servers are not open
constexpr auto kBusy = milliseconds(25);       // while a plan is open
constexpr auto kIdle = milliseconds(100);
constexpr auto kHelloAgain = milliseconds(200);
constexpr auto kHalted = milliseconds(500);  // later than it meant to go on: the process, or its machine, stood still

PlanState::Clock::duration from_seconds(double seconds) {
  return std::chrono::duration_cast<PlanState::Clock::duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

void Client::Impl::wake_keeper() {
  {
    const std::lock_guard lock(keeper_mutex_);
    wake_ = true;
  }
  keeper_work_.notify_one();
}

void Client::Impl::keep() {
  std::unique_lock lock(keeper_mutex_);
  auto meant = Clock::now();
  while (!stop_) {
    wake_ = false;
    lock.unlock();
    const auto now = Clock::now();
    if (now - meant > kHalted) begin_anew(now);
    bool sent = outgoing->flush();
    try {
      look_at_servers(now);
      if (kept_scenes.tend(now)) sent = false;
      say_hello(now);
      say_farewells();
      look_at_plans(now);
    } catch (const SendError&) {
      // Nobody waits for this call; the timers of what could not be sent bring it here again.
    }
    Clock::duration pause = kIdle;
    {
      const std::lock_guard plans(plans_mutex_);
      if (!plans_.empty()) pause = std::min<Clock::duration>(kBusy, from_seconds(options.repair_after / 4.0));
    }
    if (!open_ || !sent) pause = std::min<Clock::duration>(pause, kConnecting);
    lock.lock();
    meant = Clock::now() + pause;
    keeper_work_.wait_for(lock, pause, [this] { return wake_ || stop_; });
  }
}

// What has come meanwhile is still on its way through the vendor's threads: nobody is silent, and nothing missing, before that.
void Client::Impl::begin_anew(Clock::time_point now) {
  awake_since_ = now;
  directory.forgive_silence(now);
  const std::lock_guard lock(plans_mutex_);
  for (const auto& [id, plan] : plans_) plan->wait_for_news(now);
}

void Client::Impl::look_at_servers(Clock::time_point now) {
  // The vendor counts halts of our own as well.
  const bool settled = now - awake_since_ > from_seconds(options.server_silence);
  directory.mark_silent(now, options.server_silence, settled ? writers_alive_.load() : std::numeric_limits<std::size_t>::max());
  const std::vector<msg::Id> alive = directory.alive();
  const std::vector<ServerSeen> servers = directory.servers();
  std::vector<std::shared_ptr<PlanState>> plans;
  {
    const std::lock_guard lock(plans_mutex_);
    for (const auto& [id, plan] : plans_) plans.push_back(plan);
  }
  for (const auto& plan : plans) {
    const msg::Id server = plan->server();
    const auto seen = std::ranges::find(servers, server, [](const ServerSeen& s) { return s.info.key(); });
    if (seen == servers.end()) continue;
    if (plan->set_server_lost(server, !seen->alive, now)) delivery_.post(plan);
    if (plan->wants_another()) after(plan, false);
  }
  for (const ServerSeen& server : servers) {
    if (!server.alive)
      away_.insert(server.info.key());
    else if (away_.erase(server.info.key()) != 0)
      tell_returned(server.info.key(), plans);
  }
}

// A server that is back may still have what has moved on since: that the same request goes to another tells it so (P35).
void Client::Impl::tell_returned(const msg::Id& server, const std::vector<std::shared_ptr<PlanState>>& plans) {
  for (const auto& plan : plans) {
    const auto left = plan->left();
    if (!plan->ended() && std::ranges::find(left, server) != left.end()) outgoing->send(plan->request());
  }
}

void Client::Impl::say_farewells() {
  std::vector<msg::CancelRequest> farewells;
  {
    const std::lock_guard lock(keeper_mutex_);
    farewells.swap(farewells_);
  }
  for (const msg::CancelRequest& cancel : farewells) outgoing->send(cancel);
}

// Until every server that is alive hears us and has opened our partition. P1.
void Client::Impl::say_hello(Clock::time_point now) {
  const std::size_t alive = directory.alive().size();
  const bool heard = alive > 0 && outgoing->matched() >= alive;
  open_ = heard && events_->matched() >= alive && steps_->matched() >= alive;
  directory.set_open(open_);
  if (!heard || open_ || now < next_hello_) return;
  msg::StateQuery hello;
  hello.client(options.id);
  outgoing->send(hello);
  next_hello_ = now + kHelloAgain;
}

void Client::Impl::look_at_plans(Clock::time_point now) {
  std::vector<std::shared_ptr<PlanState>> plans;
  {
    const std::lock_guard lock(plans_mutex_);
    // Whoever dropped the last handle of a plan that has no callbacks does not want it any more.
    std::erase_if(plans_, [](const auto& entry) { return entry.second.use_count() == 1 && !entry.second->wants_callbacks(); });
    for (const auto& [id, plan] : plans_) plans.push_back(plan);
  }
  for (const auto& plan : plans) act(plan, now);
}

// A request without a server goes to one that has the robot; to whomever there is if none says so in time.
bool Client::Impl::ready_to_send(PlanState& plan, Clock::time_point now) {
  if (!plan.unsent()) return true;
  const msg::PlanRequest request = plan.request();
  if (request.server() != msg::kNoId) return true;
  const bool soon = kept_scenes.may_deliver(request, {});
  if (const auto server = directory.choose(request, {}, soon)) {
    plan.choose(*server, request.scene().empty() ? std::string() : directory.newest(request.scene(), *server));
    return true;
  }
  if (soon || now - plan.times().submitted < from_seconds(options.choose_within)) return false;
  const std::vector<msg::Id> alive = directory.alive();
  if (alive.empty()) return false;
  plan.choose(alive.front());
  return true;
}

void Client::Impl::act(const std::shared_ptr<PlanState>& plan, Clock::time_point now) {
  if (!ready_to_send(*plan, now)) return;
  const PlanState::Due due = plan->due(now);
  if (due == PlanState::Due::kNothing) return;
  if (const auto cancel = plan->unanswered_cancel()) outgoing->send(*cancel);
  if (due == PlanState::Due::kSend) outgoing->send(plan->request());
  if (due == PlanState::Due::kAsk) outgoing->send(plan->question(options.id));
}

}  // namespace foothold::client
