// One planner at work: a request in, steps and one report out, whatever the plugin throws.
#pragma once

#include <memory>
#include <stop_token>
#include <string>

#include "foothold/export.hpp"
#include "worker/channel.hpp"
#include "worker/scene_cache.hpp"
#include "worker/schema.hpp"

namespace foothold::server {

// Thread rule: the thread that constructed it, which is the only one that the planner ever sees.
class Planning {
 public:
  // Throws what the planner's constructor throws. `robot` is what requests call it.
  Planning(std::string robot, const PluginDescriptor& plugin, const RobotModel& model);

  // Sends SCENE and STEPs; returns the report. Throws ChannelClosed only.
  frame::Report run(std::uint64_t run, const frame::Plan& plan, const std::stop_token& stop, Channel& channel);

 private:
  struct Attempt;
  frame::Report try_plan(std::uint64_t run, const frame::Plan& plan, const ParsedParameters& parameters,
                         const std::stop_token& stop, Channel& channel, Attempt& attempt);
  std::shared_ptr<const PreparedScene> prepared(const frame::Plan& plan, const ParsedParameters& parameters);
  void fill(msg::Summary& summary, const frame::Plan& plan, const ParsedParameters& parameters, const Attempt& attempt) const;

  std::string robot_;
  const PluginDescriptor& plugin_;
  std::unique_ptr<Planner, void (*)(Planner*)> planner_;
  SceneCache scenes_;
  // Given back when memory has run out, so that there is some left to say so.
  std::unique_ptr<char[]> ballast_;
};

}  // namespace foothold::server
