// foothold state ID: how a request stands, from whomever it is.
#include "fetch.hpp"
#include "foothold/client/plan_file.hpp"
#include "foothold/msg/errors.hpp"
#include "report.hpp"
#include "terminal.hpp"

namespace foothold::cli {

Exit run_state(const Common& common, const StateOptions& options) {
  const msg::Id id = parse_id(options.id);
  const Connection connection = connect(common);
  const auto [event, record] = fetch(connection, common, id, options.steps || !options.output.empty());
  std::size_t label_width = 0;
  if (options.steps)
    for (const msg::Step& step : record.steps) {
      if (common.json)
        std::puts(client::to_json_line(step).c_str());
      else
        print_step(step, -1.0, options.verbose, label_width);
    }
  if (!options.output.empty()) client::write_plan_file(options.output, record);
  if (common.json)
    std::puts(client::to_json_line(event).c_str());
  else if (event.state() == msg::UNKNOWN)
    throw unknown(id);
  else if (msg::is_final(event.state()))
    print_end(event);
  else
    std::printf("%s  %u step%s so far\n", coloured(event.state()).c_str(), event.steps(), event.steps() == 1 ? "" : "s");
  return exit_of(event.state());
}

}  // namespace foothold::cli
