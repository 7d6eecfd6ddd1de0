// foothold scene put and list, and what `plan` needs of them.
#include "scene.hpp"

#include <ctime>
#include <filesystem>

#include "foothold/client/plan_file.hpp"
#include "foothold/client/whole_file.hpp"
#include "foothold/msg/times.hpp"
#include "terminal.hpp"

namespace foothold::cli {
namespace {

constexpr double kQuiet = 0.3;

std::string format_of(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  if (ending == ".yml") ending = ".yaml";
  for (const char* known : {".yaml", ".stl", ".obj", ".ply"})
    if (ending == known) return ending.substr(1);
  throw Complaint(Exit::kUsage, path + ": a scene file ends in .yaml, .stl, .obj or .ply");
}

std::string octets(std::uint64_t size) {
  if (size < 10'000) return std::to_string(size) + " B";
  return size < 10'000'000 ? format("%.1f kB", static_cast<double>(size) / 1e3)
                           : format("%.1f MB", static_cast<double>(size) / 1e6);
}

}  // namespace

msg::SceneStatus put_scene(const Connection& connection, const Common& common, const std::string& path, const std::string& name) {
  std::string contents;
  const std::string form = format_of(path);
  try {
    contents = client::read_whole_file(path);
  } catch (const std::system_error& error) {
    throw Complaint(Exit::kUsage, path + ": cannot be read: " + error.code().message());
  }
  const auto bytes = std::as_bytes(std::span(contents));
  // A megabyte a second is far below what loopback carries.
  const double seconds = common.timeout + static_cast<double>(bytes.size()) / 1e6;
  // Whichever server is asked later is to have it.
  if (connection.wanted == msg::kNoId) connection.client->wait_for_lists(common.timeout, kQuiet);
  const auto verdict = connection.client->upload(name, form, bytes, seconds, connection.wanted);
  if (!verdict) throw Complaint(Exit::kNoServer, path + ": the server did not answer within " + duration(seconds));
  return *verdict;
}

Exit run_scene_put(const Common& common, const ScenePutOptions& options) {
  const Connection connection = connect(common);
  const std::string name = options.name.empty() ? std::filesystem::path(options.file).stem().string() : options.name;
  const msg::SceneStatus verdict = put_scene(connection, common, options.file, name);
  if (common.json)
    std::puts(client::to_json_line(verdict).c_str());
  else if (verdict.state() == msg::STORED)
    std::printf("stored %s, %s, revision %s\n", name.c_str(), octets(verdict.size()).c_str(), verdict.revision().c_str());
  else
    print(verdict.error(), stderr);
  return verdict.state() == msg::STORED ? Exit::kSucceeded : Exit::kRejected;
}

Exit run_scene_list(const Common& common) {
  const Connection connection = connect(common);
  connection.client->wait_for_lists(common.timeout, kQuiet);
  std::vector<std::vector<std::string>> rows = {{"SCENE", "FORMAT", "SIZE", "STORED", "REVISION"}};
  for (const msg::SceneStatus& scene : connection.client->scenes()) {
    if (connection.wanted != msg::kNoId && scene.server() != connection.wanted) continue;
    if (common.json) std::puts(client::to_json_line(scene).c_str());
    rows.push_back({printable(scene.name()), printable(scene.format()), octets(scene.size()),
                    msg::local_text(scene.stamp() / 1'000'000'000), printable(scene.revision())});
  }
  if (common.json) return Exit::kSucceeded;
  if (rows.size() == 1)
    std::puts("no scenes; 'foothold scene put FILE' stores one");
  else
    print_table(rows);
  return Exit::kSucceeded;
}

}  // namespace foothold::cli
