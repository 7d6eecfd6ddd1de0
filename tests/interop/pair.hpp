// Writer's vendor x reader's vendor, as a parameter of tests; and what every test of a pair needs.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <functional>
#include <ostream>
#include <string>
#include <thread>

#include "foothold/transport/bus.hpp"
#include "peer.hpp"

namespace foothold::interop {

using test::Kind;
using test::Peer;

struct Pair {
  std::string writer;
  std::string reader;
};

inline void PrintTo(const Pair& pair, std::ostream* out) { *out << pair.writer << " -> " << pair.reader; }

inline std::string name_of(const testing::TestParamInfo<Pair>& info) { return info.param.writer + "_to_" + info.param.reader; }

inline std::string vendor_name(const testing::TestParamInfo<std::string>& info) { return info.param; }

inline const std::vector<Pair> kPairs = {
    {"cyclone", "cyclone"}, {"cyclone", "fastdds"}, {"fastdds", "cyclone"}, {"fastdds", "fastdds"}};
inline const std::vector<std::string> kVendors = {"cyclone", "fastdds"};

// Tests may run at the same time: each process of a test has a domain of its own.
inline std::uint32_t test_domain() { return 1 + static_cast<std::uint32_t>(getpid()) % transport::kMaxDomain; }

inline std::vector<std::string> bus_peer(const std::string& vendor, const std::string& role, transport::Topic topic,
                                         const std::string& partition = "") {
  return {"bus_peer", vendor, std::to_string(test_domain()), role, std::string(transport::traits(topic).name), partition};
}

inline bool eventually(const std::function<bool()>& true_at_last, double seconds = 20.0) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (!true_at_last()) {
    if (std::chrono::steady_clock::now() > until) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

// Tries again while the writer is full.
inline transport::Writer::Result write_on(transport::Writer& writer, std::span<const std::byte> message, double seconds = 20.0) {
  using Result = transport::Writer::Result;
  Result result = Result::kFull;
  eventually([&] { return (result = writer.write(message)) != Result::kFull; }, seconds);
  return result;
}

}  // namespace foothold::interop
