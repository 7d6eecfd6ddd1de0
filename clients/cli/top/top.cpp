// foothold top: servers, robots and requests of the fleet, again and again.
#include <unistd.h>

#include <cmath>
#include <thread>

#include "connection.hpp"
#include "foothold/msg/cdr.hpp"
#include "interrupt.hpp"
#include "terminal.hpp"
#include "top/fleet.hpp"

namespace foothold::cli {
namespace {

using Clock = Fleet::Clock;
using transport::Topic;

constexpr auto kLook = std::chrono::milliseconds(50);
constexpr auto kGather = std::chrono::milliseconds(500);  // after the first server, until robots and events are there
constexpr std::size_t kMostRows = 30;                     // of requests

std::int64_t stamp_now() {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(std::chrono::system_clock::now().time_since_epoch()).count();
}

template <class Message, class Add>
transport::ReaderEvents into(Add add) {
  transport::ReaderEvents events;
  events.on_message = [add](std::span<const std::byte> bytes) {
    if (const auto message = msg::decode<Message>(bytes)) add(*message);
  };
  return events;
}

// False if Ctrl-C came meanwhile.
template <class Done>
bool wait(std::chrono::duration<double> time, Done done) {
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(time);
  while (!interrupted() && Clock::now() < end && !done())
    std::this_thread::sleep_for(std::min<Clock::duration>(kLook, end - Clock::now()));
  return !interrupted();
}

std::string long_time(double seconds) {
  if (seconds < 120.0) return format("%.1f s", seconds);
  if (seconds < 7200.0) return format("%.0f min", seconds / 60.0);
  return format("%.1f h", seconds / 3600.0);
}

std::string state_of(const FleetPicture::Server& server) {
  if (!server.alive) return coloured(Colour::kBad, "silent");
  return server.info.stopping() ? coloured(Colour::kWarn, "stopping") : coloured(Colour::kGood, "serves");
}

std::string state_of(const msg::RobotInfo& robot) {
  if (robot.state() == msg::READY) return coloured(Colour::kGood, "ready");
  return coloured(Colour::kBad, robot.state() == msg::QUARANTINED ? "quarantined" : "unavailable");
}

std::vector<std::string> row(const FleetPicture::Request& request) {
  const msg::PlanEvent& event = request.event;
  return {msg::to_hex(event.request()),    printable(event.robot()),
          printable(event.unit()),         printable(request.server),
          coloured(event.state()),         long_time(request.age),
          printable(event.error().name()), msg::to_hex(event.client()).substr(0, 8)};
}

void print_requests(const char* title, const std::vector<FleetPicture::Request>& requests) {
  std::vector<std::vector<std::string>> rows = {{title, "ROBOT", "UNIT", "SERVER", "STATE", "SINCE", "ERROR", "CLIENT"}};
  for (std::size_t i = 0; i < std::min(requests.size(), kMostRows); ++i) rows.push_back(row(requests[i]));
  std::puts("");
  print_table(rows);
  if (requests.size() > kMostRows) std::printf("and %zu more\n", requests.size() - kMostRows);
}

void print(const FleetPicture& picture) {
  std::vector<std::vector<std::string>> servers = {{"SERVER", "STATE", "VERSION", "UP", "QUEUED", "RUNNING", "SLOTS"}};
  for (const auto& server : picture.servers)
    servers.push_back({printable(server.info.name()), state_of(server), printable(server.info.version()),
                       long_time(server.info.uptime()), std::to_string(server.info.queued()), std::to_string(server.info.running()),
                       std::to_string(server.info.slots())});
  print_table(servers);
  if (picture.servers.empty()) std::puts("no server is heard");
  std::vector<std::vector<std::string>> robots = {{"ROBOT", "SERVER", "STATE", "RUNNING", "SLOTS", "PLANNER"}};
  for (const auto& robot : picture.robots)
    robots.push_back({printable(robot.info.name()), printable(robot.server), state_of(robot.info), std::to_string(robot.running),
                      std::to_string(robot.info.slots()),
                      printable(robot.info.state() == msg::READY ? robot.info.plugin() + " " + robot.info.plugin_version()
                                                                 : robot.info.reason())});
  std::puts("");
  print_table(robots);
  print_requests("UNFINISHED REQUEST", picture.requests);
  if (!picture.ended.empty()) print_requests("ENDED REQUEST", picture.ended);
  std::string counts;
  for (const auto& [state, count] : picture.ended_by_state)
    counts += format("  %s %llu", state.c_str(), static_cast<unsigned long long>(count));
  std::printf("\nended since the watching began:%s\n", counts.empty() ? " none" : counts.c_str());
}

}  // namespace

Exit run_top(const Common& common, const TopOptions& options) {
  watch_interrupts();
  Fleet fleet(stamp_now());
  std::unique_ptr<transport::Bus> bus;
  std::vector<std::unique_ptr<transport::Reader>> readers;
  try {
    bus = transport::open_bus(bus_options(common));
    readers.push_back(bus->reader(Topic::kServer, "",
                                  into<msg::ServerInfo>([&](const msg::ServerInfo& info) { fleet.add(info, Clock::now()); })));
    readers.push_back(bus->reader(Topic::kRobot, "", into<msg::RobotInfo>([&](const msg::RobotInfo& info) { fleet.add(info); })));
    readers.push_back(
        bus->reader(Topic::kEvent, "*", into<msg::PlanEvent>([&](const msg::PlanEvent& event) { fleet.add(event); })));
  } catch (const transport::BusError& error) {
    throw Complaint(Exit::kOther, error.what(), "'foothold doctor' looks at what DDS needs");
  }
  const bool screen = isatty(STDOUT_FILENO) == 1 && !common.json;
  wait(std::chrono::duration<double>(common.timeout), [&] { return fleet.has_server(); });
  if (fleet.has_server()) wait(kGather, [] { return false; });
  for (std::size_t pictures = 0; !interrupted();) {
    const FleetPicture picture = fleet.look(Clock::now(), stamp_now());
    if (common.json) {
      std::puts(to_json_line(picture).c_str());
    } else {
      if (screen) std::fputs("\033[H\033[2J", stdout);
      if (!screen && pictures > 0) std::puts("");
      print(picture);
    }
    std::fflush(stdout);
    if (std::ferror(stdout) != 0 || ++pictures == options.count) break;
    wait(std::chrono::duration<double>(options.interval), [] { return false; });
  }
  if (!fleet.has_server())
    throw Complaint(Exit::kNoServer, "no server was heard with " + common.dds + " on domain " + std::to_string(common.domain),
                    "start footholdd, or give its --domain; 'foothold doctor' looks for what is in the way");
  return Exit::kSucceeded;
}

}  // namespace foothold::cli
