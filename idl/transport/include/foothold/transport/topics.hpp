// The topics of foothold: name, type, quality of service and who writes. One table for both vendors.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace foothold::transport {

enum class Topic : std::uint8_t { kRequest, kCancel, kQuery, kEvent, kStep, kScene, kSceneStatus, kRobot, kServer };
inline constexpr std::size_t kTopicCount = 9;

struct TopicTraits {
  Topic topic;
  std::string_view name;
  std::string_view type;  // the IDL's, with module
  bool keyed;             // by its first member, a Uuid
  bool transient_local;   // late readers get what is kept
  bool keep_last_one;     // else keep all, within `history`
  std::int32_t history;   // samples (and, if keyed, instances) kept at most
  bool liveliness;        // MANUAL_BY_TOPIC, 1 s
};

// Reliable, every one.
inline constexpr TopicTraits kTopics[kTopicCount] = {
    {Topic::kRequest, "foothold/request", "foothold::msg::PlanRequest", false, false, false, 4096, false},
    {Topic::kCancel, "foothold/cancel", "foothold::msg::CancelRequest", false, false, false, 4096, false},
    {Topic::kQuery, "foothold/query", "foothold::msg::StateQuery", false, false, false, 4096, false},
    {Topic::kEvent, "foothold/event", "foothold::msg::PlanEvent", false, true, false, 4096, false},
    {Topic::kStep, "foothold/step", "foothold::msg::Step", false, true, false, 8192, false},
    {Topic::kScene, "foothold/scene", "foothold::msg::SceneChunk", false, false, false, 64, false},
    {Topic::kSceneStatus, "foothold/scene_status", "foothold::msg::SceneStatus", true, true, true, 4096, false},
    {Topic::kRobot, "foothold/robot", "foothold::msg::RobotInfo", true, true, true, 256, false},
    {Topic::kServer, "foothold/server", "foothold::msg::ServerInfo", true, true, true, 64, true},
};

constexpr const TopicTraits& traits(Topic topic) { return kTopics[static_cast<std::size_t>(topic)]; }

}  // namespace foothold::transport
