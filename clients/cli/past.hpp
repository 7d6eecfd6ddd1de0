// Plans of the past: from a plan file, from a bundle, from the server's journal on this host.
#pragma once

#include <cstdint>
#include <string>

#include "foothold/client/plan_record.hpp"
#include "foothold/msg/ids.hpp"

namespace foothold::cli {

// Where the server keeps its state as a package installs it.
inline constexpr const char* kStateFolder = "/var/lib/footholdd";

struct PastPlan {
  client::PlanRecord plan;
  std::int64_t received = 0;  // ns since 1970; 0: not known
  std::string origin;         // for messages: the file, the folder, or the id
};

// `source`: a plan file, a bundle's folder, or a request's id, which is looked up in the journal of `state_dir` (empty:
// kStateFolder). Throws Complaint.
PastPlan past_plan(const std::string& source, const std::string& state_dir);
PastPlan plan_in_journal(const msg::Id& id, const std::string& state_dir);

// The journal of a state folder; throws Complaint if it cannot be there.
std::string journal_file(const std::string& state_dir);

}  // namespace foothold::cli
