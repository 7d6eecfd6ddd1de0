// main() of the tests that start real processes: they run in a network of their own.
#include <gtest/gtest.h>

#include <cstdio>

#include "network_namespace.hpp"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  if (!foothold::test::enter_own_network()) std::puts("no network namespace here: on this machine's loopback");
  return RUN_ALL_TESTS();
}
