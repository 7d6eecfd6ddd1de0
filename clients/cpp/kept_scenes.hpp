// Private: the files that this client has uploaded for every server, kept for servers that come later: servers hand each other
// nothing (idl/PROTOCOL.md P40).
#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>

#include "directory.hpp"
#include "outgoing.hpp"

namespace foothold::client {

// Thread rule: keep() and may_deliver() from any thread, tend() from the keeper's.
class KeptScenes {
 public:
  using Clock = Directory::Clock;
  static constexpr auto kSettle = std::chrono::seconds(1);   // in which a server that comes tells of the scenes that it has
  static constexpr auto kAnswer = std::chrono::seconds(10);  // in which it gives its verdict; then it is tried again,
  static constexpr int kTries = 3;                           // so often in all

  KeptScenes(Directory& directory, Outgoing& outgoing, std::size_t most_octets)
      : directory_(directory), outgoing_(outgoing), most_octets_(most_octets) {}

  // `label`: the chunk that names the file. It takes the place of what was kept under this name; beyond the bound what was kept the
  // longest goes.
  void keep(const msg::SceneChunk& label, std::span<const std::byte> octets);
  // Sends files to servers that have been there for kSettle and have told of no scene of that name; not one that was superseded
  // anywhere, for that it must not be again. True if some of a file waits to be sent.
  bool tend(Clock::time_point now);
  // A server other than these, which has the request's robot, is about to have its scene.
  bool may_deliver(const msg::PlanRequest& request, std::span<const msg::Id> except) const;

 private:
  struct File {
    msg::SceneChunk label;
    std::vector<std::uint8_t> octets;
    std::uint64_t turn = 0;
  };
  using FilePointer = std::shared_ptr<const File>;
  // One file on its way to one server.
  struct Delivery {
    FilePointer file;
    msg::SceneChunk chunk;
    std::size_t sent = 0;
    Clock::time_point begun;
  };

  void begin(Clock::time_point now);
  void send();
  bool ended(Clock::time_point now);
  bool is_owed(const File& file, const msg::Id& server) const;  // of mutex_

  Directory& directory_;
  Outgoing& outgoing_;
  const std::size_t most_octets_;
  mutable std::mutex mutex_;
  std::map<std::string, FilePointer> files_;                      // by name
  std::map<std::pair<std::string, msg::Id>, int> tried_in_vain_;  // by revision and server
  std::uint64_t turns_ = 0;
  std::optional<Delivery> delivery_;  // keeper only
};

}  // namespace foothold::client
