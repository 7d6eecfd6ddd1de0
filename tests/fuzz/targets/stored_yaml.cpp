// The look at an uploaded scene's syntax.
#include "../fuzzing.hpp"
#include "scenes/keeping.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foothold;
  const auto error = server::check_yaml(fuzz::as_file("scene.yaml", fuzz::octets_of(data, size)));
  fuzz::demand(!error || !error->field().empty(), "a refusal names the line");
  return 0;
}
