// Private: a scene's file goes up in pieces of 64 kB. P26.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "foothold/client/client.hpp"

namespace foothold::client {

inline constexpr std::size_t kScenePiece = 65536;

// Makes `chunk` the piece of the file that begins at `offset`; where the next one begins.
inline std::size_t put_piece(msg::SceneChunk& chunk, std::span<const std::byte> file, std::size_t offset) {
  const auto piece = file.subspan(offset, std::min(kScenePiece, file.size() - offset));
  chunk.offset(offset);
  const auto* octets = reinterpret_cast<const std::uint8_t*>(piece.data());
  chunk.data().assign(octets, octets + piece.size());
  return offset + piece.size();
}

}  // namespace foothold::client
