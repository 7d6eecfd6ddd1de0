// Which scenes are stored: names and their revisions, in a small database beside the files, and all of it in memory.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "jobs/ports.hpp"
#include "sqlite/sqlite.hpp"

namespace foothold::server {

// Thread rule: the loop.
class SceneIndex {
 public:
  // `folder`: of the scene files; the database is index.db in it. Entries whose file is gone are left out. Throws sqlite::Error.
  explicit SceneIndex(std::string folder);

  // The same name and revision again becomes the name's newest. Throws sqlite::Error.
  void add(const StoredScene& scene);
  bool knows(const std::string& name) const { return names_.contains(name); }
  // Empty revision: the newest. Nothing if there is none.
  const StoredScene* find(const std::string& name, const std::string& revision) const;
  std::vector<StoredScene> all() const;  // in the order of storing
  std::string path_of(const std::string& revision, const std::string& format) const;

 private:
  void remember(StoredScene scene);

  std::string folder_;
  sqlite::Database database_;
  std::map<std::string, std::vector<StoredScene>, std::less<>> names_;  // each name's revisions, the newest last
};

}  // namespace foothold::server
