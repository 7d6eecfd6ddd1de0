// HTTP as a stranger may speak it: right requests, wrong ones, endless ones, in pieces, too many at once. Mostly by raw sockets.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <boost/asio/post.hpp>
#include <random>
#include <thread>

#include "http/http.hpp"

namespace foothold::server::testing {
namespace {

class Http : public ::testing::Test {
 protected:
  Http() {
    server_.emplace(
        loop_, "127.0.0.1", std::uint16_t{0},
        [this](std::string_view path) {
          ++calls_;
          asked_ = path;
          return path == "/large" ? HttpAnswer{.body = std::string(1 << 20, 'x')} : HttpAnswer{.status = 200, .body = "well\n"};
        },
        HttpLimits{.head = 2048, .connections = 3, .patience = std::chrono::milliseconds(300)});
    port_ = server_->port();
    thread_ = std::thread([this] {
      const auto work = boost::asio::make_work_guard(loop_);
      loop_.run();
    });
  }
  ~Http() override {
    boost::asio::post(loop_, [this] {
      server_.reset();
      loop_.stop();
    });
    thread_.join();
  }

  int connect() const {
    const int fd = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(port_);
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(::connect(fd, reinterpret_cast<const sockaddr*>(&to), sizeof to), 0);
    const timeval limit{10, 0};  // for a stuck test
    ::setsockopt(fd, SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
    return fd;
  }
  static void send(int fd, const std::string& text) {
    [[maybe_unused]] const ssize_t sent = ::send(fd, text.data(), text.size(), MSG_NOSIGNAL);
  }
  // Everything until the server closes.
  static std::string rest(int fd) {
    std::string text;
    std::array<char, 4096> piece{};
    for (ssize_t count = 0; (count = ::recv(fd, piece.data(), piece.size(), 0)) > 0;)
      text.append(piece.data(), static_cast<std::size_t>(count));
    ::close(fd);
    return text;
  }
  std::string say(const std::string& text) const {
    const int fd = connect();
    send(fd, text);
    return rest(fd);
  }

  boost::asio::io_context loop_{1};
  std::optional<HttpServer> server_;
  std::uint16_t port_ = 0;
  std::atomic<int> calls_ = 0;
  std::string asked_;  // read when calls_ was seen to grow
  std::thread thread_;
};

bool begins(const std::string& text, const std::string& with) { return text.starts_with(with); }

TEST_F(Http, AnswersAGetAndCloses) {
  const std::string answer = say("GET /metrics?x=1 HTTP/1.1\r\nHost: here\r\n\r\n");
  EXPECT_TRUE(begins(answer, "HTTP/1.1 200 OK\r\n")) << answer;
  EXPECT_NE(answer.find("Content-Length: 5\r\n"), std::string::npos) << answer;
  EXPECT_NE(answer.find("Connection: close\r\n"), std::string::npos) << answer;
  EXPECT_TRUE(answer.ends_with("\r\n\r\nwell\n")) << answer;
  EXPECT_EQ(asked_, "/metrics");
}

TEST_F(Http, AHeadHasTheLengthAndNoBody) {
  const std::string answer = say("HEAD / HTTP/1.1\r\n\r\n");
  EXPECT_NE(answer.find("Content-Length: 5\r\n"), std::string::npos) << answer;
  EXPECT_TRUE(answer.ends_with("\r\n\r\n")) << answer;
  const std::string refused = say("HEAD / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\n4\r\nbody\r\n0\r\n\r\n");
  EXPECT_TRUE(begins(refused, "HTTP/1.1 413 ") && refused.ends_with("\r\n\r\n")) << refused;
}

TEST_F(Http, ALargeAnswerArrivesWhole) {
  const std::string answer = say("GET /large HTTP/1.1\r\n\r\n");
  EXPECT_EQ(answer.size() - answer.find("\r\n\r\n") - 4, std::size_t{1} << 20);
}

TEST_F(Http, OtherMethodsBodiesAndNonsenseAreRefusedBeforeTheHandler) {
  EXPECT_TRUE(begins(say("POST / HTTP/1.1\r\n\r\n"), "HTTP/1.1 405 "));
  EXPECT_TRUE(begins(say("DELETE /metrics HTTP/1.1\r\n\r\n"), "HTTP/1.1 405 "));
  EXPECT_TRUE(begins(say("GET / HTTP/1.1\r\nContent-Length: 4\r\n\r\nbody"), "HTTP/1.1 413 "));
  EXPECT_TRUE(begins(say("GET / HTTP/1.1\r\nTransfer-Encoding: chunked\r\n\r\n4\r\nbody\r\n0\r\n\r\n"), "HTTP/1.1 413 "));
  EXPECT_TRUE(begins(say("this is no HTTP\r\n\r\n"), "HTTP/1.1 400 "));
  EXPECT_TRUE(begins(say("GET / HTTP/9.9\r\n\r\n"), "HTTP/1.1 400 "));
  EXPECT_TRUE(begins(say(std::string("\0\0\0\0\r\n\r\n", 8)), "HTTP/1.1 400 "));
  EXPECT_EQ(calls_, 0);
}

TEST_F(Http, AHeadThatIsTooLargeIsRefused) {
  EXPECT_TRUE(begins(say("GET / HTTP/1.1\r\nX: " + std::string(5000, 'a') + "\r\n\r\n"), "HTTP/1.1 431 "));
  EXPECT_TRUE(begins(say("GET /" + std::string(5000, 'a') + " HTTP/1.1\r\n\r\n"), "HTTP/1.1 431 "));
  std::string many = "GET / HTTP/1.1\r\n";
  for (int i = 0; i < 1000; ++i) many += "A: b\r\n";
  EXPECT_TRUE(begins(say(many + "\r\n"), "HTTP/1.1 431 "));
  EXPECT_EQ(calls_, 0);
}

TEST_F(Http, WhoSaysNothingOrTooSlowlyIsLeft) {
  const int silent = connect();
  EXPECT_EQ(rest(silent), "");
  const int slow = connect();
  send(slow, "GET / HTT");
  EXPECT_EQ(rest(slow), "");
  EXPECT_EQ(calls_, 0);
}

TEST_F(Http, TheNextIsServedWhenThoseThatHoldEveryPlaceAreLeft) {
  std::vector<int> idle;
  for (int i = 0; i < 10; ++i) idle.push_back(connect());
  EXPECT_TRUE(begins(say("GET / HTTP/1.1\r\n\r\n"), "HTTP/1.1 200 "));
  for (const int fd : idle) ::close(fd);
}

TEST_F(Http, WhoTakesNoAnswerHoldsNobodyUp) {
  std::vector<int> idle;
  for (int i = 0; i < 3; ++i) {
    idle.push_back(connect());
    const int small = 4096;
    ::setsockopt(idle.back(), SOL_SOCKET, SO_RCVBUF, &small, sizeof small);
    for (int k = 0; k < 3; ++k) send(idle.back(), "GET /large HTTP/1.1\r\n\r\n");
  }
  EXPECT_TRUE(begins(say("GET / HTTP/1.1\r\n\r\n"), "HTTP/1.1 200 "));
  for (const int fd : idle) ::close(fd);
}

TEST_F(Http, RandomOctetsNeverReachTheHandler) {
  std::mt19937_64 random(1);
  const std::string words[] = {"GET ", "/", " HTTP/1.1", "\r\n", "\n", ":", "Content-Length: ", "-1", "99999999999999999999",
                               "\xff", " ", "\t"};
  for (int round = 0; round < 300; ++round) {
    // A space first: no method begins so.
    std::string text = " ";
    for (int i = 0; i < 20; ++i)
      text += random() % 2 != 0U ? words[random() % std::size(words)] : std::string(1, static_cast<char>(random()));
    const std::string answer = say(text + "\r\n\r\n");
    ASSERT_TRUE(begins(answer, "HTTP/1.1 4")) << answer;
  }
  EXPECT_EQ(calls_, 0);
  EXPECT_TRUE(begins(say("GET / HTTP/1.1\r\n\r\n"), "HTTP/1.1 200 "));
}

TEST_F(Http, AnAddressThatIsTakenIsToldWithIt) {
  boost::asio::io_context loop;
  try {
    HttpServer second(loop, "127.0.0.1", port_, [](std::string_view) { return HttpAnswer{}; });
    FAIL() << "two servers at one address";
  } catch (const HttpError& error) {
    EXPECT_EQ(std::string(error.what()), "127.0.0.1:" + std::to_string(port_) + ": Address already in use");
  }
}

// However it is cut, a request has one answer: a good one's when its head is whole, a bad one's at that time at the latest.
TEST(HttpExchange, OctetByOctetTheAnswerIsTheSame) {
  const auto handler = [](std::string_view path) { return HttpAnswer{.body = std::string(path)}; };
  for (const std::string request : {"GET /healthz?a HTTP/1.1\r\nHost: here\r\n\r\n", "PUT / HTTP/1.1\r\n\r\n", "no\r\n\r\n",
                                    "GET / HTTP/1.1\r\nContent-Length: 4\r\n\r\n"}) {
    HttpExchange whole(2048), octets(2048);
    const auto answer = whole.take(request, handler);
    ASSERT_TRUE(answer) << request;
    std::optional<std::string> first;
    std::size_t taken = 0;
    while (!first && taken < request.size()) first = octets.take(request.substr(taken++, 1), handler);
    EXPECT_EQ(first, answer) << request;
    EXPECT_TRUE(taken == request.size() || answer->starts_with("HTTP/1.1 4")) << request;
  }
}

TEST(HttpAddress, LoopbackIsWhatOnlyThisMachineReaches) {
  for (const char* loopback : {"127.0.0.1", "127.9.9.9", "::1"}) EXPECT_TRUE(is_loopback(loopback)) << loopback;
  for (const char* other : {"0.0.0.0", "::", "192.168.1.1", "localhost", ""}) EXPECT_FALSE(is_loopback(other)) << other;
}

}  // namespace
}  // namespace foothold::server::testing
