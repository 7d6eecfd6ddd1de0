// foothold cancel ID: stops a request of anybody's, and waits until it has ended.
#include <limits>

#include "connection.hpp"
#include "follow.hpp"
#include "foothold/client/plan_file.hpp"
#include "foothold/msg/errors.hpp"
#include "report.hpp"
#include "terminal.hpp"

namespace foothold::cli {
namespace {

constexpr std::uint32_t kNoSteps = std::numeric_limits<std::uint32_t>::max();

}  // namespace

Exit run_cancel(const Common& common, const CancelOptions& options) {
  const msg::Id id = parse_id(options.id);
  const Connection connection = connect(common);
  client::Plan plan = connection.client->query(id, kNoSteps);
  plan.cancel(options.reason);
  const msg::PlanEvent end = follow(plan, common, {.verbose = false, .show_steps = false, .patience = common.timeout});
  if (common.json)
    std::puts(client::to_json_line(end).c_str());
  else if (end.state() == msg::UNKNOWN)
    std::puts("no server knows this request; should it arrive within 10 s, it is cancelled");
  else
    print_end(end);
  if (end.state() == msg::UNKNOWN) return Exit::kUnknownId;
  return end.state() == msg::CANCELLED ? Exit::kSucceeded : exit_of(end.state());
}

}  // namespace foothold::cli
