// Carries committed batches from the log into the database, in a thread of its own: that takes time and waits for the disk, and the
// loop must do neither.
#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "journal/entry.hpp"
#include "journal/log.hpp"
#include "journal/store.hpp"

namespace foothold::server {

class Carrier {
 public:
  // `log` outlives this; its old segments are removed from here.
  Carrier(std::unique_ptr<Store> store, const Log& log);
  ~Carrier();  // carries the rest, unless the database does not take it: then the log keeps it for the next start
  Carrier(const Carrier&) = delete;
  Carrier& operator=(const Carrier&) = delete;

  void push(BatchPointer batch);
  // The number of the last batch that the database holds.
  std::uint64_t carried() const { return carried_.load(std::memory_order_acquire); }
  // Waits for that. False if the database does not take it.
  bool wait_carried(std::uint64_t number);
  // Forgets requests that ended before `stamp`, little by little.
  void forget_before(Stamp stamp);
  // Why the database takes nothing at present; empty if it does.
  std::string trouble() const;

 private:
  void work();
  bool carry(const std::vector<BatchPointer>& batches);
  void forget();

  std::unique_ptr<Store> store_;
  const Log& log_;
  mutable std::mutex mutex_;  // of all up to trouble_
  std::condition_variable wake_, progress_;
  std::vector<BatchPointer> queue_;
  std::optional<Stamp> forget_;
  bool sleeping_ = false;
  bool hurry_ = false;
  bool stopping_ = false;
  std::string trouble_;
  std::atomic<std::uint64_t> carried_ = 0;
  std::thread thread_;
};

}  // namespace foothold::server
