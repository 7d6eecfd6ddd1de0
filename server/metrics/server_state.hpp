// The server as it is at this moment, as plain values, and what is told of it: figures for Prometheus, and whether it is well.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "metrics/request_figures.hpp"

namespace foothold::server {

// Octets, seconds, counts since the start of the process.
struct ServerState {
  struct Robot {
    std::string name, state, reason;  // state: READY, QUARANTINED, UNAVAILABLE
    std::uint64_t slots = 0, busy = 0, workers = 0;
    std::uint64_t restarts = 0, crashes = 0;
    std::uint64_t memory = 0;  // resident, of its workers
  };
  struct Topic {
    std::string name;
    bool writes = false;  // the server writes it
    std::uint64_t matched = 0;
    std::uint64_t unreadable = 0;
  };
  std::string name, id, version, vendor;
  bool serving = false, stopping = false;
  std::string journal_trouble;  // empty: it takes writes
  std::uint64_t queued = 0, running = 0, queue_limit = 0;
  double uptime = 0.0;
  std::uint64_t partitions = 0, left_out = 0, lost = 0;
  std::uint64_t reloads = 0, reloads_refused = 0;
  std::optional<std::int64_t> credentials_expire;  // Unix time, s; nothing: DDS Security is off
  std::uint64_t in_anothers_name = 0;
  std::vector<Robot> robots;
  std::vector<Topic> topics;
};

// All figures, this process's memory, processor time and open files among them.
std::string prometheus_text(const ServerState& server, const RequestFigures& requests);

struct HealthReport {
  bool well = false;  // it takes requests, can store them and has a robot that is ready
  std::string text;   // "ok" or what is wrong, then one line for each part
};
HealthReport health_of(const ServerState& server);

}  // namespace foothold::server
