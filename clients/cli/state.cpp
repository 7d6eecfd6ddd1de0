// foothold state ID: how a request stands, from whomever it is.
#include <algorithm>
#include <chrono>
#include <limits>

#include "connection.hpp"
#include "foothold/client/plan_file.hpp"
#include "foothold/msg/errors.hpp"
#include "interrupt.hpp"
#include "report.hpp"
#include "terminal.hpp"

namespace foothold::cli {
namespace {

constexpr double kLook = 0.02;  // s

}  // namespace

Exit run_state(const Common& common, const StateOptions& options) {
  const msg::Id id = parse_id(options.id);
  const Connection connection = connect(common);
  const bool steps = options.steps || !options.output.empty();
  client::Plan plan = connection.client->query(id, steps ? 0 : std::numeric_limits<std::uint32_t>::max());
  // A plan that runs on is shown as far as the server's answer goes.
  const auto answered = [&] {
    const auto event = plan.last_event();
    return plan.ended() || (event && !msg::is_final(event->state()) && event->state() != msg::UNKNOWN &&
                            (!steps || plan.steps_ready() >= event->steps()));
  };
  const auto begin = std::chrono::steady_clock::now();
  while (!answered()) {
    plan.wait(kLook);
    if (interrupted()) throw Complaint(Exit::kInterrupted, "interrupted");
    if (std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() > common.timeout)
      throw Complaint(Exit::kNoServer, "no answer within " + duration(common.timeout),
                      "'foothold doctor' looks for what is in the way");
  }
  const msg::PlanEvent event = *plan.last_event();
  const client::PlanRecord record = plan.record();
  if (options.steps)
    for (const msg::Step& step : record.steps) {
      if (common.json)
        std::puts(client::to_json_line(step).c_str());
      else
        print_step(step, -1.0, options.verbose);
    }
  if (!options.output.empty()) client::write_plan_file(options.output, record);
  if (common.json)
    std::puts(client::to_json_line(event).c_str());
  else if (event.state() == msg::UNKNOWN)
    throw Complaint(Exit::kUnknownId, "no server knows request " + msg::to_hex(id),
                    "check the id; old requests are forgotten after the journal's retention time");
  else if (msg::is_final(event.state()))
    print_end(event);
  else
    std::printf("%s  %u step%s so far\n", coloured(event.state()).c_str(), event.steps(), event.steps() == 1 ? "" : "s");
  return exit_of(event.state());
}

}  // namespace foothold::cli
