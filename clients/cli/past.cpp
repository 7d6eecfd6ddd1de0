// Plans of the past.
#include "past.hpp"

#include <unistd.h>

#include <filesystem>

#include "connection.hpp"
#include "fetch.hpp"
#include "foothold/client/plan_file.hpp"
#include "foothold/client/whole_file.hpp"
#include "foothold/msg/cdr.hpp"
#include "journal/view.hpp"
#include "terminal.hpp"

namespace foothold::cli {
namespace fs = std::filesystem;

namespace {

msg::Step step_from(const msg::Bytes& bytes, const std::string& origin) {
  auto step = msg::decode<msg::Step>(bytes);
  if (!step) throw Complaint(Exit::kUsage, origin + ": holds a step that cannot be read");
  return std::move(*step);
}

// The entries of the one request that a bundle is of.
PastPlan plan_in_bundle(const std::string& folder) {
  const std::string file = folder + "/plan.entries";
  PastPlan past{.origin = folder};
  try {
    const std::string octets = client::read_whole_file(file);
    server::EntryView view;
    const bool whole =
        server::visit_entries(std::as_bytes(std::span(octets)), [&](const server::Entry& entry) { view.add(entry); });
    if (!whole || view.requests().size() != 1 || !view.requests().begin()->second.has_request)
      throw Complaint(Exit::kUsage, file + ": is no bundle's plan, or not whole");
    const auto& known = view.requests().begin()->second;
    past.plan.request = known.record.request;
    past.received = known.record.received;
    past.plan.scene = known.record.scene;
    if (known.record.final_event) past.plan.final_event = *known.record.final_event;
    for (const auto& [number, step] : known.steps) {
      if (number != past.plan.steps.size())
        throw Complaint(Exit::kUsage, file + ": holds no step " + std::to_string(past.plan.steps.size()));
      past.plan.steps.push_back(step_from(step, file));
    }
  } catch (const std::system_error& error) {
    throw Complaint(Exit::kUsage, file + ": cannot be read: " + error.code().message());
  } catch (const server::JournalError& error) {
    throw Complaint(Exit::kUsage, file + ": " + error.what());
  }
  return past;
}

}  // namespace

std::string journal_file(const std::string& state_dir) {
  const std::string folder = state_dir.empty() ? kStateFolder : state_dir;
  const std::string file = folder + "/journal.db";
  if (::access(file.c_str(), R_OK) == 0) return file;
  const int reason = errno;
  throw Complaint(Exit::kUsage, file + ": cannot be read: " + std::generic_category().message(reason),
                  reason == EACCES
                      ? "root may, and the server's user: try sudo"
                      : "--state-dir names the state folder of a server on this host (state_dir in its footholdd.yaml)");
}

PastPlan plan_in_journal(const msg::Id& id, const std::string& state_dir) {
  const std::string file = journal_file(state_dir);
  PastPlan past{.origin = "request " + msg::to_hex(id)};
  try {
    server::JournalView journal(file);
    auto record = journal.find(id);
    if (!record)
      throw Complaint(Exit::kUnknownId, file + ": holds no request " + msg::to_hex(id), "'foothold history' lists what it holds");
    past.plan.request = std::move(record->request);
    past.received = record->received;
    past.plan.scene = std::move(record->scene);
    if (record->final_event) past.plan.final_event = std::move(*record->final_event);
    for (const msg::Bytes& step : journal.steps(id)) past.plan.steps.push_back(step_from(step, file));
  } catch (const server::JournalError& error) {
    throw Complaint(Exit::kOther, error.what());
  }
  return past;
}

PastPlan past_plan(const std::string& source, const std::string& state_dir) {
  std::error_code ignored;
  if (fs::is_directory(source, ignored)) return plan_in_bundle(source);
  if (!fs::exists(source, ignored) && msg::id_from_hex(source)) return plan_in_journal(parse_id(source), state_dir);
  try {
    return {.plan = client::read_plan_file(source), .origin = source};
  } catch (const client::PlanFileError& error) {
    throw Complaint(Exit::kUsage, error.what());
  }
}

}  // namespace foothold::cli
