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
  bool keep_last_one;     // else keep all, within `history`
  std::int32_t history;   // samples (and, if keyed, instances) kept at most, for late readers too
  std::int32_t lifespan;  // s after which a sample is not given to late readers any more; 0: for ever
  bool liveliness;        // MANUAL_BY_TOPIC, 1 s
};

// Reliable and transient local, every one: two ends do not find each other at the same moment, and what a volatile writer sends to
// a reader that it has found already, but that has not found the writer yet, is lost (Fast DDS to Cyclone DDS: up to a second's
// worth). What clients send lives seconds, so that a server that is started later is not told of old requests, and one that was
// killed does not hold up the writers to the others for its lease. Older answers are asked for by a query, so a thousand for each
// client are enough.
inline constexpr TopicTraits kTopics[kTopicCount] = {
    {Topic::kRequest, "foothold/request", "foothold::msg::PlanRequest", false, false, 1024, 4, false},
    {Topic::kCancel, "foothold/cancel", "foothold::msg::CancelRequest", false, false, 1024, 10, false},
    {Topic::kQuery, "foothold/query", "foothold::msg::StateQuery", false, false, 1024, 4, false},
    {Topic::kEvent, "foothold/event", "foothold::msg::PlanEvent", false, false, 1024, 0, false},
    {Topic::kStep, "foothold/step", "foothold::msg::Step", false, false, 1024, 0, false},
    {Topic::kScene, "foothold/scene", "foothold::msg::SceneChunk", false, false, 64, 4, false},
    {Topic::kSceneStatus, "foothold/scene_status", "foothold::msg::SceneStatus", false, false, 4096, 0, false},
    {Topic::kRobot, "foothold/robot", "foothold::msg::RobotInfo", true, true, 256, 0, false},
    {Topic::kServer, "foothold/server", "foothold::msg::ServerInfo", true, true, 64, 0, true},
};

// Octets of a message, at most: what is larger is not written and, by Cyclone, not received.
inline constexpr std::size_t kMaxMessage = std::size_t{16} << 20U;

constexpr const TopicTraits& traits(Topic topic) { return kTopics[static_cast<std::size_t>(topic)]; }

}  // namespace foothold::transport
