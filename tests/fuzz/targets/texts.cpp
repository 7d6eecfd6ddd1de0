// Small texts from outside: quantities with units, ids, parameters, what a worker prints.
#include <cmath>

#include "../fuzzing.hpp"
#include "config/words.hpp"
#include "foothold/msg/ids.hpp"
#include "foothold/parameters.hpp"
#include "text/text.hpp"
#include "workers/last_words.hpp"

namespace {

using namespace foothold;

constexpr ParameterSpec kSpecs[] = {{"flag", ParameterKind::kFlag, "", "true", 0, 0, "", ""},
                                    {"integer", ParameterKind::kInteger, "1", "0", -10, 10, "", ""},
                                    {"real", ParameterKind::kReal, "m", "0", -1e300, 1e300, "", ""},
                                    {"text", ParameterKind::kText, "", "", 0, 0, "", ""},
                                    {"choice", ParameterKind::kChoice, "", "a", 0, 0, "a|b|cde", ""}};

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = fuzz::text_of(data, size);
  fuzz::demand(server::is_clean_text(server::cleaned(text)), "cleaned text is clean");
  fuzz::demand(server::is_clean_text(server::quoted(text)), "quoted text is clean");
  fuzz::demand(!server::is_clean_text(text) || server::cleaned(text) == text, "clean text stays");
  for (const auto& value : {server::parse_seconds(text), server::parse_octets(text), server::parse_number(text)})
    fuzz::demand(!value || std::isfinite(*value), "a quantity is finite");
  server::nearest(text, {"grace", "domain", "quarantine_window"});
  if (const auto id = msg::id_from_hex(text)) fuzz::demand(msg::to_hex(*id).size() == 32, "an id is written in 32 digits");
  for (const ParameterSpec& spec : kSpecs) {
    try {
      parse_parameter(spec, text);
    } catch (const ParameterFault& fault) {
      fuzz::demand(!fault.message.empty(), "a refusal says why");
    }
  }
  std::size_t lines = 0;
  server::LastWords words([&](std::string_view) { ++lines; });
  words.hear(text, 1);
  words.hear(text, 2);
  fuzz::demand(lines <= 2 * server::LastWords::kLoggedPerSecond + 2, "a flood is not logged");
  fuzz::demand(words.text().size() <= (server::LastWords::kLines + 1) * (4 * server::LastWords::kLineOctets + 3),
               "last words are short");
  return 0;
}
