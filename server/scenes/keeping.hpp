// Looks at a whole scene file and keeps it: hash, syntax, and the move to its place. Waits for the disk: not for the loop.
#pragma once

#include <foothold.h>

#include <cstdint>
#include <optional>
#include <string>

namespace foothold::server {

// Text scenes are read as a whole by every worker that plans in them.
inline constexpr std::uint64_t kMostYamlOctets = 8u << 20;

// SHA-256 of a file as 64 lower-case hexadecimal digits. Throws std::system_error.
std::string file_sha256(const std::string& file);

// Where the YAML of this file is no YAML: INVALID_SCENE with the line. Nothing if it is some.
std::optional<msg::Error> check_yaml(const std::string& file);

// Moves `file`, which says to be `revision`, to `place`; the disk holds either all of it there or nothing. SCENE_HASH_MISMATCH,
// INVALID_SCENE, SCENE_TOO_LARGE or STORAGE_FAILED if that cannot be; `file` is then gone. Any thread.
std::optional<msg::Error> keep_scene(const std::string& file, const std::string& revision, const std::string& format,
                                     const std::string& place);

}  // namespace foothold::server
