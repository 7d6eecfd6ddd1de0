// Which ways round the ring are open while one body holds at a place. Looked at when asked for, and kept.
#pragma once

#include <cstdint>
#include <optional>
#include <stop_token>
#include <unordered_map>

#include "surroundings.hpp"

namespace foothold::xrobin {

// Sets of configurations: bit number - 1.
using ConfigurationSet = std::uint8_t;
inline constexpr ConfigurationSet set_of(int configuration) { return static_cast<ConfigurationSet>(1u << (configuration - 1)); }
inline constexpr bool holds(ConfigurationSet set, int configuration) { return (set >> (configuration - 1) & 1) != 0; }

// Not thread-safe. Places are told apart to 1 nm and 1 nrad, well below what Surroundings leaves open.
class Passage {
 public:
  // Once stop is requested every way that is not yet known is said to be blocked, so that whoever asks comes to an end.
  Passage(const Surroundings& surroundings, std::stop_token stop) : surroundings_(&surroundings), stop_(std::move(stop)) {}

  // The way with the fewest strokes from one configuration to another while body A (or B) holds at `held`; none if both ways are
  // blocked.
  std::optional<RingWay> way(bool a_holds, const PlanarPose& held, int from, int to);
  // Whether any configuration of one set can be reached from any of the other.
  bool connected(bool a_holds, const PlanarPose& held, ConfigurationSet from, ConfigurationSet to);
  // All that can be reached from `from`, itself included.
  ConfigurationSet reachable(bool a_holds, const PlanarPose& held, ConfigurationSet from);

  const Surroundings& surroundings() const { return *surroundings_; }
  bool stopped() const { return stop_.stop_requested(); }
  std::size_t places() const { return places_.size(); }

 private:
  struct Place {
    std::int64_t x, y, heading;
    bool operator==(const Place&) const = default;
  };
  struct Hash {
    std::size_t operator()(const Place& place) const;
  };
  // Bit k: the edge from configuration k + 1.
  struct Edges {
    std::uint8_t known = 0;
    std::uint8_t clear = 0;
  };

  Edges& edges_at(bool a_holds, const PlanarPose& held);
  bool clear(Edges& edges, bool a_holds, const PlanarPose& held, int from);

  const Surroundings* surroundings_;
  std::stop_token stop_;
  std::unordered_map<Place, Edges, Hash> places_;
};

}  // namespace foothold::xrobin
