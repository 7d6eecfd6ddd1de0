// What is still to be looked at, by least key; of equal keys the lower index first, so that searches repeat themselves.
#pragma once

#include <limits>
#include <queue>
#include <vector>

namespace foothold::octopod {

// A binary heap whose keys may change: older entries are left in it and passed over.
class OpenList {
 public:
  explicit OpenList(int size) : keys_(static_cast<std::size_t>(size), kClosed) {}

  // Its key from now on.
  void put(int index, double key) {
    keys_[static_cast<std::size_t>(index)] = key;
    heap_.push({key, index});
  }
  // Infinity for what is not open.
  double key(int index) const { return keys_[static_cast<std::size_t>(index)]; }
  bool empty() {
    while (!heap_.empty() && heap_.top().key != key(heap_.top().index)) heap_.pop();
    return heap_.empty();
  }
  double least() { return empty() ? kClosed : heap_.top().key; }
  // Takes out the first. Precondition: not empty.
  int pop() {
    const int out = heap_.top().index;
    heap_.pop();
    keys_[static_cast<std::size_t>(out)] = kClosed;
    return out;
  }

 private:
  static constexpr double kClosed = std::numeric_limits<double>::infinity();
  struct Entry {
    double key;
    int index;
    bool operator<(const Entry& other) const { return key > other.key || (key == other.key && index > other.index); }
  };
  std::vector<double> keys_;
  std::priority_queue<Entry> heap_;
};

}  // namespace foothold::octopod
