// What a server knows of a request, asked for once.
#pragma once

#include "connection.hpp"
#include "terminal.hpp"

namespace foothold::cli {

struct Fetched {
  msg::PlanEvent event;       // state UNKNOWN: no server knows it
  client::PlanRecord record;  // of a plan that runs on: as far as it has come
};

// Waits --timeout at most. Throws Complaint: no answer, Ctrl-C.
Fetched fetch(const Connection& connection, const Common& common, const msg::Id& id, bool with_steps);

// What to say of a request that no server knows.
Complaint unknown(const msg::Id& id);

}  // namespace foothold::cli
