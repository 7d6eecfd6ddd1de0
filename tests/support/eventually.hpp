// Waits for something that another thread brings about; the limit is for a stuck test, never a measure.
#pragma once

#include <chrono>
#include <thread>

namespace foothold::test {

template <class Condition>
bool eventually(Condition condition, double seconds = 20.0) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  return true;
}

}  // namespace foothold::test
