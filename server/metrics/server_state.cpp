// The server as figures, and as well or not.
#include "metrics/server_state.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace foothold::server {
namespace {

using Kind = Exposition::Kind;

double seconds(const timeval& time) { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); }

std::uint64_t own_memory() {
  std::ifstream file("/proc/self/statm");
  std::uint64_t size = 0, resident = 0;
  file >> size >> resident;
  return resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

// The names that every exporter has, so that ready-made dashboards show them.
void write_process(Exposition& out) {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  out.family("process_cpu_seconds_total", Kind::kCounter, "Processor time of the server, its workers left out.");
  out.sample({}, seconds(usage.ru_utime) + seconds(usage.ru_stime));
  out.family("process_resident_memory_bytes", Kind::kGauge, "Memory of the server, its workers left out.");
  out.sample({}, own_memory());
  std::uint64_t open = 0;
  std::error_code ignored;
  for (std::filesystem::directory_iterator entry("/proc/self/fd", ignored), end; !ignored && entry != end; entry.increment(ignored))
    ++open;
  out.family("process_open_fds", Kind::kGauge, "Open descriptors of the server.");
  out.sample({}, open);
  rlimit limit{};
  getrlimit(RLIMIT_NOFILE, &limit);
  out.family("process_max_fds", Kind::kGauge, "How many there may be.");
  out.sample({}, static_cast<std::uint64_t>(limit.rlim_cur));
}

void write_robots(Exposition& out, const std::vector<ServerState::Robot>& robots) {
  const auto each = [&](std::string_view name, Kind kind, std::string_view help, const std::uint64_t ServerState::Robot::*which) {
    out.family(name, kind, help);
    for (const auto& robot : robots) out.sample({{"robot", robot.name}}, robot.*which);
  };
  using Robot = ServerState::Robot;
  out.family("foothold_robot_state", Kind::kGauge, "1 for the state that the robot's planner is in.");
  for (const auto& robot : robots)
    for (const char* state : {"READY", "QUARANTINED", "UNAVAILABLE"})
      out.sample({{"robot", robot.name}, {"state", state}}, std::uint64_t{robot.state == state});
  each("foothold_slots", Kind::kGauge, "Plans that may run at the same time.", &Robot::slots);
  each("foothold_workers", Kind::kGauge, "Worker processes that are there.", &Robot::workers);
  each("foothold_workers_busy", Kind::kGauge, "Worker processes that plan.", &Robot::busy);
  each("foothold_worker_restarts_total", Kind::kCounter, "Workers started in the place of ones that died or were killed.",
       &Robot::restarts);
  each("foothold_worker_crashes_total", Kind::kCounter, "Workers that died by their planner's fault.", &Robot::crashes);
  each("foothold_worker_resident_memory_bytes", Kind::kGauge, "Memory of the robot's workers.", &Robot::memory);
}

void write_network(Exposition& out, const ServerState& server) {
  out.family("foothold_dds_matches", Kind::kGauge, "Ends of clients that DDS has matched with the server's, by topic.");
  for (const auto& topic : server.topics)
    out.sample({{"topic", topic.name}, {"server", topic.writes ? "writes" : "reads"}}, topic.matched);
  out.family("foothold_messages_unreadable_total", Kind::kCounter, "Messages that were none of their topic's type.");
  for (const auto& topic : server.topics)
    if (!topic.writes) out.sample({{"topic", topic.name}}, topic.unreadable);
  out.family("foothold_messages_lost_total", Kind::kCounter, "Messages of clients that found no room before the loop.");
  out.sample({}, server.lost);
  out.family("foothold_messages_in_anothers_name_total", Kind::kCounter, "Messages that named a client other than who sent them.");
  out.sample({}, server.in_anothers_name);
  out.family("foothold_dds_security", Kind::kGauge, "1 where DDS Security is on.");
  out.sample({}, std::uint64_t{server.credentials_expire.has_value()});
  if (server.credentials_expire) {
    out.family("foothold_credentials_expire_timestamp_seconds", Kind::kGauge, "When this server's credentials end (Unix time).");
    out.sample({}, static_cast<std::uint64_t>(*server.credentials_expire));
  }
  out.family("foothold_messages_left_out_total", Kind::kCounter, "Events and steps left out for clients that do not acknowledge.");
  out.sample({}, server.left_out);
  out.family("foothold_client_partitions", Kind::kGauge, "Clients that the server has writers open for.");
  out.sample({}, server.partitions);
}

}  // namespace

std::string prometheus_text(const ServerState& server, const RequestFigures& requests) {
  Exposition out;
  const auto one = [&](std::string_view name, Kind kind, std::string_view help, auto value) {
    out.family(name, kind, help);
    out.sample({}, value);
  };
  out.family("foothold_server_info", Kind::kGauge, "Always 1; which server this is.");
  out.sample({{"name", server.name}, {"id", server.id}, {"version", server.version}, {"dds", server.vendor}}, std::uint64_t{1});
  one("foothold_uptime_seconds", Kind::kGauge, "Since the start.", server.uptime);
  one("foothold_serving", Kind::kGauge, "1 while requests are taken.", std::uint64_t{server.serving && !server.stopping});
  one("foothold_queue_length", Kind::kGauge, "Requests that wait for a worker.", server.queued);
  one("foothold_queue_limit", Kind::kGauge, "How many may wait.", server.queue_limit);
  one("foothold_running", Kind::kGauge, "Plans that are being made.", server.running);
  one("foothold_journal_writable", Kind::kGauge, "0 while the journal's database takes nothing.",
      std::uint64_t{server.journal_trouble.empty()});
  one("foothold_reloads_total", Kind::kCounter, "Configurations that were taken while running.", server.reloads);
  one("foothold_reloads_refused_total", Kind::kCounter, "Configurations that were faulty and not taken.", server.reloads_refused);
  requests.write(out);
  write_robots(out, server.robots);
  write_network(out, server);
  write_process(out);
  return out.text();
}

HealthReport health_of(const ServerState& server) {
  std::size_t ready = 0;
  std::string robots;
  for (const auto& robot : server.robots) {
    ready += robot.state == "READY" ? 1 : 0;
    robots += "robot " + robot.name + ": " + robot.state + (robot.reason.empty() ? "" : ": " + robot.reason) + "\n";
  }
  std::string fault;
  if (!server.serving)
    fault = "starting: planners are being loaded";
  else if (server.stopping)
    fault = "stopping";
  else if (!server.journal_trouble.empty())
    fault = "the journal cannot be written";
  else if (ready == 0)
    fault = "no robot is ready";
  const std::string journal = server.journal_trouble.empty() ? "ok" : server.journal_trouble;
  return {fault.empty(), (fault.empty() ? "ok" : fault) + "\njournal: " + journal + "\n" + robots};
}

}  // namespace foothold::server
