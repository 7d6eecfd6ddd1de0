// A server for tests of the client: answers as idl/PROTOCOL.md says, with plans of numbered steps and no planner. What it does not
// answer by itself a test can send by hand.
#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "foothold/msg/cdr.hpp"
#include "foothold/msg/errors.hpp"
#include "foothold/msg/ids.hpp"
#include "memory_bus.hpp"

namespace foothold::test {

msg::Step numbered_step(const msg::Id& request, std::uint32_t index, const msg::Id& server = msg::id_of("server"));

class ScriptedServer {
 public:
  struct Script {
    std::uint32_t steps = 10;
    bool ends = true;                                                      // else RUNNING until it is cancelled
    bool final_first = false;                                              // the final event before the steps
    bool deaf = false;                                                     // hears no request
    std::uint16_t refuse = 0;                                              // rejects every request with this error
    std::uint16_t fail = 0;                                                // ends as FAILED with this error, with no step
    std::uint32_t other_from = std::numeric_limits<std::uint32_t>::max();  // from this step on its plan is not the numbered one
    std::string robot = "robot";
  };

  ScriptedServer(MemoryNetwork& network, Script script, const msg::Id& id = msg::id_of("server"));
  ~ScriptedServer();

  void set_script(const Script& script);
  void fall_silent(bool silent);  // no heartbeat; what arrives is dropped
  void forget_everything();       // as if its journal were gone
  // Sends by hand, on the server's own thread.
  void send(const msg::Id& client, const msg::PlanEvent& event);
  void send(const msg::Id& client, const msg::Step& step);
  // What clients have sent so far, whomever it was addressed to.
  std::vector<msg::PlanRequest> requests() const;
  std::vector<msg::StateQuery> queries() const;
  std::vector<msg::CancelRequest> cancels() const;
  const msg::Id& id() const { return id_; }

 private:
  struct Known {
    msg::PlanRequest request;
    std::vector<msg::Step> steps;
    msg::PlanEvent event;
  };
  struct Partition {
    std::unique_ptr<transport::Writer> events, steps;
  };

  void run();
  void announce();
  void on(const msg::PlanRequest& request);
  void on(const msg::CancelRequest& cancel);
  void on(const msg::StateQuery& query);
  void answer(const msg::Id& client, const msg::Id& request, std::uint32_t from);
  msg::PlanEvent event(const msg::Id& request, const msg::Id& client, msg::State state) const;
  Partition& partition(const msg::Id& client);
  template <class Message>
  std::unique_ptr<transport::Reader> listen(transport::Topic topic, std::vector<Message>& log);

  const msg::Id id_;
  mutable std::mutex mutex_;
  std::condition_variable work_;
  Script script_;
  bool silent_ = false, stop_ = false;
  std::deque<std::function<void()>> tasks_;
  std::vector<msg::PlanRequest> requests_;
  std::vector<msg::StateQuery> queries_;
  std::vector<msg::CancelRequest> cancels_;
  // Of its own thread:
  std::map<msg::Id, Known> known_;
  std::map<msg::Id, Partition> partitions_;
  std::map<msg::Id, msg::CancelRequest> early_cancels_;
  std::uint64_t beat_ = 0;

  std::unique_ptr<transport::Bus> bus_;
  std::unique_ptr<transport::Writer> server_, robot_;
  std::unique_ptr<transport::Reader> request_reader_, query_reader_, cancel_reader_;
  std::thread thread_;
};

}  // namespace foothold::test
