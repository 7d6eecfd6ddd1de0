// Eats memory until there is none, and writes to all of it: in pieces that it gives back when it fails, or in crumbs that it loses.
#include <cstring>
#include <new>
#include <vector>

#include "walker.hpp"

namespace {

using namespace foothold;

constexpr std::size_t kPiece = 8u << 20, kCrumb = 256;

class Memory : public test::Walker {
 public:
  using Walker::Walker;

  PlanReport plan(const Request&, const Parameters& parameters, const PreparedScene&, PlanContext& context) override {
    context.emit(step(0));
    const double pause_s = parameters.real("pause");
    if (parameters.text("in") == "crumbs")
      for (;;) std::memset(static_cast<char*>(::operator new(kCrumb)), 1, kCrumb);
    std::vector<std::vector<char>> eaten;
    while (!context.stop.stop_requested()) {
      eaten.emplace_back(kPiece, '\1');
      if (pause_s > 0.0) pause(context, pause_s);
    }
    return stopped();
  }
};

constexpr std::array kParameters = {
    ParameterSpec{"in", ParameterKind::kChoice, "", "pieces", 0, 0, "pieces|crumbs", "How it eats."},
    ParameterSpec{"pause", ParameterKind::kReal, "s", "0", 0, 10, "", "Sleep after each piece of 8 MiB."}};

}  // namespace

FOOTHOLD_TEST_PLANNER(Memory, "memory", kParameters)
