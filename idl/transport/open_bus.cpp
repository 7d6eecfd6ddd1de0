// Finds and loads a vendor's library, and opens a bus with it.
#include <dlfcn.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "foothold/security/credentials.hpp"
#include "foothold/transport/bus.hpp"

namespace foothold::transport {
namespace {

// FOOTHOLD_BUS_DIR alone if it is set; else beside the program (../lib of a build, ../lib/foothold of an installation), then the
// folder of the installation, then wherever the loader looks.
std::vector<std::string> candidates(const std::string& file) {
  if (const char* folder = std::getenv("FOOTHOLD_BUS_DIR"); folder != nullptr && *folder != '\0') {
    return {(std::filesystem::path(folder) / file).string()};
  }
  std::vector<std::string> paths;
  std::error_code fault;
  const auto look = [&](const std::filesystem::path& folder) {
    if (std::filesystem::exists(folder / file, fault)) paths.push_back((folder / file).string());
  };
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", fault);
  if (!fault) {
    const std::filesystem::path libraries = program.parent_path().parent_path() / "lib";
    look(libraries);
    look(libraries / "foothold");
  }
  look(FOOTHOLD_INSTALLED_BUS_DIR);
  paths.push_back(file);
  return paths;
}

OpenBus load(const std::string& vendor) {
  const std::string file = "libfoothold_bus_" + vendor + ".so";
  std::string faults;
  for (const std::string& path : candidates(file)) {
    // Vendor threads may still leave their code after a bus was closed: it is never unloaded.
    void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
    if (library == nullptr) {
      faults += std::string("; ") + dlerror();
      continue;
    }
    if (void* symbol = dlsym(library, "foothold_open_bus_1")) return reinterpret_cast<OpenBus>(symbol);
    faults += "; " + path + " has no foothold_open_bus_1: it is of another version";
  }
  throw BusError("cannot load the DDS vendor '" + vendor + "'" + faults);
}

}  // namespace

std::unique_ptr<Bus> open_bus(const BusOptions& options) {
  if (options.vendor != "cyclone" && options.vendor != "fastdds") {
    throw BusError("dds: '" + options.vendor + "' is no vendor; known are cyclone and fastdds");
  }
  if (options.domain > kMaxDomain) {
    throw BusError("domain: " + std::to_string(options.domain) + " is above " + std::to_string(kMaxDomain));
  }
  if (!options.security.empty()) {
    try {
      security::read_credentials(options.security, options.vendor);
    } catch (const security::SecurityError& error) {
      throw BusError(std::string("security: ") + error.what());
    }
  }
  return std::unique_ptr<Bus>(load(options.vendor)(options));
}

}  // namespace foothold::transport
