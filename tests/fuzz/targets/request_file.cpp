// Requests as YAML files.
#include "foothold/client/request_file.hpp"
#include "../fuzzing.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foothold;
  try {
    const client::RequestFile file = client::read_request(fuzz::text_of(data, size), "requests/request.yaml");
    fuzz::demand(!file.request.robot().empty(), "a request names its robot");
    fuzz::demand(file.request.budget() >= 0.0, "a budget is none or above 0");
  } catch (const client::RequestFileError&) {
  }
  return 0;
}
