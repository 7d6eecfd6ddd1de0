// foothold history: what the journal of a server on this host holds.
#include <chrono>
#include <ctime>

#include "connection.hpp"
#include "fetch.hpp"
#include "foothold/client/nearest_name.hpp"
#include "foothold/client/plan_file.hpp"
#include "foothold/msg/errors.hpp"
#include "foothold/msg/times.hpp"
#include "journal/view.hpp"
#include "past.hpp"
#include "report.hpp"
#include "terminal.hpp"

namespace foothold::cli {
namespace {

constexpr char kUnfinished[] = "UNFINISHED";

std::int64_t now() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::system_clock::now().time_since_epoch()).count();
}

std::string known_state(const std::string& state) {
  std::vector<std::string> names = {kUnfinished};
  for (std::uint32_t known = msg::SUCCEEDED; known <= msg::REJECTED; ++known)
    names.emplace_back(msg::state_name(static_cast<msg::State>(known)));
  if (!state.empty() && std::ranges::find(names, state) == names.end())
    throw Complaint(Exit::kUsage, "--state " + printable(state) + ": is no state of a journal" + client::suggestion(state, names));
  return state;
}

std::string state_of(const server::Record& record) {
  return record.final_event ? std::string(msg::state_name(record.final_event->state())) : kUnfinished;
}

std::vector<std::string> row(const server::Record& record) {
  const msg::PlanRequest& request = record.request;
  const msg::PlanEvent end = record.final_event.value_or(msg::PlanEvent{});
  const bool ran = !end.summary().plugin().empty();
  return {msg::local_text(record.received / 1'000'000'000),
          msg::to_hex(request.id()),
          printable(request.robot()),
          printable(request.unit()),
          record.final_event ? coloured(end.state()) : coloured(Colour::kBold, kUnfinished),
          std::to_string(record.steps),
          ran ? duration(end.summary().queued()) : "",
          ran ? duration(end.summary().prepared() + end.summary().planned()) : "",
          printable(end.error().name())};
}

client::PlanRecord as_plan(server::Record record) {
  client::PlanRecord plan;
  plan.request = std::move(record.request);
  if (record.final_event) plan.final_event = std::move(*record.final_event);
  return plan;
}

Exit show_one(const Common& common, const HistoryOptions& options) {
  const PastPlan past = plan_in_journal(parse_id(options.id), options.state_dir);
  const msg::PlanRequest& request = past.plan.request;
  const msg::PlanEvent& end = past.plan.final_event;
  if (!options.output.empty()) client::write_plan_file(options.output, past.plan);
  if (common.json) {
    std::puts(client::to_json_line(client::PlanRecord{request, end, {}, {}}).c_str());
    return Exit::kSucceeded;
  }
  std::printf("%s  received %s\n  robot %s%s%s, client %s, budget %s, priority %d\n", msg::to_hex(request.id()).c_str(),
              msg::local_text(past.received / 1'000'000'000).c_str(), printable(request.robot()).c_str(),
              request.unit().empty() ? "" : " of unit ", printable(request.unit()).c_str(), msg::to_hex(request.client()).c_str(),
              duration(request.budget()).c_str(), static_cast<int>(request.priority()));
  if (end.state() == msg::UNKNOWN)
    std::printf("%s  %zu steps so far\n", kUnfinished, past.plan.steps.size());
  else
    print_end(end);
  return Exit::kSucceeded;
}

}  // namespace

Exit run_history(const Common& common, const HistoryOptions& options) {
  if (!options.id.empty()) return show_one(common, options);
  if (!options.output.empty()) throw Complaint(Exit::kUsage, "--output: needs a request's id");
  const std::string state = known_state(options.state);
  const msg::Id client = options.client.empty() ? msg::kNoId : parse_id(options.client);
  const std::int64_t first = options.since > 0.0 ? now() - static_cast<std::int64_t>(options.since * 1e9) : 0;
  std::vector<server::Record> records;
  try {
    server::JournalView journal(journal_file(options.state_dir));
    records = journal.latest(options.most, [&](const server::Record& record) {
      return (options.robot.empty() || record.request.robot() == options.robot) &&
             (options.unit.empty() || record.request.unit() == options.unit) && (state.empty() || state_of(record) == state) &&
             (client == msg::kNoId || record.request.client() == client) && record.received >= first;
    });
  } catch (const server::JournalError& error) {
    throw Complaint(Exit::kOther, error.what());
  }
  if (common.json) {
    for (server::Record& record : records) std::puts(client::to_json_line(as_plan(std::move(record))).c_str());
    return Exit::kSucceeded;
  }
  std::vector<std::vector<std::string>> rows = {
      {"RECEIVED", "ID", "ROBOT", "UNIT", "STATE", "STEPS", "WAITED", "PLANNED", "ERROR"}};
  for (const server::Record& record : records) rows.push_back(row(record));
  print_table(rows);
  return Exit::kSucceeded;
}

}  // namespace foothold::cli
