// Plans a few steps at once, and notes in a file each time that it is asked to: a request that was planned twice is seen there.
#include <fcntl.h>
#include <unistd.h>

#include "walker.hpp"

namespace {

using namespace foothold;

class Tally : public test::Walker {
 public:
  using Walker::Walker;

  PlanReport plan(const Request& request, const Parameters& parameters, const PreparedScene&, PlanContext& context) override {
    const std::string line = std::to_string(request.seed) + "\n";
    const int file = ::open(parameters.text("file").c_str(), O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC, 0600);
    // One call of the kernel: lines of several workers do not mix.
    if (file < 0 || ::write(file, line.data(), line.size()) != static_cast<ssize_t>(line.size())) std::abort();
    ::close(file);
    const auto steps = static_cast<int>(parameters.integer("steps"));
    for (int index = 0; index < steps; ++index)
      if (!context.emit(step(index))) return stopped();
    return reached(steps);
  }
};

constexpr std::array kParameters = {
    ParameterSpec{"file", ParameterKind::kText, "", "", 0, 0, "", "Where it notes the seed of each request."},
    ParameterSpec{"steps", ParameterKind::kInteger, "1", "5", 0, 1000, "", "How many steps the plan has."}};

}  // namespace

FOOTHOLD_TEST_PLANNER(Tally, "tally", kParameters)
