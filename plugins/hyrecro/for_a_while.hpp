// Work that may take part of a budget, but not all of it.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

namespace foothold::hyrecro {

// Stop is requested of token() after `seconds`, or when it is requested of `outer`. Its thread ends with it.
class ForAWhile {
 public:
  ForAWhile(double seconds, const std::stop_token& outer)
      : forward_(outer, [this] { source_.request_stop(); }), watch_([this, seconds](const std::stop_token& over) {
          std::mutex mutex;
          std::unique_lock lock(mutex);
          std::condition_variable_any waiting;
          waiting.wait_for(lock, over, std::chrono::duration<double>(seconds), [] { return false; });
          if (!over.stop_requested()) source_.request_stop();
        }) {}
  std::stop_token token() const { return source_.get_token(); }

 private:
  std::stop_source source_;
  std::stop_callback<std::function<void()>> forward_;
  std::jthread watch_;
};

}  // namespace foothold::hyrecro
