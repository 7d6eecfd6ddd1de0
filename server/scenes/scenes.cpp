// The server's scenes.
#include "scenes/scenes.hpp"

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "foothold/msg/errors.hpp"
#include "jobs/admission/admission.hpp"
#include "jobs/admission/limits.hpp"
#include "scenes/keeping.hpp"
#include "text/text.hpp"

namespace foothold::server {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMostClosed = 1000;
constexpr std::size_t kMostTold = 3000;  // of stored scenes at start: the topic keeps 4096 keys

std::string prepared(const std::string& folder) {
  fs::create_directories(folder);
  fs::remove_all(folder + "/incoming");
  fs::create_directories(folder + "/incoming");
  return folder;
}

std::vector<std::string> scene_files(const std::string& folder, std::vector<std::string>& complaints) {
  std::vector<std::string> files;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::string ending = entry->path().extension().string();
    const bool scene = ending == ".yaml" || ending == ".stl" || ending == ".obj" || ending == ".ply";
    if (scene && entry->is_regular_file()) files.push_back(entry->path().string());
  }
  if (error) complaints.push_back(folder + ": cannot be read: " + error.message());
  std::ranges::sort(files);
  return files;
}

// What a preloaded file is called. Reads all of it. Throws std::exception.
SceneLabel label_of(const std::string& file, std::uint64_t most) {
  const fs::path path(file);
  SceneLabel label{msg::kNoId, path.stem().string(), path.extension().string().substr(1), {}, fs::file_size(path)};
  if (label.size == 0 || label.size > most) throw std::runtime_error("must have 1 to " + std::to_string(most) + " octets");
  label.revision = file_sha256(file);
  return label;
}

void keep_copy(const std::string& file, const std::string& folder, const SceneLabel& label, const std::string& place) {
  const std::string copy = folder + "/incoming/" + label.revision;
  fs::copy_file(file, copy, fs::copy_options::overwrite_existing);
  if (const auto failure = keep_scene(copy, label.revision, label.format, place)) throw std::runtime_error(failure->message());
}

}  // namespace

Scenes::Scenes(ScenesOptions options, const Clock& clock)
    : options_(std::move(options)), clock_(clock), index_(prepared(options_.folder)) {}

Scenes::~Scenes() = default;

void Scenes::open(Hooks hooks) {
  hooks_ = std::move(hooks);
  const auto scenes = index_.all();
  const std::size_t first = scenes.size() > kMostTold ? scenes.size() - kMostTold : 0;
  for (std::size_t i = first; i < scenes.size(); ++i) hooks_.tell(status_of(scenes[i], msg::kNoId));
}

std::optional<StoredScene> Scenes::find(const std::string& name, const std::string& revision) const {
  const StoredScene* scene = index_.find(name, revision);
  return scene == nullptr ? std::nullopt : std::optional(*scene);
}

void Scenes::take(const msg::SceneChunk& chunk) {
  if (chunk.server() != msg::kNoId && chunk.server() != options_.server) return;
  if (closed_.contains(chunk.upload())) return;
  const SceneLabel said{chunk.upload(), chunk.name(), chunk.format(), chunk.revision(), chunk.size()};
  if (chunk.upload() == msg::kNoId) return refuse_upload(said, refuse(msg::MALFORMED, "upload", "must not be all zeros"));
  const auto known = uploads_.find(chunk.upload());
  const bool is_new = known == uploads_.end();
  if (auto error = check_chunk(chunk, options_.max_bytes, is_new ? nullptr : &known->second->label()))
    return refuse_upload(is_new ? said : known->second->label(), std::move(*error));
  if (is_new && uploads_.size() >= kMostUploads) {
    auto error = msg::make_error(msg::QUEUE_FULL, std::to_string(kMostUploads) + " scenes are being stored already");
    error.retry_after(std::chrono::duration<double>(kPatience).count());
    return refuse_upload(said, std::move(error));
  }
  try {
    auto& upload = uploads_[chunk.upload()];
    if (!upload) upload = std::make_unique<Upload>(said, options_.folder + "/incoming/" + msg::to_hex(said.upload));
    upload->last_chunk = clock_.now();
    if (!upload->add(chunk))
      refuse_upload(said, refuse(msg::MALFORMED, "offset", "leaves too many gaps: send the chunks in order"));
    else if (upload->complete())
      finish(std::move(upload));
  } catch (const std::system_error& error) {
    refuse_upload(said, msg::make_error(msg::STORAGE_FAILED, std::string("the scene could not be stored: ") + error.what()));
  }
}

void Scenes::finish(std::unique_ptr<Upload> upload) {
  const SceneLabel label = upload->label();
  close_upload(label.upload);
  upload->release();
  const auto failure = std::make_shared<std::optional<msg::Error>>();
  const std::string place = index_.path_of(label.revision, label.format);
  hooks_.background([=, file = upload->file()] { *failure = keep_scene(file, label.revision, label.format, place); },
                    [this, label, failure, alive = std::weak_ptr(alive_)] {
                      if (alive.expired()) return;
                      if (*failure)
                        refuse_upload(label, std::move(**failure));
                      else
                        stored(label);
                    });
}

void Scenes::stored(const SceneLabel& label) {
  const StoredScene scene{.name = label.name,
                          .revision = label.revision,
                          .format = label.format,
                          .path = index_.path_of(label.revision, label.format),
                          .size = label.size,
                          .stamp = clock_.stamp()};
  try {
    index_.add(scene);
  } catch (const sqlite::Error& error) {
    return refuse_upload(label, msg::make_error(msg::STORAGE_FAILED, error.what()));
  }
  hooks_.tell(status_of(scene, label.upload));
}

msg::SceneStatus Scenes::status_of(const StoredScene& scene, const Id& upload) const {
  msg::SceneStatus status;
  status.key(msg::id_of(msg::to_hex(options_.server) + "/scene/" + scene.revision + "/" + scene.name));
  status.upload(upload);
  status.server(options_.server);
  status.state(msg::STORED);
  status.name(scene.name);
  status.format(scene.format);
  status.revision(scene.revision);
  status.size(scene.size);
  status.stamp(scene.stamp);
  return status;
}

// `label` is a copy: the upload that it is of ends here. Keys of refusals go round: nobody ever takes a key back, and the topic
// keeps only so many.
void Scenes::refuse_upload(SceneLabel label, msg::Error error) {
  close_upload(label.upload);
  const bool nameable = label.name.size() <= limits::kScene && is_clean_text(label.name);
  msg::SceneStatus status;
  status.key(msg::id_of(msg::to_hex(options_.server) + "/refused/" + std::to_string(refusals_++ % kRefusedKeys)));
  status.upload(label.upload);
  status.server(options_.server);
  status.state(msg::REFUSED);
  status.name(nameable ? label.name : "");
  status.size(label.size);
  status.stamp(clock_.stamp());
  status.error(std::move(error));
  hooks_.tell(std::move(status));
}

void Scenes::close_upload(const Id& upload) {
  uploads_.erase(upload);
  if (upload == msg::kNoId || !closed_.insert(upload).second) return;
  closed_order_.push_back(upload);
  if (closed_order_.size() <= kMostClosed) return;
  closed_.erase(closed_order_.front());
  closed_order_.pop_front();
}

void Scenes::tick() {
  const Time now = clock_.now();
  std::vector<SceneLabel> late;
  for (const auto& [id, upload] : uploads_)
    if (now - upload->last_chunk >= kPatience) late.push_back(upload->label());
  for (const SceneLabel& label : late) {
    const Upload& upload = *uploads_.at(label.upload);
    refuse_upload(label, refuse(msg::SCENE_INCOMPLETE, "data",
                                "has only " + std::to_string(upload.received()) + " of " + std::to_string(label.size) +
                                    " octets, the first missing at offset " + std::to_string(upload.first_missing()) +
                                    ", and nothing came for 10 s"));
  }
}

std::optional<Time> Scenes::next_deadline() const {
  std::optional<Time> next;
  for (const auto& [id, upload] : uploads_)
    if (const Time at = upload->last_chunk + kPatience; !next || at < *next) next = at;
  return next;
}

std::vector<std::string> Scenes::preload(const std::string& folder) {
  std::vector<std::string> complaints;
  for (const auto& file : scene_files(folder, complaints))
    if (auto complaint = preload_file(file); !complaint.empty()) complaints.push_back(file + ": " + complaint);
  return complaints;
}

bool Scenes::is_newest(const SceneLabel& label) const {
  const StoredScene* newest = index_.find(label.name, "");
  return newest != nullptr && newest->revision == label.revision;
}

std::string Scenes::preload_file(const std::string& file) {
  try {
    const SceneLabel label = label_of(file, options_.max_bytes);
    if (is_newest(label)) return {};
    const std::string place = index_.path_of(label.revision, label.format);
    keep_copy(file, options_.folder, label, place);
    index_.add({.name = label.name,
                .revision = label.revision,
                .format = label.format,
                .path = place,
                .size = label.size,
                .stamp = clock_.stamp()});
    return {};
  } catch (const std::exception& error) {
    return error.what();
  }
}

void Scenes::preload_again(const std::string& folder, std::function<void(const std::string&)> complain) {
  struct Found {
    std::vector<std::string> complaints;
    std::vector<std::pair<std::string, SceneLabel>> files;
  };
  const auto found = std::make_shared<Found>();
  const auto look = [folder, found, most = options_.max_bytes] {
    for (const auto& file : scene_files(folder, found->complaints)) {
      try {
        found->files.emplace_back(file, label_of(file, most));
      } catch (const std::exception& error) {
        found->complaints.push_back(file + ": " + error.what());
      }
    }
  };
  hooks_.background(look, [this, found, complain, alive = std::weak_ptr(alive_)] {
    if (alive.expired()) return;
    for (const auto& complaint : found->complaints) complain(complaint);
    for (const auto& [file, label] : found->files) {
      if (is_newest(label)) continue;
      const auto failure = std::make_shared<std::string>();
      const auto keep = [=, name = file, said = label, state = options_.folder,
                         place = index_.path_of(label.revision, label.format)] {
        try {
          keep_copy(name, state, said, place);
        } catch (const std::exception& error) {
          *failure = name + ": " + error.what();
        }
      };
      hooks_.background(keep, [this, failure, complain, said = label, alive] {
        if (alive.expired()) return;
        if (failure->empty())
          stored(said);
        else
          complain(*failure);
      });
    }
  });
}

}  // namespace foothold::server
