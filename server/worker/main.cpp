// foothold-worker: the process that holds one plugin. Started by footholdd with a socket as descriptor 3; by people with
// --describe.
#include <sys/socket.h>
#include <sys/stat.h>

#include <CLI/CLI.hpp>

#include "worker/confinement.hpp"
#include "worker/describe.hpp"
#include "worker/session.hpp"

namespace {

constexpr int kSocket = 3;

bool is_socket(int descriptor) {
  struct stat status {};
  return fstat(descriptor, &status) == 0 && S_ISSOCK(status.st_mode);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace foothold::server;
  CLI::App app{"Holds one planner for footholdd, or describes a plugin."};
  std::string plugin, robot_file;
  int daemon = 0;
  auto* described = app.add_option("--describe", plugin, "Print what this plugin holds, as JSON; exit 1 if it is refused");
  app.add_option("--robot", robot_file, "With --describe: make its planner with the model of this file")->needs(described);
  app.add_option("--daemon", daemon, "The process id of footholdd, which passes a socket as descriptor 3")->excludes(described);
  CLI11_PARSE(app, argc, argv);

  speak_last_words();
  if (!plugin.empty()) return describe(plugin, robot_file);
  if (daemon == 0 || !is_socket(kSocket)) {
    std::fputs("foothold-worker: footholdd starts this program; by hand use --describe PLUGIN\n", stderr);
    return 2;
  }
  if (!tie_to(daemon)) return 0;
  confine();
  return serve(kSocket);
}
