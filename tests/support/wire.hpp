// A client that does nothing by itself: it writes what it is told and keeps all that arrives, in the order of arrival, with the
// time. What the server really sent, for tests of the protocol's rules; the real client library would repair it.
#pragma once

#include <foothold.h>

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "foothold/msg/ids.hpp"
#include "foothold/transport/bus.hpp"

namespace foothold::test {

using SteadyClock = std::chrono::steady_clock;

template <class Message>
struct Arrival {
  Message message;
  SteadyClock::time_point at;
};

bool is_final(msg::State state);

// A request of this robot that every test planner accepts; `parameters` as name, value.
msg::PlanRequest request_for(const std::string& robot, double budget = 30.0,
                             const std::vector<std::pair<std::string, std::string>>& parameters = {});

// Thread rule: one thread uses it; the bus's threads fill it.
class Wire {
 public:
  // `partition` empty: the client's own. "*": an observer. `security`: a folder of credentials.
  Wire(const std::string& vendor, std::uint32_t domain, const std::string& partition = {}, const msg::Id& id = msg::random_id(),
       const std::string& security = {});
  ~Wire();

  const msg::Id& id() const { return id_; }
  // True when the robot is READY at a server, this client has said hello and its ways to and from the server are open.
  bool connect(const std::string& robot, double seconds = 20.0);

  // Fills in `client` and, if it is zero, `id`; gives the id.
  msg::Id submit(msg::PlanRequest request);
  void cancel(const msg::Id& request, const std::string& reason = "test");
  void query(const msg::Id& request, std::uint32_t from_step = 0);

  // What arrived for a request so far.
  std::vector<Arrival<msg::PlanEvent>> events(const msg::Id& request) const;
  std::vector<Arrival<msg::Step>> steps(const msg::Id& request) const;
  std::optional<msg::RobotInfo> robot(const std::string& name) const;
  std::optional<msg::ServerInfo> server() const;
  // Whether a server of this name was ever announced.
  bool heard_of_server(const std::string& name) const;
  std::size_t total_steps() const;

  // Waits until `holds`, which is looked at after each arrival; false after `seconds`.
  bool wait_until(double seconds, const std::function<bool()>& holds);
  // The first final event of the request, answer or not; nothing after `seconds`.
  std::optional<Arrival<msg::PlanEvent>> final_event(const msg::Id& request, double seconds = 20.0);
  // True when the steps 0 .. count - 1 of the request are there, in whatever order they came.
  bool wait_for_steps(const msg::Id& request, std::size_t count, double seconds = 20.0);

 private:
  template <class Message>
  void write(transport::Writer& writer, const Message& message);
  template <class Message>
  transport::ReaderEvents into(std::vector<Arrival<Message>>& list);

  msg::Id id_;
  mutable std::mutex mutex_;
  std::condition_variable arrived_;
  std::vector<Arrival<msg::PlanEvent>> events_;
  std::vector<Arrival<msg::Step>> steps_;
  std::vector<Arrival<msg::RobotInfo>> robots_;
  std::vector<Arrival<msg::ServerInfo>> servers_;

  std::unique_ptr<transport::Bus> bus_;
  std::unique_ptr<transport::Writer> requests_, cancels_, queries_;
  std::unique_ptr<transport::Reader> event_reader_, step_reader_, robot_reader_, server_reader_;
};

// "0123456789ab...", for messages of assertions.
std::string describe(const msg::PlanEvent& event);

}  // namespace foothold::test
