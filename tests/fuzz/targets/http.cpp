// What a peer sends to the port of figures and health: whatever it is, there is an answer or more is awaited, however it is cut
// into pieces, and the handler sees clean paths only.
#include "../fuzzing.hpp"
#include "http/exchange.hpp"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foothold;
  const auto handler = [](std::string_view path) {
    fuzz::demand(path.find_first_of("?\r\n") == std::string_view::npos, "a path is one, without its query");
    return server::HttpAnswer{};
  };
  const std::string text = fuzz::text_of(data, size);
  server::HttpExchange whole(8192);
  const auto at_once = whole.take(text, handler);
  fuzz::demand(!at_once || at_once->starts_with("HTTP/1.1 "), "an answer is HTTP");
  const std::size_t cut = size == 0 ? 0 : data[0] % size;
  server::HttpExchange pieces(8192);
  auto answer = pieces.take(std::string_view(text).substr(0, cut), handler);
  if (!answer) answer = pieces.take(std::string_view(text).substr(cut), handler);
  // What cannot become a request may be refused before its head is whole, or then.
  fuzz::demand(!answer || !at_once || *answer == *at_once, "an answer does not depend on how the request was cut");
  return 0;
}
