// One file after the other, to one server after the other.
#include "kept_scenes.hpp"

#include <algorithm>

#include "scene_piece.hpp"

namespace foothold::client {
namespace {

constexpr std::size_t kPiecesAtOnce = 16;

}  // namespace

void KeptScenes::keep(const msg::SceneChunk& label, std::span<const std::byte> octets) {
  const std::lock_guard lock(mutex_);
  files_.erase(label.name());
  if (octets.size() > most_octets_) return;
  auto file = std::make_shared<File>(File{label, {}, turns_++});
  file->label.data().clear();
  const auto* begin = reinterpret_cast<const std::uint8_t*>(octets.data());
  file->octets.assign(begin, begin + octets.size());
  files_[label.name()] = std::move(file);
  const auto total = [&] {
    std::size_t sum = 0;
    for (const auto& [name, kept] : files_) sum += kept->octets.size();
    return sum;
  };
  while (total() > most_octets_)
    files_.erase(std::ranges::min_element(files_, {}, [](const auto& entry) { return entry.second->turn; }));
}

bool KeptScenes::is_owed(const File& file, const msg::Id& server) const {
  const auto tried = tried_in_vain_.find({file.label.revision(), server});
  return (tried == tried_in_vain_.end() || tried->second < kTries) &&
         !directory_.is_superseded(file.label.name(), file.label.revision());
}

bool KeptScenes::tend(Clock::time_point now) {
  if (delivery_ && ended(now)) delivery_.reset();
  if (!delivery_) begin(now);
  if (delivery_) send();
  return delivery_ && delivery_->sent < delivery_->file->octets.size();
}

void KeptScenes::begin(Clock::time_point now) {
  const std::lock_guard lock(mutex_);
  for (const auto& [name, file] : files_) {
    for (const msg::Id& server : directory_.without_scene(name, now - kSettle)) {
      if (!is_owed(*file, server)) continue;
      delivery_ = {file, file->label, 0, now};
      delivery_->chunk.upload(msg::random_id());
      delivery_->chunk.server(server);
      directory_.expect(delivery_->chunk.upload());
      return;
    }
  }
}

void KeptScenes::send() {
  const auto& octets = delivery_->file->octets;
  msg::SceneChunk& chunk = delivery_->chunk;
  for (std::size_t piece = 0; piece < kPiecesAtOnce && delivery_->sent < octets.size(); ++piece) {
    const std::size_t end = put_piece(chunk, std::as_bytes(std::span(octets)), delivery_->sent);
    if (!outgoing_.try_send(chunk)) return;
    delivery_->sent = end;
  }
}

// Stored, refused, without a verdict for too long, or without the server.
bool KeptScenes::ended(Clock::time_point now) {
  const msg::SceneChunk& chunk = delivery_->chunk;
  const msg::Id server = chunk.server();
  const auto verdict = directory_.verdict(chunk.upload(), std::span(&server, 1), chunk.name(), chunk.revision(), true);
  const bool lost = !directory_.is_there(server);
  if (!verdict && !lost && now - delivery_->begun < kAnswer) return false;
  directory_.forget(chunk.upload());
  const std::lock_guard lock(mutex_);
  const std::pair goal(chunk.revision(), server);
  if (lost || (verdict && verdict->state() == msg::STORED))
    tried_in_vain_.erase(goal);
  else
    tried_in_vain_[goal] += verdict ? kTries : 1;  // a refusal stays one
  return true;
}

bool KeptScenes::may_deliver(const msg::PlanRequest& request, std::span<const msg::Id> except) const {
  const std::lock_guard lock(mutex_);
  const auto file = files_.find(request.scene());
  if (file == files_.end()) return false;
  if (!request.scene_revision().empty() && request.scene_revision() != file->second->label.revision()) return false;
  return std::ranges::any_of(directory_.without_scene(request.scene(), Clock::time_point::max()), [&](const msg::Id& server) {
    return std::ranges::find(except, server) == except.end() && directory_.robot(request.robot(), server) &&
           is_owed(*file->second, server);
  });
}

}  // namespace foothold::client
