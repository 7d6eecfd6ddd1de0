#include "hyrecro/reach/labels.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <thread>

#include "hyrecro/reach/reachability.hpp"

namespace foothold::hyrecro {
namespace {

constexpr std::size_t kChunk = 4096;  // poses from one random stream

}  // namespace

std::vector<Sample> labelled(const Model& model, const LabelOptions& options, const std::function<void(std::size_t)>& done) {
  std::vector<Sample> out(options.count);
  std::atomic<std::size_t> next{0};
  std::mutex told;
  std::size_t ready = 0;
  const auto work = [&] {
    const std::unique_ptr<Reachability> exact = make_exact(model, options.clearance);
    for (std::size_t begin; (begin = kChunk * next++) < out.size();) {
      const std::size_t end = std::min(begin + kChunk, out.size());
      std::seed_seq words{static_cast<std::uint32_t>(options.seed), static_cast<std::uint32_t>(options.seed >> 32),
                          static_cast<std::uint32_t>(begin / kChunk)};
      std::mt19937_64 random(words);
      for (std::size_t i = begin; i < end; ++i) {
        const Isometry3d pose = random_pose(options.kind, options.radius, random);
        out[i].inputs = inputs_of(options.kind, pose);
        // The answer is the same from either foot; where the search misses a posture from one, it may find it from the other.
        const bool reachable = exact->reach(pose, {}).reachable || exact->reach(pose.inverse(), {}).reachable;
        out[i].reachable = reachable ? 1.0F : 0.0F;
      }
      const std::lock_guard lock(told);
      ready += end - begin;
      if (done) done(ready);
    }
  };
  std::vector<std::jthread> others;
  for (unsigned i = 1; i < options.threads; ++i) others.emplace_back(work);
  work();
  others.clear();
  return out;
}

}  // namespace foothold::hyrecro
