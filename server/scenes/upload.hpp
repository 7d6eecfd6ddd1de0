// One scene file on its way in: chunks in any order into a temporary file.
#pragma once

#include <foothold.h>

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "jobs/ports.hpp"

namespace foothold::server {

// What an upload says of itself with every chunk.
struct SceneLabel {
  Id upload{};
  std::string name, format, revision;
  std::uint64_t size = 0;
};

class Upload {
 public:
  static constexpr std::size_t kMostGaps = 4096;

  // Makes the temporary file. Throws std::system_error.
  Upload(SceneLabel label, std::string file);
  ~Upload();
  Upload(const Upload&) = delete;
  Upload& operator=(const Upload&) = delete;

  // Precondition: check_chunk() found nothing. False if there would be too many gaps. Throws std::system_error (disk full).
  bool add(const msg::SceneChunk& chunk);
  bool complete() const;
  std::uint64_t first_missing() const;
  std::uint64_t received() const;  // octets, those that came twice counted once

  const SceneLabel& label() const { return label_; }
  const std::string& file() const { return file_; }
  // Leaves the temporary file to somebody else. Closes it.
  void release();

  Time last_chunk{};

 private:
  SceneLabel label_;
  std::string file_;
  int descriptor_ = -1;
  std::map<std::uint64_t, std::uint64_t> pieces_;  // begin to end, apart from each other
};

// What is wrong with a chunk: by itself, or beside what the upload's first chunk said. Any thread.
std::optional<msg::Error> check_chunk(const msg::SceneChunk& chunk, std::uint64_t max_bytes, const SceneLabel* label);

}  // namespace foothold::server
