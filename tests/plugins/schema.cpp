// A planner whose parameter schema is wrong in the way that FOOTHOLD_SCHEMA says.
#include "walker.hpp"

namespace {

using namespace foothold;

class Schema : public test::Walker {
 public:
  using Walker::Walker;
  PlanReport plan(const Request&, const Parameters&, const PreparedScene&, PlanContext&) override { return reached(0); }
};

[[maybe_unused]] constexpr std::array kDefault = {ParameterSpec{"gait", ParameterKind::kInteger, "1", "11", 0, 10, "", ""}};
[[maybe_unused]] constexpr std::array kTwice = {ParameterSpec{"gait", ParameterKind::kInteger, "1", "1", 0, 10, "", ""},
                                                ParameterSpec{"gait", ParameterKind::kFlag, "", "true", 0, 0, "", ""}};
[[maybe_unused]] constexpr std::array kBounds = {ParameterSpec{"gait", ParameterKind::kReal, "1", "1", 10, 0, "", ""}};

}  // namespace

FOOTHOLD_TEST_PLANNER(Schema, "schema", FOOTHOLD_SCHEMA)
