// dlopen, the entry point, and the comparison of two layouts member by member.
#include "worker/loader.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <cstring>
#include <string_view>

namespace foothold::server {
namespace {

struct SizeOf {
  const char* what;
  std::uint32_t PluginAbi::*member;
};

constexpr SizeOf kSizes[] = {{"Step", &PluginAbi::sizeof_step},
                             {"Request", &PluginAbi::sizeof_request},
                             {"PlanReport", &PluginAbi::sizeof_report},
                             {"Shape", &PluginAbi::sizeof_shape},
                             {"PlanContext", &PluginAbi::sizeof_context},
                             {"PlannerInfo", &PluginAbi::sizeof_info},
                             {"ParameterSpec", &PluginAbi::sizeof_spec},
                             {"StepVerdict", &PluginAbi::sizeof_verdict},
                             {"Scene", &PluginAbi::sizeof_scene},
                             {"RobotModel", &PluginAbi::sizeof_model},
                             {"Parameters", &PluginAbi::sizeof_parameters}};

std::string_view compiler_name(const PluginAbi& abi) { return {abi.compiler, strnlen(abi.compiler, sizeof(abi.compiler))}; }

// "gcc 12.2.0" gives "gcc 12": vendor and major version decide about layout.
std::string_view vendor_and_major(std::string_view compiler) {
  const auto number = compiler.find_first_of("0123456789");
  if (number == std::string_view::npos) return compiler;
  return compiler.substr(0, std::min(compiler.find('.', number), compiler.size()));
}

std::string octets(std::uint32_t count) { return std::to_string(count) + " octets"; }

}  // namespace

std::optional<std::string> abi_mismatch(const PluginAbi& theirs, const PluginAbi& ours) {
  if (theirs.api_version != ours.api_version)
    return "was built for API version " + std::to_string(theirs.api_version) + ", this server has " +
           std::to_string(ours.api_version);
  if (theirs.size != ours.size) return "describes its layout in " + octets(theirs.size) + ", this server in " + octets(ours.size);
  const auto their_compiler = compiler_name(theirs), our_compiler = compiler_name(ours);
  if (vendor_and_major(their_compiler) != vendor_and_major(our_compiler))
    return "was built by " + std::string(their_compiler) + ", this server by " + std::string(our_compiler);
  if (theirs.cxx11_abi != ours.cxx11_abi)
    return "was built with _GLIBCXX_USE_CXX11_ABI=" + std::to_string(theirs.cxx11_abi) + ", this server with " +
           std::to_string(ours.cxx11_abi);
  if (theirs.eigen_max_align != ours.eigen_max_align)
    return "was built with Eigen aligned to " + octets(theirs.eigen_max_align) + ", this server to " +
           octets(ours.eigen_max_align) + ": use the same -m options";
  if (theirs.alignof_step != ours.alignof_step)
    return "aligns Step to " + octets(theirs.alignof_step) + ", this server to " + octets(ours.alignof_step);
  for (const SizeOf& size : kSizes)
    if (theirs.*size.member != ours.*size.member)
      return "has a " + std::string(size.what) + " of " + octets(theirs.*size.member) + ", this server one of " +
             octets(ours.*size.member);
  return std::nullopt;
}

const PluginDescriptor& load_plugin(const std::string& path) {
  // A name without a slash would be searched in the system's library folders.
  if (path.find('/') == std::string::npos) throw PluginRefused(path + " is not a path: write ./" + path);
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (library == nullptr) throw PluginRefused(dlerror());
  using Entry = const PluginDescriptor* (*)();
  const auto entry = reinterpret_cast<Entry>(dlsym(library, kEntryPoint));
  if (entry == nullptr) throw PluginRefused(path + " has no function " + kEntryPoint + ": is FOOTHOLD_EXPORT_PLANNER missing?");
  const PluginDescriptor* descriptor = entry();
  if (descriptor == nullptr) throw PluginRefused(path + ": " + kEntryPoint + "() returned a null pointer");
  if (const auto difference = abi_mismatch(descriptor->abi)) throw PluginRefused(path + " " + *difference);
  if (descriptor->create == nullptr || descriptor->destroy == nullptr)
    throw PluginRefused(path + " hands over no function that makes or destroys its planner");
  return *descriptor;
}

}  // namespace foothold::server
