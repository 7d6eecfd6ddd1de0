// The scan of bit maps: the fast version gives what each single look gives.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "near_map.hpp"

namespace foothold::xrobin {
namespace {

TEST(NearMap, FindsExactlyThePlacesThatSingleLooksFindAndMissesNoPoint) {
  std::mt19937_64 random(9);
  std::uniform_real_distribution<float> unit(-0.1F, 0.1F);
  std::vector<float> x(500), y(500);
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = unit(random), y[k] = unit(random);
  const NearMap map = near_map(x, y, 0.15, 0.002, 1e-7);
  // Places beside the map, and numbers of places that are no multiple of eight.
  std::uniform_real_distribution<float> wide(-0.3F, 0.3F);
  for (const std::size_t count : {0u, 1u, 7u, 8u, 9u, 1003u}) {
    std::vector<float> px(count), py(count);
    for (std::size_t k = 0; k < count; ++k) px[k] = wide(random), py[k] = wide(random);
    std::vector<std::uint32_t> found(count + 8);
    const float dx = 0.03F, dy = -0.01F;
    const std::size_t n = near_places(map, px.data(), py.data(), count, dx, dy, found.data());
    std::vector<std::uint32_t> expected;
    for (std::size_t k = 0; k < count; ++k) {
      const float u = px[k] + dx;
      const float v = py[k] + dy;
      if (map.at(u, v)) expected.push_back(static_cast<std::uint32_t>(k));
      bool near = false;
      for (std::size_t i = 0; i < x.size(); ++i) near = near || std::hypot(x[i] - u, y[i] - v) <= 0.002F;
      EXPECT_TRUE(!near || map.at(u, v)) << k;
    }
    found.resize(n);
    EXPECT_EQ(found, expected);
  }
}

}  // namespace
}  // namespace foothold::xrobin
