// The one file that includes Boost.Beast: it takes seconds to compile.
#include "http/http.hpp"

#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/v6_only.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http.hpp>
#include <optional>
#include <set>

namespace foothold::server {
namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using boost::system::error_code;
using tcp = asio::ip::tcp;

namespace {

constexpr auto kAcceptAgain = std::chrono::seconds(1);  // after a failure, such as no descriptor left
constexpr auto kDraining = std::chrono::seconds(1);
constexpr std::size_t kDrained = 64 << 10;  // octets

using Response = http::response<http::string_body>;

Response refusal(http::status status, const std::string& reason) {
  Response response{status, 11};
  response.set(http::field::content_type, "text/plain; charset=utf-8");
  response.body() = reason + "\n";
  return response;
}

// What to say to octets that are no request that is taken here; nothing if the peer is gone or was too slow.
std::optional<Response> complaint(const error_code& error) {
  if (error == http::error::header_limit || error == http::error::buffer_overflow)
    return refusal(http::status::request_header_fields_too_large, "the request's head is too large");
  if (error == http::error::unexpected_body || error == http::error::body_limit)
    return refusal(http::status::payload_too_large, "a request must not have a body");
  if (error == http::error::end_of_stream || error == http::error::partial_message || error == beast::error::timeout ||
      error.category() != http::make_error_code(http::error::bad_method).category())
    return std::nullopt;
  return refusal(http::status::bad_request, "this is no HTTP request: " + error.message());
}

}  // namespace

class HttpServer::Door : public std::enable_shared_from_this<HttpServer::Door> {
 public:
  Door(asio::io_context& loop, Handler handler, HttpLimits limits)
      : loop_(loop), acceptor_(loop), timer_(loop), handler_(std::move(handler)), limits_(limits) {}

  void open(const tcp::endpoint& endpoint) {
    acceptor_.open(endpoint.protocol());
    acceptor_.set_option(tcp::acceptor::reuse_address(true));
    if (endpoint.address().is_v6()) acceptor_.set_option(asio::ip::v6_only(true));
    acceptor_.bind(endpoint);
    acceptor_.listen(static_cast<int>(limits_.connections));
    accept();
  }

  void close() {
    handler_ = nullptr;
    error_code ignored;
    acceptor_.close(ignored);
    timer_.cancel(ignored);
    for (Visit* visit : std::set<Visit*>(visits_)) visit->stream.close();
  }

  tcp::endpoint endpoint() const { return acceptor_.local_endpoint(); }

 private:
  // One connection: a request, an answer, the end.
  struct Visit : std::enable_shared_from_this<Visit> {
    Visit(std::shared_ptr<Door> its_door, tcp::socket socket)
        : door(std::move(its_door)), stream(std::move(socket)), buffer(door->limits_.head) {
      parser.header_limit(door->limits_.head);
      parser.body_limit(0);
      door->visits_.insert(this);
    }
    ~Visit() { door->left(this); }

    void read() {
      stream.expires_after(door->limits_.patience);
      http::async_read(stream, buffer, parser, [self = shared_from_this()](const error_code& error, std::size_t) {
        if (!self->door->handler_) return;
        if (!error) return self->send(self->answer());
        if (auto refused = complaint(error)) self->send(std::move(*refused));
      });
    }

    Response answer() const {
      const auto& request = parser.get();
      if (request.method() != http::verb::get && request.method() != http::verb::head) {
        Response refused = refusal(http::status::method_not_allowed, "only GET and HEAD are taken");
        refused.set(http::field::allow, "GET, HEAD");
        return refused;
      }
      const std::string_view target(request.target().data(), request.target().size());
      HttpAnswer given = door->handler_(target.substr(0, target.find('?')));
      Response made{static_cast<http::status>(given.status), 11};
      made.set(http::field::content_type, given.type);
      made.body() = std::move(given.body);
      return made;
    }

    void send(Response made) {
      response = std::move(made);
      response.set(http::field::cache_control, "no-store");
      response.keep_alive(false);
      response.prepare_payload();
      if (parser.is_header_done() && parser.get().method() == http::verb::head) response.body().clear();
      stream.expires_after(door->limits_.patience);
      http::async_write(stream, response, [self = shared_from_this()](const error_code& error, std::size_t) {
        error_code ignored;
        self->stream.socket().shutdown(tcp::socket::shutdown_send, ignored);
        if (!error) self->drain();
      });
    }

    // To close while octets of the peer are unread would take the answer away from it. Not for ever, and not for much.
    void drain() {
      if (drained >= kDrained) return;
      if (drained == 0) stream.expires_after(kDraining);
      stream.async_read_some(asio::buffer(scratch), [self = shared_from_this()](const error_code& error, std::size_t count) {
        self->drained += count;
        if (!error) self->drain();
      });
    }

    std::shared_ptr<Door> door;
    beast::tcp_stream stream;
    beast::flat_buffer buffer;
    http::request_parser<http::empty_body> parser;
    Response response;
    std::array<char, 4096> scratch{};
    std::size_t drained = 0;
  };

  void accept() {
    if (accepting_ || !handler_ || visits_.size() >= limits_.connections) return;
    accepting_ = true;
    acceptor_.async_accept([self = shared_from_this()](const error_code& error, tcp::socket socket) {
      self->accepting_ = false;
      if (!self->handler_) return;
      if (error) return self->accept_later();
      std::make_shared<Visit>(self, std::move(socket))->read();
      self->accept();
    });
  }

  void accept_later() {
    timer_.expires_after(kAcceptAgain);
    timer_.async_wait([self = shared_from_this()](const error_code& error) {
      if (!error) self->accept();
    });
  }

  void left(Visit* visit) {
    visits_.erase(visit);
    accept();
  }

  asio::io_context& loop_;
  tcp::acceptor acceptor_;
  asio::steady_timer timer_;
  Handler handler_;
  HttpLimits limits_;
  std::set<Visit*> visits_;
  bool accepting_ = false;
};

HttpServer::HttpServer(asio::io_context& loop, const std::string& address, std::uint16_t port, Handler handler, HttpLimits limits)
    : door_(std::make_shared<Door>(loop, std::move(handler), limits)) {
  error_code fault;
  const auto numbers = asio::ip::make_address(address, fault);
  if (fault) throw HttpError(address + ":" + std::to_string(port) + ": is no IP address");
  try {
    door_->open({numbers, port});
  } catch (const boost::system::system_error& error) {
    throw HttpError(address + ":" + std::to_string(port) + ": " + error.code().message());
  }
}

HttpServer::~HttpServer() { door_->close(); }

std::uint16_t HttpServer::port() const { return door_->endpoint().port(); }

std::string HttpServer::url() const {
  const auto address = door_->endpoint().address();
  const std::string host = address.is_v6() ? "[" + address.to_string() + "]" : address.to_string();
  return "http://" + host + ":" + std::to_string(port());
}

bool is_loopback(const std::string& address) {
  error_code fault;
  const auto numbers = asio::ip::make_address(address, fault);
  return !fault && numbers.is_loopback();
}

}  // namespace foothold::server
