// Connections: who is let in, how long each may take, and how it ends.
#include "http/http.hpp"

#include <array>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ip/v6_only.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <set>

namespace foothold::server {
namespace asio = boost::asio;
namespace beast = boost::beast;
using boost::system::error_code;
using tcp = asio::ip::tcp;

namespace {

constexpr auto kAcceptAgain = std::chrono::seconds(1);  // after a failure, such as no descriptor left
constexpr auto kDraining = std::chrono::seconds(1);
constexpr std::size_t kDrained = 64 << 10;  // octets

}  // namespace

class HttpServer::Door : public std::enable_shared_from_this<HttpServer::Door> {
 public:
  Door(asio::io_context& loop, HttpHandler handler, HttpLimits limits)
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
        : door(std::move(its_door)), stream(std::move(socket)), exchange(door->limits_.head) {
      door->visits_.insert(this);
    }
    ~Visit() { door->left(this); }

    void begin() {
      stream.expires_after(door->limits_.patience);
      read();
    }

    void read() {
      stream.async_read_some(asio::buffer(scratch), [self = shared_from_this()](const error_code& error, std::size_t count) {
        if (error || !self->door->handler_) return;
        if (auto said = self->exchange.take({self->scratch.data(), count}, self->door->handler_))
          self->send(std::move(*said));
        else
          self->read();
      });
    }

    void send(std::string octets) {
      answer = std::move(octets);
      stream.expires_after(door->limits_.patience);
      asio::async_write(stream, asio::buffer(answer), [self = shared_from_this()](const error_code& error, std::size_t) {
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
    HttpExchange exchange;
    std::string answer;
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
      std::make_shared<Visit>(self, std::move(socket))->begin();
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
  HttpHandler handler_;
  HttpLimits limits_;
  std::set<Visit*> visits_;
  bool accepting_ = false;
};

HttpServer::HttpServer(asio::io_context& loop, const std::string& address, std::uint16_t port, HttpHandler handler,
                       HttpLimits limits)
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
