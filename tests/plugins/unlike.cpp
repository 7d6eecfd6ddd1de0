// Hands over a layout that is not the server's: which member differs is set by FOOTHOLD_UNLIKE, and its value is doubled.
#include "walker.hpp"

namespace {

using namespace foothold;

constexpr PluginDescriptor make_descriptor() {
  PluginDescriptor descriptor;
  descriptor.abi = this_abi();
  descriptor.abi.FOOTHOLD_UNLIKE *= 2;
  descriptor.info.name = "unlike";
  descriptor.info.version = "1.0.0";
  return descriptor;
}

constexpr PluginDescriptor kDescriptor = make_descriptor();

}  // namespace

extern "C" __attribute__((visibility("default"))) const PluginDescriptor* foothold_plugin_1() { return &kDescriptor; }
