// Judges plans of the journal by their planners' check() once more, in this process: apart from the workers that made them, from
// the octets that a client would execute.
#pragma once

#include <foothold.h>

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "foothold/export.hpp"
#include "foothold/msg/cdr.hpp"
#include "foothold/planner.hpp"

namespace foothold::faults {

// Thread rule: one thread.
class Judge {
 public:
  // Folders of planners (<robot>.so), of robots' files (<robot>.yaml) and of stored scenes (<revision>.yaml).
  Judge(std::string plugins, std::string robots, std::string scenes);

  bool knows(const std::string& robot) const;
  // The first step that the planner does not accept behind the ones before it, and why; nothing if all are sound. `steps`: CDR of
  // Step, from 0 on.
  std::optional<std::string> refusal(const msg::PlanRequest& request, std::span<const msg::Bytes> steps);

 private:
  struct Robot {
    const PluginDescriptor* plugin = nullptr;
    std::unique_ptr<Planner, void (*)(Planner*)> planner{nullptr, nullptr};
    std::map<std::string, std::shared_ptr<const PreparedScene>> scenes;
  };
  Robot& robot(const std::string& name);

  std::string plugins_, robot_files_, scene_files_;
  std::map<std::string, Robot> robots_;
};

}  // namespace foothold::faults
