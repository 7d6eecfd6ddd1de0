// The same loops compiled for vectors of 2, 4 and 8 numbers give the same bytes: a plan does not depend on the machine.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "contact/simplex.hpp"
#include "stances.hpp"

namespace foothold::contact::simplex {
namespace {

Problem problem_of(const Kernel& kernel, const Stance& s, int edges) {
  Problem p;
  p.edges = edges;
  for (int j = 0; j <= edges / 4; ++j) {
    p.cos.push_back(std::cos(2.0 * std::numbers::pi * j / std::max(edges, 1)));
    p.sin.push_back(std::sin(2.0 * std::numbers::pi * j / std::max(edges, 1)));
  }
  p.mu = s.mu;
  p.groups.resize((s.contacts.size() + kLanes - 1) / kLanes);
  EXPECT_TRUE(kernel.fill(p, s.contacts, s.com));
  kernel.start(p);
  return p;
}

bool same_bytes(const Basis& a, const Basis& b) {
  return std::memcmp(a.inverse.data(), b.inverse.data(), sizeof(a.inverse)) == 0 && std::memcmp(&a.x, &b.x, sizeof(a.x)) == 0;
}

TEST(Kernels, OfEachWidthGiveTheSameBytes) {
  const Kernel& narrow = *kernel_of_width(2);
  for (const int width : {4, 8}) {
    const Kernel* wide = kernel_of_width(width);
    if (wide == nullptr) continue;  // this machine has no such vectors
    std::mt19937_64 random(15);
    for (int i = 0; i < 2000; ++i) {
      const Stance s = random_stance(random, 1 + i % 20);
      const int edges = i % 3 == 0 ? 0 : 10;
      Problem a = problem_of(narrow, s, edges), b = problem_of(*wide, s, edges);
      ASSERT_TRUE(same_bytes(a.basis, b.basis)) << "stance " << i << ", width " << width << ", before";
      ASSERT_EQ(narrow.solve(a), wide->solve(b));
      ASSERT_TRUE(same_bytes(a.basis, b.basis)) << "stance " << i << ", width " << width;
      ASSERT_EQ(a.pivots, b.pivots);
      ASSERT_EQ(std::memcmp(a.y.data(), b.y.data(), sizeof(a.y)), 0);
    }
  }
}

}  // namespace
}  // namespace foothold::contact::simplex
