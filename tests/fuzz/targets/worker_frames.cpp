// The stream between the server and a worker: cut into frames, each decoded as its kind, in either direction. The first octet says
// in how large pieces the stream arrives.
#include <algorithm>
#include <cstring>

#include "../fuzzing.hpp"
#include "frames/frames.hpp"
#include "worker/convert.hpp"

namespace {

using namespace foothold;

void take(const server::Frame& frame) {
  fuzz::demand(!server::frame_name(frame.kind).empty(), "a frame has a name");
  switch (frame.kind) {
    case frame::LOAD:
      if (const auto load = msg::decode<frame::Load>(frame.payload)) {
        try {
          server::to_model(*load);
        } catch (const InvalidModel&) {
        }
      }
      break;
    case frame::PLAN:
      if (const auto plan = msg::decode<frame::Plan>(frame.payload)) server::to_request(plan->request(), plan->budget_left());
      break;
    case frame::READY:
      msg::decode<frame::Ready>(frame.payload);
      break;
    case frame::REFUSED:
      msg::decode<frame::Refused>(frame.payload);
      break;
    case frame::SCENE:
      msg::decode<frame::SceneShapes>(frame.payload);
      break;
    case frame::STEP:
      if (const auto step = msg::decode<msg::Step>(frame.payload)) {
        const auto head = server::peek_step(frame.payload);
        fuzz::demand(!head || head->index == step->index() || frame.payload[1] != std::byte{1}, "a peek sees what is decoded");
      }
      break;
    case frame::REPORT:
      msg::decode<frame::Report>(frame.payload);
      break;
    case frame::STOP:
      break;
  }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::size_t piece = std::size_t{data[0]} + 1;
  auto rest = fuzz::octets_of(data + 1, size - 1);
  server::FrameReader reader;
  try {
    while (!rest.empty()) {
      const auto room = reader.room();
      fuzz::demand(!room.empty(), "there is room for more");
      const std::size_t count = std::min({piece, rest.size(), room.size()});
      std::memcpy(room.data(), rest.data(), count);
      reader.filled(count);
      rest = rest.subspan(count);
      while (const auto frame = reader.next()) take(*frame);
    }
  } catch (const server::FrameFault&) {
  }
  return 0;
}
