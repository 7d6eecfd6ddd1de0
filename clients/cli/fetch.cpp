// Asking and waiting for the answer.
#include "fetch.hpp"

#include <chrono>
#include <limits>

#include "foothold/msg/errors.hpp"
#include "interrupt.hpp"
#include "terminal.hpp"

namespace foothold::cli {
namespace {

constexpr double kLook = 0.02;  // s between looks at Ctrl-C

// A plan that runs on is taken as far as the server's answer goes.
bool answered(const client::Plan& plan, bool with_steps) {
  if (plan.ended()) return true;
  const auto event = plan.last_event();
  if (!event || msg::is_final(event->state()) || event->state() == msg::UNKNOWN) return false;
  return !with_steps || plan.steps_ready() >= event->steps();
}

}  // namespace

Fetched fetch(const Connection& connection, const Common& common, const msg::Id& id, bool with_steps) {
  const client::Plan plan = connection.client->query(id, with_steps ? 0 : std::numeric_limits<std::uint32_t>::max());
  const auto begin = std::chrono::steady_clock::now();
  while (!answered(plan, with_steps)) {
    plan.wait(kLook);
    if (interrupted()) throw Complaint(Exit::kInterrupted, "interrupted");
    if (std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() > common.timeout)
      throw Complaint(Exit::kNoServer, "no answer within " + duration(common.timeout),
                      "'foothold doctor' looks for what is in the way");
  }
  return {*plan.last_event(), plan.record()};
}

Complaint unknown(const msg::Id& id) {
  return Complaint(Exit::kUnknownId, "no server knows request " + msg::to_hex(id),
                   "check the id; old requests are forgotten after the journal's retention time");
}

}  // namespace foothold::cli
