// What the fuzz targets share. A target is one parser of ours behind LLVMFuzzerTestOneInput(): it may refuse what it is given only
// in the way that its header says; every other exception, crash, leak or undefined behaviour is a finding.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <span>
#include <string>

#include "temporary_folder.hpp"

// Called by libFuzzer, or by replay.cpp in builds without it.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace foothold::fuzz {

inline std::string text_of(const std::uint8_t* data, std::size_t size) {
  return size == 0 ? std::string() : std::string(reinterpret_cast<const char*>(data), size);
}

inline std::span<const std::byte> octets_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const std::byte*>(data), size};
}

// Takes the input for a file of that name, for parsers that want one; gives its path. Each call replaces the contents.
inline std::string as_file(const std::string& name, std::span<const std::byte> octets) {
  static const test::TemporaryFolder kFolder;
  const std::string path = kFolder / name;
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  out.write(reinterpret_cast<const char*>(octets.data()), static_cast<std::streamsize>(octets.size()));
  if (!out.flush()) throw std::runtime_error(path + " cannot be written");
  return path;
}

// A property of the parser that does not hold is a finding like a crash.
inline void demand(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "fuzz: does not hold: %s\n", what);
  std::abort();
}

}  // namespace foothold::fuzz
