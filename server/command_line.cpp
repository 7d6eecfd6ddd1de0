// The one file that includes CLI11 here: it takes seconds to compile.
#include "command_line.hpp"

#include <CLI/CLI.hpp>

namespace foothold::server {
namespace {

constexpr const char* kFooter = R"(
Exit codes:
  0  stopped by SIGTERM or SIGINT, or --check found no fault
  1  a fault of the server itself; the log says what
  2  the command line, footholdd.yaml or a robot's file; every fault is told with file, line and field
  3  the state folder or the journal in it cannot be used
  4  the bus cannot be opened

Signals: SIGTERM and SIGINT end every request as CANCELLED / SERVER_STOPPING, tell the clients, and exit.
SIGHUP reads the configuration again: a faulty one is told and not taken; robots whose numbers or planner changed get newer workers,
and plans that run end on the older ones; dds and state_dir take a restart.
The log goes to stderr.)";

}  // namespace

CommandLine parse_command_line(int count, char** words) {
  CommandLine line;
  CLI::App app("footholdd plans for walking and climbing robots: clients ask over DDS, planners run in processes of their own.",
               "footholdd");
  app.footer(kFooter);
  app.set_version_flag("--version", std::string("footholdd ") + FOOTHOLD_VERSION);
  app.add_option("--config", line.config, "footholdd.yaml")->required()->type_name("FILE");
  app.add_option("--state-dir", line.state_dir, "Folder of journal and scenes, instead of the file's state_dir")->type_name("DIR");
  app.add_option("--dds", line.vendor, "Instead of the file's dds.vendor")->check(CLI::IsMember({"cyclone", "fastdds"}));
  app.add_option("--domain", line.domain, "DDS domain, 0 to 200, instead of the file's dds.domain")->check(CLI::Range(0, 200));
  app.add_flag("--check", line.check, "Look for faults in the configuration and exit");
  try {
    app.parse(count, words);
  } catch (const CLI::ParseError& error) {
    line.exit = app.exit(error) == 0 ? kStopped : kBadConfiguration;
  }
  return line;
}

}  // namespace foothold::server
