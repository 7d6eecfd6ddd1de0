// What clients send: octets on a topic of the server, decoded, and a request looked at as the server does. The first octet chooses
// the topic.
#include "../fuzzing.hpp"
#include "encapsulation.hpp"
#include "foothold/msg/cdr.hpp"
#include "foothold/msg/errors.hpp"
#include "jobs/admission/admission.hpp"
#include "scenes/upload.hpp"
#include "text/text.hpp"

namespace {

using namespace foothold;

template <class Message>
std::optional<Message> received(transport::Topic topic, std::span<const std::byte> octets) {
  if (transport::fault_of(transport::traits(topic), octets) != nullptr) return std::nullopt;
  return msg::decode<Message>(octets);
}

// A message that was understood goes on to others as octets: they must be understood again, and no longer change.
template <class Message>
void demand_stable(const std::optional<Message>& message) {
  if (!message) return;
  const msg::Bytes once = msg::encode(*message);
  const auto again = msg::decode<Message>(once);
  fuzz::demand(again.has_value() && msg::encode(*again) == once, "a message travels on unchanged");
}

void look_at(msg::PlanRequest request) {
  const server::Refusal refusal = server::check_form(request, 3600.0);
  fuzz::demand(!refusal || !refusal->field().empty(), "a refusal names the field");
  fuzz::demand(!refusal || server::is_clean_text(refusal->message()), "a refusal's text is clean");
  demand_stable(std::optional(server::essence(request)));
  msg::ParameterSpec spec;
  spec.name("cycles");
  spec.kind(msg::INTEGER);
  spec.default_value("3");
  spec.maximum(9.0);
  if (!server::check_parameters(request.parameters(), {spec})) server::complete_parameters(request.parameters(), {spec});
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foothold;
  if (size == 0) return 0;
  const auto octets = fuzz::octets_of(data + 1, size - 1);
  switch (data[0] % 4) {
    case 0:
      if (const auto request = received<msg::PlanRequest>(transport::Topic::kRequest, octets)) {
        demand_stable(request);
        look_at(*request);
      }
      break;
    case 1:
      demand_stable(received<msg::CancelRequest>(transport::Topic::kCancel, octets));
      break;
    case 2:
      demand_stable(received<msg::StateQuery>(transport::Topic::kQuery, octets));
      break;
    default:
      if (const auto chunk = received<msg::SceneChunk>(transport::Topic::kScene, octets)) {
        demand_stable(chunk);
        const auto error = server::check_chunk(*chunk, 1u << 20, nullptr);
        fuzz::demand(!error || server::is_clean_text(error->message()), "a refusal's text is clean");
      }
  }
  return 0;
}
