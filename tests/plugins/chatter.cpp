// Prints more than anybody wants to read, then dies; or starts a process of its own and hangs.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>

#include "walker.hpp"

namespace {

using namespace foothold;

class Chatter : public test::Walker {
 public:
  using Walker::Walker;

  PlanReport plan(const Request&, const Parameters& parameters, const PreparedScene&, PlanContext& context) override {
    if (parameters.text("how") == "child") {
      const pid_t child = fork();
      if (child == 0)
        for (;;) ::pause();
      Step first = step(0);
      first.attributes = {{"child", std::to_string(child)}};
      context.emit(std::move(first));
      for (;;) ::pause();
    }
    for (int line = 0; line < 20000; ++line) std::fprintf(line % 2 == 0 ? stdout : stderr, "line %d\n", line);
    std::fflush(stdout);
    std::fprintf(stderr, "a cry from the end");
    std::_Exit(3);
  }
};

constexpr std::array kParameters = {
    ParameterSpec{"how", ParameterKind::kChoice, "", "words", 0, 0, "words|child", "What there is too much of."}};

}  // namespace

FOOTHOLD_TEST_PLANNER(Chatter, "chatter", kParameters)
