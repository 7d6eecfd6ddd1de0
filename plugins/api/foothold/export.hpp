// How a planner leaves its shared library: one C function that hands over plain data, judged before anything of it is called.
//
//   class MyPlanner : public foothold::Planner { public: explicit MyPlanner(const foothold::RobotModel&); ... };
//   FOOTHOLD_EXPORT_PLANNER(MyPlanner, (foothold::PlannerInfo{.name = "mine", .version = "1.0.0", ...}))
//
// The host refuses the library in one sentence that holds both values if API version, sizes, alignments, compiler, standard library
// or Eigen's alignment differ from its own (server/worker/loader.hpp).
#pragma once

#include <cstddef>
#include <cstdint>

#include "foothold/planner.hpp"

namespace foothold {

// Raised whenever a type of this folder changes its layout or meaning.
inline constexpr std::uint32_t kApiVersion = 1;

// What a planner says of itself. Static lifetime, plain data only.
struct PlannerInfo {
  const char* name = "";
  const char* version = "";
  const char* description = "";  // one line
  const char* joints = "";       // names separated by '|'
  const char* limbs = "";        // names separated by '|'
  const char* start_needs = "";  // which parts of a Placement are read, for people
  const char* goal_needs = "";
  const char* prepare_parameters = "";  // parameters that prepare() reads, separated by '|'
  const ParameterSpec* parameters = nullptr;
  std::size_t parameter_count = 0;
};

// The layout that both sides must share. Its own first two members never change place.
struct PluginAbi {
  std::uint32_t size = 0;  // of this struct
  std::uint32_t api_version = 0;
  std::uint32_t sizeof_step = 0, alignof_step = 0;
  std::uint32_t sizeof_request = 0, sizeof_report = 0, sizeof_shape = 0, sizeof_context = 0;
  std::uint32_t sizeof_info = 0, sizeof_spec = 0, sizeof_verdict = 0, sizeof_scene = 0, sizeof_model = 0, sizeof_parameters = 0;
  std::uint32_t eigen_max_align = 0;
  std::uint32_t cxx11_abi = 0;
  char compiler[24] = {};  // "gcc 12.2.0"; vendor and major version are compared
};

struct PluginDescriptor {
  PluginAbi abi;
  PlannerInfo info;
  Planner* (*create)(const RobotModel& model) = nullptr;  // may throw InvalidModel
  void (*destroy)(Planner* planner) = nullptr;
};

// The layout as the translation unit that calls it sees it.
constexpr PluginAbi this_abi() {
  PluginAbi abi;
  abi.size = sizeof(PluginAbi);
  abi.api_version = kApiVersion;
  abi.sizeof_step = sizeof(Step);
  abi.alignof_step = alignof(Step);
  abi.sizeof_request = sizeof(Request);
  abi.sizeof_report = sizeof(PlanReport);
  abi.sizeof_shape = sizeof(Shape);
  abi.sizeof_context = sizeof(PlanContext);
  abi.sizeof_info = sizeof(PlannerInfo);
  abi.sizeof_spec = sizeof(ParameterSpec);
  abi.sizeof_verdict = sizeof(StepVerdict);
  abi.sizeof_scene = sizeof(Scene);
  abi.sizeof_model = sizeof(RobotModel);
  abi.sizeof_parameters = sizeof(Parameters);
  abi.eigen_max_align = EIGEN_MAX_ALIGN_BYTES;
  abi.cxx11_abi = _GLIBCXX_USE_CXX11_ABI;
  constexpr char name[] =
#if defined(__clang__)
      "clang " __clang_version__;
#else
      "gcc " __VERSION__;
#endif
  for (std::size_t i = 0; i + 1 < sizeof(abi.compiler) && i + 1 < sizeof(name); ++i) abi.compiler[i] = name[i];
  return abi;
}

inline constexpr char kEntryPoint[] = "foothold_plugin_1";

}  // namespace foothold

#define FOOTHOLD_EXPORT_PLANNER(PlannerClass, ...)                                                            \
  extern "C" __attribute__((visibility("default"))) const ::foothold::PluginDescriptor* foothold_plugin_1() { \
    static const ::foothold::PluginDescriptor descriptor{                                                     \
        ::foothold::this_abi(), __VA_ARGS__,                                                                  \
        [](const ::foothold::RobotModel& model) -> ::foothold::Planner* { return new PlannerClass(model); },  \
        [](::foothold::Planner* planner) { delete planner; }};                                                \
    return &descriptor;                                                                                       \
  }
