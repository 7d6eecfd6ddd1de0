// What servers send, as a client takes it: decoded, and written as a line of JSON. The first octet chooses the topic.
#include "../fuzzing.hpp"
#include "foothold/client/plan_file.hpp"
#include "foothold/msg/cdr.hpp"

namespace {

template <class Message>
void take(std::span<const std::byte> octets) {
  using namespace foothold;
  if (const auto message = msg::decode<Message>(octets)) fuzz::demand(!client::to_json_line(*message).empty(), "a line is written");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foothold;
  if (size == 0) return 0;
  const auto octets = fuzz::octets_of(data + 1, size - 1);
  switch (data[0] % 5) {
    case 0:
      take<msg::PlanEvent>(octets);
      break;
    case 1:
      take<msg::Step>(octets);
      break;
    case 2:
      take<msg::SceneStatus>(octets);
      break;
    case 3:
      take<msg::RobotInfo>(octets);
      break;
    default:
      take<msg::ServerInfo>(octets);
  }
  return 0;
}
