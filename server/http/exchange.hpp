// One request over HTTP/1.1 and the answer to it, octets in and octets out: what is made of whatever a peer sends, apart from
// sockets.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace foothold::server {

struct HttpAnswer {
  unsigned status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::string body;
};

// `path`: of a GET or HEAD, without its query. Must not throw.
using HttpHandler = std::function<HttpAnswer(std::string_view path)>;

// Thread rule: one at a time.
class HttpExchange {
 public:
  explicit HttpExchange(std::uint32_t head);  // octets of the request at most
  ~HttpExchange();
  HttpExchange(const HttpExchange&) = delete;
  HttpExchange& operator=(const HttpExchange&) = delete;

  // Takes octets as they come, in pieces of any size. The whole answer as soon as the request has ended or cannot be one: the
  // handler's, or a refusal (4xx) that says why. Nothing: more has to come. Precondition: it has not answered yet.
  std::optional<std::string> take(std::string_view octets, const HttpHandler& handler);

 private:
  class Request;
  std::unique_ptr<Request> request_;
};

}  // namespace foothold::server
