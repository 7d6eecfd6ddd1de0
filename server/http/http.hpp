// A small HTTP/1.1 server for figures and health: GET and HEAD, one request a connection, everything bounded. It shares the loop
// that does the work, so that it answers only while that does.
//
// What a peer sends is untrusted: a head of 8 kB at most, no body, five seconds for the request and as long for taking the answer,
// and 16 connections at once; the next one waits in the kernel until one of these has ended.
#pragma once

#include <utility>  // before Asio, whose 1.74 forgets it under C++20

#include <boost/asio/io_context.hpp>
#include <chrono>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

#include "http/exchange.hpp"

namespace foothold::server {

// The address cannot be listened at. what(): "<address>:<port>: <reason>".
class HttpError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct HttpLimits {
  std::uint32_t head = 8192;                 // octets of the request
  std::size_t connections = 16;              // at once
  std::chrono::milliseconds patience{5000};  // for the request, and again for the answer
};

// Thread rule: the loop.
class HttpServer {
 public:
  // `address`: an IPv4 or IPv6 address as numbers; `port` 0: one that is free. Throws HttpError.
  HttpServer(boost::asio::io_context& loop, const std::string& address, std::uint16_t port, HttpHandler handler,
             HttpLimits limits = {});
  ~HttpServer();  // ends every connection; the handler is not called after it
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  std::uint16_t port() const;
  std::string url() const;  // "http://127.0.0.1:9747"

 private:
  class Door;
  std::shared_ptr<Door> door_;
};

// Numbers that only this machine can reach: 127.0.0.0/8 and ::1. False for what is no address.
bool is_loopback(const std::string& address);

}  // namespace foothold::server
