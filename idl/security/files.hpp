// Files of credentials: read whole, written new and never over another.
#pragma once

#include <filesystem>
#include <string>

#include "foothold/security/error.hpp"

namespace foothold::security {

// Throws SecurityError, with the advice where credentials come from if it is not there.
std::string read_file(const std::filesystem::path& path);

enum class Access : unsigned { kOwner = 0600, kEverybody = 0644 };
// A new file, never seen by anybody in another mode. Throws SecurityError, also if it is there already.
void write_new(const std::filesystem::path& path, const std::string& text, Access access);
// In one step: whoever reads it meanwhile has the old one or the new one whole.
void replace(const std::filesystem::path& path, const std::string& text, Access access);

// A folder for the owner alone, 0700. One that is there must be empty and is set so.
void make_private_folder(const std::filesystem::path& path);

// Removes a folder that this process has made, unless it is kept: no half of it remains after an error.
class Unfinished {
 public:
  explicit Unfinished(std::filesystem::path folder) : folder_(std::move(folder)) {}
  ~Unfinished();
  Unfinished(const Unfinished&) = delete;
  Unfinished& operator=(const Unfinished&) = delete;
  void keep() { kept_ = true; }

 private:
  std::filesystem::path folder_;
  bool kept_ = false;
};

}  // namespace foothold::security
