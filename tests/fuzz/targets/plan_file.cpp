// Plans as JSON documents: what was read is written and read again as the same.
#include "foothold/client/plan_file.hpp"
#include "../fuzzing.hpp"
#include "foothold/msg/cdr.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foothold;
  client::PlanRecord plan;
  try {
    plan = client::plan_from_json(fuzz::text_of(data, size), "plan.json");
  } catch (const client::PlanFileError&) {
    return 0;
  }
  const client::PlanRecord again = client::plan_from_json(client::plan_to_json(plan), "again");
  fuzz::demand(client::plan_to_json(again) == client::plan_to_json(plan), "a plan reads back as the same");
  return 0;
}
