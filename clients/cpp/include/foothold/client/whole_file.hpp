// A file's octets at once.
#pragma once

#include <cerrno>
#include <cstdio>
#include <memory>
#include <string>
#include <system_error>

namespace foothold::client {

// Throws std::system_error with the operating system's reason, also for a folder.
inline std::string read_whole_file(const std::string& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             [](std::FILE* f) { return f ? std::fclose(f) : 0; });
  if (!file) throw std::system_error(errno, std::generic_category());
  std::string text;
  char piece[65536];
  while (const std::size_t count = std::fread(piece, 1, sizeof piece, file.get())) text.append(piece, count);
  if (std::ferror(file.get())) throw std::system_error(errno, std::generic_category());
  return text;
}

}  // namespace foothold::client
