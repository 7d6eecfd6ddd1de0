// Gets hold of the worker's channel and speaks to the daemon itself, as a plugin gone mad might.
#include <sys/socket.h>
#include <unistd.h>

#include <cstdint>
#include <cstring>
#include <vector>

#include "walker.hpp"

namespace {

using namespace foothold;

constexpr int kChannel = 3;

void say(std::uint32_t length, std::uint32_t kind, std::uint64_t run, const std::vector<char>& payload) {
  std::vector<char> frame(16 + payload.size());
  std::memcpy(frame.data(), &length, 4);
  std::memcpy(frame.data() + 4, &kind, 4);
  std::memcpy(frame.data() + 8, &run, 8);
  if (!payload.empty()) std::memcpy(frame.data() + 16, payload.data(), payload.size());
  [[maybe_unused]] const ssize_t sent = ::send(kChannel, frame.data(), frame.size(), MSG_NOSIGNAL);
}

// Little-endian CDR of a Step's beginning: encapsulation, request, server, index.
std::vector<char> step_of(char id_octet, std::uint32_t index) {
  std::vector<char> step(64);
  step[1] = 1;
  std::memset(step.data() + 4, id_octet, 16);
  std::memcpy(step.data() + 36, &index, 4);
  return step;
}

class Impostor : public test::Walker {
 public:
  using Walker::Walker;

  PlanReport plan(const Request&, const Parameters& parameters, const PreparedScene&, PlanContext&) override {
    constexpr std::uint32_t kPlan = 1, kReady = 3, kStep = 6, kReport = 7;
    const std::string& how = parameters.text("how");
    if (how == "kind") say(0, 77, 1, {});
    if (how == "length") say(0xffffffffu, kStep, 1, {});
    if (how == "run") say(64, kStep, 999, step_of(0, 0));
    if (how == "request") say(64, kStep, 1, step_of(9, 0));
    if (how == "index") say(64, kStep, 1, step_of(7, 5));
    if (how == "no_step") say(3, kStep, 1, {1, 2, 3});
    if (how == "report") say(3, kReport, 1, {1, 2, 3});
    if (how == "ready") say(0, kReady, 0, {});
    if (how == "plan") say(0, kPlan, 1, {});
    if (how == "noise") {
      for (int i = 0; i < 1000; ++i) say(0x5a5a5a5au, 0x5a5a5a5au, 0x5a, std::vector<char>(97, 'Z'));
    }
    if (how == "close") ::close(kChannel);
    for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
  }
};

constexpr std::array kParameters = {ParameterSpec{"how", ParameterKind::kChoice, "", "kind", 0, 0,
                                                  "kind|length|run|request|index|no_step|report|ready|plan|noise|close",
                                                  "What it says."}};

}  // namespace

FOOTHOLD_TEST_PLANNER(Impostor, "impostor", kParameters)
