// The four ways to pair a server's vendor with a client's, as a parameter of tests.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <ostream>
#include <string>
#include <vector>

namespace foothold::test {

struct VendorPair {
  const char* server;
  const char* client;
  friend std::ostream& operator<<(std::ostream& out, const VendorPair& pair) {
    return out << pair.server << " server, " << pair.client << " client";
  }
};

inline constexpr std::array kVendorPairs{VendorPair{"cyclone", "cyclone"}, VendorPair{"cyclone", "fastdds"},
                                         VendorPair{"fastdds", "cyclone"}, VendorPair{"fastdds", "fastdds"}};

// CycloneServerFastddsClient
inline std::string pair_name(const testing::TestParamInfo<VendorPair>& info) {
  const auto capital = [](std::string word) {
    word[0] = static_cast<char>(word[0] - 'a' + 'A');
    return word;
  };
  return capital(info.param.server) + "Server" + capital(info.param.client) + "Client";
}

// Either vendor alone, as a parameter.
inline const std::vector<std::string> kVendors{"cyclone", "fastdds"};
inline std::string vendor_name(const testing::TestParamInfo<std::string>& info) { return info.param; }

}  // namespace foothold::test
