// A file goes up in pieces of 64 kB, once for all servers; each answers when it has them all. P26, P27, P40.
#include <algorithm>
#include <thread>

#include "client_impl.hpp"
#include "scene_piece.hpp"

namespace foothold::client {
namespace {

using Clock = std::chrono::steady_clock;

constexpr auto kFullPause = std::chrono::milliseconds(1);
constexpr auto kOwnAnswer = std::chrono::seconds(1);

double until(Clock::time_point end) { return std::chrono::duration<double>(end - Clock::now()).count(); }

}  // namespace

std::optional<msg::SceneStatus> Client::upload(const std::string& name, const std::string& format, std::span<const std::byte> bytes,
                                               double seconds, const msg::Id& server) {
  const auto end = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
  if (!wait_for_server(seconds, server)) return std::nullopt;
  while (impl_->outgoing->scene_matched() == 0) {
    if (until(end) <= 0.0) return std::nullopt;
    std::this_thread::sleep_for(kFullPause);
  }
  msg::SceneChunk chunk;
  chunk.upload(msg::random_id());
  chunk.client(id());
  chunk.server(server);
  const std::vector<msg::Id> servers = server == msg::kNoId ? impl_->directory.alive() : std::vector{server};
  chunk.name(name);
  chunk.format(format);
  chunk.revision(msg::sha256_hex({reinterpret_cast<const char*>(bytes.data()), bytes.size()}));
  chunk.size(bytes.size());
  Directory& directory = impl_->directory;
  directory.expect(chunk.upload());
  std::optional<msg::SceneStatus> verdict;
  std::size_t offset = 0;
  do {
    const std::size_t next = put_piece(chunk, bytes, offset);
    while (!impl_->outgoing->try_send(chunk) && until(end) > 0.0) std::this_thread::sleep_for(kFullPause);
    offset = next;
    verdict = directory.verdict(chunk.upload(), servers, name, chunk.revision(), false);
  } while (offset < bytes.size() && until(end) > 0.0 && !verdict);
  // Somebody else who stores the same file at this moment may be the one whom the server's last word is for.
  const auto sent = Clock::now();
  while (until(end) > 0.0 && !verdict) {
    directory.wait_change(std::min(until(end), 0.05));
    verdict = directory.verdict(chunk.upload(), servers, name, chunk.revision(), Clock::now() - sent > kOwnAnswer);
  }
  directory.forget(chunk.upload());
  if (server == msg::kNoId && verdict && verdict->state() == msg::STORED) impl_->kept_scenes.keep(chunk, bytes);
  return verdict;
}

}  // namespace foothold::client
