// Which scenes are stored.
#include "scenes/index.hpp"

#include <algorithm>
#include <filesystem>

namespace foothold::server {
namespace {

constexpr const char* kSchema = R"(
  PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL;
  CREATE TABLE IF NOT EXISTS scene (name TEXT NOT NULL, revision TEXT NOT NULL, format TEXT NOT NULL, size INTEGER NOT NULL,
                                    stamp INTEGER NOT NULL, PRIMARY KEY (name, revision)) WITHOUT ROWID;
)";

}  // namespace

SceneIndex::SceneIndex(std::string folder) : folder_(std::move(folder)), database_(folder_ + "/index.db") {
  database_.run(kSchema);
  auto rows = database_.prepare("SELECT name, revision, format, size, stamp FROM scene ORDER BY stamp");
  while (rows.step()) {
    StoredScene scene{.name = rows.text(0), .revision = rows.text(1), .format = rows.text(2)};
    scene.size = static_cast<std::uint64_t>(rows.integer(3));
    scene.stamp = rows.integer(4);
    scene.path = path_of(scene.revision, scene.format);
    std::error_code ignored;
    if (std::filesystem::file_size(scene.path, ignored) == scene.size) remember(std::move(scene));
  }
}

std::string SceneIndex::path_of(const std::string& revision, const std::string& format) const {
  return folder_ + "/" + revision + "." + format;
}

void SceneIndex::add(const StoredScene& scene) {
  auto insert = database_.prepare("INSERT OR REPLACE INTO scene VALUES (?, ?, ?, ?, ?)");
  insert.bind(1, std::string_view(scene.name)).bind(2, std::string_view(scene.revision)).bind(3, std::string_view(scene.format));
  insert.bind(4, static_cast<std::int64_t>(scene.size)).bind(5, scene.stamp).run();
  remember(scene);
}

void SceneIndex::remember(StoredScene scene) {
  auto& revisions = names_[scene.name];
  std::erase_if(revisions, [&](const auto& known) { return known.revision == scene.revision; });
  revisions.push_back(std::move(scene));
}

const StoredScene* SceneIndex::find(const std::string& name, const std::string& revision) const {
  const auto found = names_.find(name);
  if (found == names_.end()) return nullptr;
  if (revision.empty()) return &found->second.back();
  const auto scene = std::ranges::find(found->second, revision, &StoredScene::revision);
  return scene == found->second.end() ? nullptr : &*scene;
}

std::vector<StoredScene> SceneIndex::all() const {
  std::vector<StoredScene> scenes;
  for (const auto& [name, revisions] : names_) scenes.insert(scenes.end(), revisions.begin(), revisions.end());
  std::ranges::sort(scenes, {}, &StoredScene::stamp);
  return scenes;
}

}  // namespace foothold::server
