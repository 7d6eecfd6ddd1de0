// foothold plugin info FILE: what a plugin holds, or why it would be refused. Asks foothold-worker, so that a plugin that crashes
// while it is loaded does not take this program along.
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "commands.hpp"
#include "terminal.hpp"

namespace foothold::cli {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

std::string worker_path() {
  if (const char* given = std::getenv("FOOTHOLD_WORKER"); given != nullptr && *given != '\0') return given;
  std::error_code fault;
  const fs::path here = fs::read_symlink("/proc/self/exe", fault).parent_path();
  for (const fs::path& path : {here / "foothold-worker", here.parent_path() / "libexec/foothold/foothold-worker",
                               here.parent_path() / "lib/foothold/foothold-worker"})
    if (fs::exists(path, fault)) return path.string();
  throw Complaint(Exit::kOther, "foothold-worker is not installed",
                  "it comes with the server; FOOTHOLD_WORKER may name another place");
}

// What the program wrote, and how it ended as waitpid() tells.
std::pair<std::string, int> run(std::vector<std::string> words) {
  int ends[2];
  if (pipe(ends) != 0) throw Complaint(Exit::kOther, "no pipe can be opened");
  const pid_t child = fork();
  if (child < 0) throw Complaint(Exit::kOther, "no process can be started");
  if (child == 0) {
    dup2(ends[1], STDOUT_FILENO);
    close(ends[0]);
    close(ends[1]);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  close(ends[1]);
  std::string said;
  char piece[4096];
  while (const ssize_t count = read(ends[0], piece, sizeof piece)) {
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) break;
    said.append(piece, static_cast<std::size_t>(count));
  }
  close(ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return {said, status};
}

std::string words(const Json& json) {
  if (json.is_string()) return printable(json.get<std::string>());
  if (!json.is_array()) return json.is_number_float() ? number(json.get<double>()) : json.dump();
  std::string text;
  for (const Json& item : json) text += (text.empty() ? "" : ", ") + words(item);
  return text.empty() ? "none" : text;
}

std::string range(const Json& parameter) {
  if (parameter.contains("choices")) return words(parameter["choices"]);
  if (!parameter.contains("minimum")) return words(parameter.value("kind", Json("")));
  const std::string unit = words(parameter.value("unit", Json("")));
  return words(parameter["minimum"]) + " to " + words(parameter["maximum"]) + (unit.empty() || unit == "1" ? "" : " " + unit);
}

void print_info(const Json& info) {
  std::vector<std::vector<std::string>> rows, parameters = {{"PARAMETER", "DEFAULT", "RANGE", "WHAT IT IS"}};
  for (const auto& [name, value] : info.items()) {
    if (name == "parameters")
      for (const Json& p : value)
        parameters.push_back({words(p.value("name", Json(""))), words(p.value("default", Json(""))), range(p),
                              words(p.value("description", Json("")))});
    else if (value.is_object())
      for (const auto& [part, number_of] : value.items()) rows.push_back({name + "." + part, words(number_of)});
    else
      rows.push_back({name, words(value)});
  }
  print_table(rows);
  std::puts("");
  print_table(parameters);
}

}  // namespace

Exit run_plugin_info(const Common& common, const PluginInfoOptions& options) {
  if (std::error_code fault; !fs::is_regular_file(options.file, fault))
    throw Complaint(Exit::kUsage, options.file + ": no such file");
  std::vector<std::string> command = {worker_path(), "--describe", fs::absolute(options.file).string()};
  if (!options.robot_file.empty()) command.insert(command.end(), {"--robot", options.robot_file});
  const auto [said, status] = run(command);
  if (WIFSIGNALED(status))
    throw Complaint(Exit::kCrashed, options.file + ": the plugin crashed while it was loaded: " + strsignal(WTERMSIG(status)));
  const Json info = Json::parse(said, nullptr, false);
  if (info.is_discarded() || !info.is_object())
    throw Complaint(Exit::kOther, command[0] + " gave no description (exit code " + std::to_string(WEXITSTATUS(status)) + ")");
  if (common.json) std::puts(info.dump().c_str());
  if (const auto refused = info.find("refused"); refused != info.end()) {
    if (common.json) return Exit::kRejected;
    throw Complaint(Exit::kRejected, options.file + ": refused: " + words(refused->value("message", Json(""))),
                    words(refused->value("hint", Json(""))));
  }
  if (!common.json) print_info(info);
  return Exit::kSucceeded;
}

}  // namespace foothold::cli
