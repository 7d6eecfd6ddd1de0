// Private: the client's parts and its keeper, the thread that says hello, sends again, asks for what is missing and notices that a
// server fell silent.
#pragma once

#include <atomic>
#include <condition_variable>
#include <limits>
#include <memory>
#include <mutex>
#include <set>
#include <thread>
#include <unordered_map>

#include "delivery.hpp"
#include "directory.hpp"
#include "foothold/client/client.hpp"
#include "kept_scenes.hpp"
#include "outgoing.hpp"
#include "plan_state.hpp"

namespace foothold::client {

class Client::Impl {
 public:
  using Clock = PlanState::Clock;

  Impl(std::unique_ptr<transport::Bus> bus, ClientOptions options);
  ~Impl();

  Plan submit(msg::PlanRequest request, PlanCallbacks callbacks);
  Plan query(const msg::Id& request, std::uint32_t from_step, PlanCallbacks callbacks);

  const ClientOptions options;
  const std::unique_ptr<transport::Bus> bus;
  Directory directory;
  const std::shared_ptr<Outgoing> outgoing;
  KeptScenes kept_scenes;

 private:
  // On the bus's threads.
  void on_step(std::span<const std::byte> message);
  void on_event(std::span<const std::byte> message);
  void on_server(std::span<const std::byte> message);
  std::shared_ptr<PlanState> find(const msg::Id& id);
  void begin(const std::shared_ptr<PlanState>& plan);
  void after(const std::shared_ptr<PlanState>& plan, bool news);
  enum class Found { kYes, kSoon, kNo };
  Found find_another(const std::shared_ptr<PlanState>& plan, Clock::time_point now);
  std::unique_ptr<transport::Reader> listen(transport::Topic topic, const std::string& partition,
                                            std::function<void(std::span<const std::byte>)> on_message);

  // On the keeper's thread.
  void keep();
  void begin_anew(Clock::time_point now);
  void look_at_servers(Clock::time_point now);
  void tell_returned(const msg::Id& server, const std::vector<std::shared_ptr<PlanState>>& plans);
  void say_farewells();
  void say_hello(Clock::time_point now);
  void look_at_plans(Clock::time_point now);
  bool ready_to_send(PlanState& plan, Clock::time_point now);
  void act(const std::shared_ptr<PlanState>& plan, Clock::time_point now);

  std::mutex plans_mutex_;
  std::unordered_map<msg::Id, std::shared_ptr<PlanState>, msg::IdHash> plans_;  // that are not over
  Delivery delivery_;

  std::mutex keeper_mutex_;
  std::condition_variable keeper_work_;
  bool wake_ = false, stop_ = false;
  void wake_keeper();
  std::atomic<std::size_t> writers_alive_ = std::numeric_limits<std::size_t>::max();  // heartbeats, as the vendor counts them
  std::vector<msg::CancelRequest> farewells_;                                         // of keeper_mutex_
  std::set<msg::Id> away_;                                                            // keeper only: servers that are silent
  bool open_ = false;                                                                 // keeper only
  Clock::time_point awake_since_{};                                                   // keeper only: since a halt
  Clock::time_point next_hello_{};                                                    // keeper only
  std::thread keeper_;

  // Last: no callback runs once these are gone.
  std::unique_ptr<transport::Reader> steps_, events_, servers_, robots_, scenes_;
};

}  // namespace foothold::client
