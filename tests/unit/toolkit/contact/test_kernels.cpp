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

// The greatest number of B^-1 B - 1, the columns of B written down anew.
double inexactness(const Problem& p, const Stance& s) {
  double most = 0.0;
  for (std::size_t k = 0; k < 6; ++k) {
    const Column& column = p.basis.columns[k];
    Vector6d g = Vector6d::Zero();
    if (column.contact < 0) {
      g[-1 - column.contact] = 1.0;
    } else {
      const Contact& c = s.contacts[static_cast<std::size_t>(column.contact)];
      const auto [t, b] = tangents(c.normal);
      const Vector3d f = c.normal + s.mu * (column.cos * t + column.sin * b);
      g << f, (c.point - s.com).cross(f) / p.length;
    }
    for (std::size_t row = 0; row < 6; ++row) {
      double sum = row == k ? -1.0 : 0.0;
      for (std::size_t j = 0; j < 6; ++j) sum += p.basis.inverse[j][row] * g[static_cast<Eigen::Index>(j)];
      most = std::max(most, std::abs(sum));
    }
  }
  return most;
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
      const Stance next = neighbour(random, s, 0.005);
      for (const auto make : {&Kernel::renew, &Kernel::rebuild}) {
        ASSERT_TRUE(narrow.fill(a, next.contacts, next.com) && wide->fill(b, next.contacts, next.com));
        (narrow.*make)(a);
        (wide->*make)(b);
        ASSERT_TRUE(same_bytes(a.basis, b.basis)) << "stance " << i << ", width " << width << ", anew";
      }
    }
  }
}

TEST(Kernels, InvertTheBasisOfANeighbouringStanceAndOfAFarOne) {
  std::mt19937_64 random(16);
  for (int i = 0; i < 4000; ++i) {
    const Stance s = random_stance(random, 8);
    const Stance next = i % 2 == 0 ? neighbour(random, s, 0.005) : random_stance(random, 8);
    for (const auto make : {&Kernel::renew, &Kernel::rebuild}) {
      Problem p = problem_of(kernel(), s, 10);
      kernel().solve(p);
      p.mu = next.mu;
      ASSERT_TRUE(kernel().fill(p, next.contacts, next.com));
      (kernel().*make)(p);
      double greatest = 1.0;
      for (const Eight& column : p.basis.inverse)
        for (std::size_t row = 0; row < 6; ++row) greatest = std::max(greatest, std::abs(column[row]));
      // What rounding makes of pivots of 1e-3 and more.
      ASSERT_LT(inexactness(p, next), 1e-11 * greatest) << "stance " << i;
    }
  }
}

}  // namespace
}  // namespace foothold::contact::simplex
