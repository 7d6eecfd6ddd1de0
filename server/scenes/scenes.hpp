// The server's scenes: receives them in chunks, keeps them as files named by their SHA-256, knows them by name
// (idl/PROTOCOL.md P26 to P28).
//
// Thread rule: the loop. The look at a whole file (hash, syntax) and the wait for the disk go to `background`.
#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "jobs/ports.hpp"
#include "scenes/index.hpp"
#include "scenes/upload.hpp"

namespace foothold::server {

struct ScenesOptions {
  Id server{};
  std::string folder;
  std::uint64_t max_bytes = 64u << 20;
};

class Scenes final : public SceneShelf {
 public:
  static constexpr auto kPatience = std::chrono::seconds(10);  // between two chunks
  static constexpr std::size_t kMostUploads = 16;              // at the same time
  static constexpr std::size_t kRefusedKeys = 64;              // refusals that late readers can still see

  struct Hooks {
    std::function<void(msg::SceneStatus)> tell;
    // Runs the first function anywhere but on the loop, then the second on the loop.
    std::function<void(std::function<void()>, std::function<void()>)> background;
  };

  // Makes the folder, and forgets uploads that a server before this one left unfinished. Throws sqlite::Error, std::system_error.
  Scenes(ScenesOptions options, const Clock& clock);
  ~Scenes() override;

  // Before the first take(): whom to tell. Tells of every scene that is stored.
  void open(Hooks hooks);
  // Stores the scene files (*.yaml, *.stl, *.obj, *.ply) of a folder, each under its stem; those that are stored already stay as
  // they are. Gives a sentence for each that cannot be. Waits for the disk.
  std::vector<std::string> preload(const std::string& folder);

  // The same while serving: looks at the files in the background, stores the new ones and tells of them. `complain`: on the loop.
  void preload_again(const std::string& folder, std::function<void(const std::string&)> complain);
  void set_max_bytes(std::uint64_t bytes) { options_.max_bytes = bytes; }

  void take(const msg::SceneChunk& chunk);
  // Gives up uploads whose chunks stopped coming.
  void tick();
  std::optional<Time> next_deadline() const;

  bool knows(const std::string& name) const override { return index_.knows(name); }
  std::optional<StoredScene> find(const std::string& name, const std::string& revision) const override;

 private:
  void finish(std::unique_ptr<Upload> upload);
  void stored(const SceneLabel& label);
  void refuse_upload(SceneLabel label, msg::Error error);
  void close_upload(const Id& upload);
  msg::SceneStatus status_of(const StoredScene& scene, const Id& upload) const;
  std::string preload_file(const std::string& file);
  bool is_newest(const SceneLabel& label) const;

  ScenesOptions options_;
  const Clock& clock_;
  Hooks hooks_;
  SceneIndex index_;
  std::unordered_map<Id, std::unique_ptr<Upload>, msg::IdHash> uploads_;
  // Uploads that have ended: their other chunks may still be on the way.
  std::unordered_set<Id, msg::IdHash> closed_;
  std::deque<Id> closed_order_;
  std::uint64_t refusals_ = 0;
  std::shared_ptr<bool> alive_ = std::make_shared<bool>(true);
};

}  // namespace foothold::server
