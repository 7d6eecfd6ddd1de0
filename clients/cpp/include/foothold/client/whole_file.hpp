// A file's octets at once, in and out.
#pragma once

#include <cerrno>
#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
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

// Written beside and renamed: the file is whole or not there. Throws std::system_error.
inline void write_whole_file(const std::string& path, std::string_view text) {
  const std::string beside = path + ".part";
  std::FILE* file = std::fopen(beside.c_str(), "wb");
  if (file == nullptr) throw std::system_error(errno, std::generic_category());
  const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
  const int reason = errno;
  const bool closed = std::fclose(file) == 0;
  if (written && closed && std::rename(beside.c_str(), path.c_str()) == 0) return;
  const std::error_code fault(written ? errno : reason, std::generic_category());
  std::remove(beside.c_str());
  throw std::system_error(fault);
}

}  // namespace foothold::client
