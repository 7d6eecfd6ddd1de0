// A client of footholdd: finds servers and robots, submits requests, streams their steps, repairs what the network lost.
//
//   foothold::client::Client client({.vendor = "cyclone"});
//   if (!client.wait_for_robot("xrobin", 5.0)) ...
//   auto plan = client.submit(request);
//   for (const msg::Step& step : plan) execute(step);
//   plan.wait()->state();
//
// Link foothold::client. Rules of the protocol: idl/PROTOCOL.md; this library keeps those that bind a client, by itself.
#pragma once

#include <foothold.h>

#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "foothold/client/plan.hpp"
#include "foothold/msg/ids.hpp"
#include "foothold/transport/bus.hpp"

namespace foothold::client {

// Times in seconds.
struct ClientOptions {
  msg::Id id = msg::kNoId;      // of this client, the name of its partition; zeros: a random one (with credentials, one of theirs)
  double repair_after = 0.1;    // without progress, a plan's state and missing steps are asked for; doubled up to ten times
  double resend_after = 0.5;    // unanswered, a request is sent again under its id; doubled up to 4 s
  double choose_within = 1.0;   // how long submit() waits for a server that has the robot before it asks any other
  double server_silence = 1.5;  // without a heartbeat, a server counts as lost; half of it if the vendor misses one, too
  std::size_t keep_scenes = std::size_t{64} << 20;  // octets of files uploaded to all servers that are kept, for later ones (P40)
  bool failover = true;  // a request whose server is lost or cannot take it goes to another (idl/PROTOCOL.md P34 to P38)
};

// A request cannot be sent: the vendor refused its octets. The message names the topic and the vendor's reason.
class SendError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A server as its heartbeats show it.
struct ServerSeen {
  msg::ServerInfo info;
  bool alive = true;
};

// Thread rule: every function may be called from any thread, also from a plan's callbacks unless its comment says that it waits.
// Construction connects and says hello; it does not wait. Destruction joins the client's two threads; plans that are open then run
// on at the server and can be asked for by query() later.
class Client {
 public:
  // Throws transport::BusError.
  explicit Client(const transport::BusOptions& bus, ClientOptions options = {});
  explicit Client(std::unique_ptr<transport::Bus> bus, ClientOptions options = {});
  ~Client();
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  const msg::Id& id() const;
  std::string bus_version() const;  // "cyclone 0.10.2"

  // ---- who is there. What is not yet discovered is not listed: wait first.
  std::vector<ServerSeen> servers() const;
  std::vector<msg::RobotInfo> robots() const;    // of servers that are alive, by name
  std::vector<msg::SceneStatus> scenes() const;  // stored ones, by name and then by time
  // True when a server (zeros: any) is alive and both ways to it are open, so that the first request meets no discovery. Waits.
  bool wait_for_server(double seconds, const msg::Id& server = msg::kNoId) const;
  // The robot's description, in whatever state it is. Waits.
  std::optional<msg::RobotInfo> wait_for_robot(std::string_view name, double seconds, const msg::Id& server = msg::kNoId) const;
  // Waits until no server, robot or scene was announced for `quiet` seconds, `seconds` at most: then the lists are whole.
  void wait_for_lists(double seconds, double quiet = 0.25) const;

  // ---- plans
  // Sends the request and returns at once. Fills in `client`, a zero `id` by a random one, and a zero `server` by the alive server
  // that announces the robot, and the scene if there is one, and has the least to do; while none is known the request is kept and
  // sent when there is one. An id that is already open here gives that plan. Throws SendError.
  // If `server` was zero, the request moves to another such server, under its id, when its server is lost, is being stopped, was
  // restarted or refuses it for a reason that another may not have (full queue, unknown scene, robot that is out). The steps that
  // arrived before stay; the other server's must be the same, octet for octet, or the plan ends FAILED / PLAN_DIFFERS.
  Plan submit(msg::PlanRequest request, PlanCallbacks callbacks = {});
  // Asks for the plan of any id, whoever submitted it, from a step on: it is followed to its end as if it were our own. Steps
  // before `from_step` are left out.
  Plan query(const msg::Id& request, std::uint32_t from_step = 0, PlanCallbacks callbacks = {});
  // Asks to stop a request of any id. To see the answer, query() it.
  void cancel(const msg::Id& request, const std::string& reason);

  // ---- scenes
  // Sends a file's octets and waits for the verdict: SceneStatus with state STORED or REFUSED and its error. `format`: yaml, stl,
  // obj or ply. `server` zero: to all that are alive, so that any of them can plan with it; the verdict is then a refusal if one of
  // them refuses. Nothing if one that is alive did not answer within `seconds`. Waits. What all of them stored is kept here and
  // goes, by itself, to servers that come later and have no scene of that name.
  std::optional<msg::SceneStatus> upload(const std::string& name, const std::string& format, std::span<const std::byte> bytes,
                                         double seconds, const msg::Id& server = msg::kNoId);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace foothold::client
