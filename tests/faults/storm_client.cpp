// A client process of the storm: submits its requests, some malformed, some cancelled, follows each to its end with foothold's
// client library and notes how it ended. Started again after it was killed, it asks for what is not noted, under the same ids.
//
// storm_client VENDOR DOMAIN NUMBER REQUESTS AT_ONCE CHOICES RECORD TALLY
#include <atomic>
#include <cstdio>
#include <semaphore>
#include <thread>

#include "foothold/client/client.hpp"
#include "foothold/msg/errors.hpp"
#include "record.hpp"
#include "workload.hpp"

namespace {

using namespace foothold;
using namespace foothold::faults;

constexpr std::size_t kReason = 500;  // octets
constexpr int kSpoiltOfThousand = 25;
// A server that takes nothing at present is not asked more than a few times a second.
constexpr auto kBackOff = std::chrono::milliseconds(300);

}  // namespace

int main(int argc, char** argv) {
  if (argc != 9) return 64;
  const auto number = static_cast<std::uint32_t>(std::stoul(argv[3]));
  const auto requests = static_cast<std::uint32_t>(std::stoul(argv[4]));
  const long at_once = std::stol(argv[5]);
  const std::string record = argv[7];
  const std::vector<Choice> choices = read_choices(argv[6]);
  const auto done = read_record(record);

  auto bus =
      transport::open_bus({.vendor = argv[1], .domain = static_cast<std::uint32_t>(std::stoul(argv[2])), .network_config = {}});
  auto spoiler = bus->writer(transport::Topic::kRequest, "");
  std::atomic<bool> refused = false;
  std::counting_semaphore<> room(at_once);  // outlives the client, whose thread releases it
  client::Client client(std::move(bus));
  if (!client.wait_for_server(60.0)) return 65;

  std::mt19937_64 random(std::random_device{}());
  std::uint32_t spoilt = 0;
  for (std::uint32_t k = 0; k < requests; ++k) {
    if (random() % 1000 < kSpoiltOfThousand && spoiler->write(spoilt_octets(random)) == transport::Writer::Result::kSent) ++spoilt;
    Draw drawn = draw(choices, number, k, argv[8]);
    const msg::Id id = drawn.request.id();
    if (done.contains(id)) continue;
    room.acquire();
    if (refused.exchange(false)) std::this_thread::sleep_for(kBackOff);
    auto outcome = std::make_shared<Outcome>();
    outcome->kind = kKindNames[static_cast<int>(drawn.kind)];
    outcome->robot = drawn.request.robot();
    const client::PlanCallbacks callbacks{
        .on_step =
            [&client, outcome, id, first = drawn.cancel == Draw::Cancel::kAtFirstStep](const msg::Step& step) {
              if (first && step.index() == 0) client.cancel(id, "storm");
              extend_chain(outcome->chain, msg::encode(step));
            },
        .on_event =
            [&room, &record, &refused, outcome, id](const msg::PlanEvent& event) {
              if (event.state() == msg::QUEUED || event.state() == msg::RUNNING) return;
              outcome->state = event.state();
              outcome->code = event.error().code();
              outcome->steps = event.steps();
              outcome->reason = event.error().message().substr(0, kReason);
              note(record, id, *outcome);
              if (event.state() == msg::REJECTED && event.error().retryable()) refused = true;
              room.release();
            }};
    client.submit(std::move(drawn.request), callbacks);
    if (drawn.cancel == Draw::Cancel::kAtOnce) client.cancel(id, "storm");
  }
  for (long k = 0; k < at_once; ++k) room.acquire();
  spoiler.reset();  // before the bus, which the client holds
  std::printf("client %u (%s): %u messages of spoilt octets\n", number, argv[1], spoilt);
  return 0;
}
