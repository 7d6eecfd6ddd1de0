// The one file that includes Beast's HTTP: it takes seconds to compile.
#include "http/exchange.hpp"

#include <utility>  // before Asio, whose 1.74 forgets it under C++20

#include <boost/beast/http.hpp>
#include <sstream>

namespace foothold::server {
namespace {

namespace http = boost::beast::http;
using boost::system::error_code;
using Response = http::response<http::string_body>;

Response refusal(http::status status, const std::string& reason) {
  Response response{status, 11};
  response.set(http::field::content_type, "text/plain; charset=utf-8");
  response.body() = reason + "\n";
  return response;
}

// What to say to octets that are no request that is taken here.
Response complaint(const error_code& error) {
  if (error == http::error::header_limit)
    return refusal(http::status::request_header_fields_too_large, "the request's head is too large");
  if (error == http::error::unexpected_body || error == http::error::body_limit)
    return refusal(http::status::payload_too_large, "a request must not have a body");
  return refusal(http::status::bad_request, "this is no HTTP request: " + error.message());
}

Response answer_to(const http::request<http::empty_body>& request, const HttpHandler& handler) {
  if (request.method() != http::verb::get && request.method() != http::verb::head) {
    Response refused = refusal(http::status::method_not_allowed, "only GET and HEAD are taken");
    refused.set(http::field::allow, "GET, HEAD");
    return refused;
  }
  const std::string_view target(request.target().data(), request.target().size());
  HttpAnswer given = handler(target.substr(0, target.find('?')));
  Response made{static_cast<http::status>(given.status), 11};
  made.set(http::field::content_type, given.type);
  made.body() = std::move(given.body);
  return made;
}

std::string octets_of(Response response, bool with_body) {
  response.set(http::field::cache_control, "no-store");
  response.keep_alive(false);
  response.prepare_payload();
  if (!with_body) response.body().clear();
  std::ostringstream out;
  out << response;
  return out.str();
}

}  // namespace

class HttpExchange::Request {
 public:
  http::request_parser<http::empty_body> parser;
  std::string pending;  // came, not taken by the parser yet: at most a head and one piece
};

HttpExchange::HttpExchange(std::uint32_t head) : request_(std::make_unique<Request>()) {
  request_->parser.header_limit(head);
  request_->parser.body_limit(0);
  request_->parser.eager(true);
}

HttpExchange::~HttpExchange() = default;

std::optional<std::string> HttpExchange::take(std::string_view octets, const HttpHandler& handler) {
  auto& [parser, pending] = *request_;
  pending += octets;
  const auto with_body = [&] { return !parser.is_header_done() || parser.get().method() != http::verb::head; };
  while (!parser.is_done() && !pending.empty()) {
    error_code error;
    const std::size_t taken = parser.put(boost::asio::buffer(pending), error);
    pending.erase(0, taken);
    if (error == http::error::need_more) return std::nullopt;
    if (error) return octets_of(complaint(error), with_body());
  }
  if (!parser.is_done()) return std::nullopt;
  return octets_of(answer_to(parser.get(), handler), with_body());
}

}  // namespace foothold::server
