// Messages with random contents, for properties that hold for every message: through JSON and back, through both vendors and back.
#pragma once

#include <foothold.h>

#include <concepts>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <type_traits>
#include <vector>

#include "foothold/msg/fields.hpp"
#include "foothold/msg/ids.hpp"

namespace foothold::test {

struct RandomLimits {
  std::size_t items = 4;        // of a sequence, at most
  std::size_t characters = 12;  // of a string, at most
};

template <class E>
constexpr std::uint32_t values_of() {
  if constexpr (std::is_same_v<E, msg::ShapeKind>) return msg::POLYGON + 1;
  if constexpr (std::is_same_v<E, msg::ParameterKind>) return msg::CHOICE + 1;
  if constexpr (std::is_same_v<E, msg::State>) return msg::REJECTED + 1;
  if constexpr (std::is_same_v<E, msg::SceneState>) return msg::REFUSED + 1;
  if constexpr (std::is_same_v<E, msg::RobotState>) return msg::UNAVAILABLE + 1;
}

// Finite numbers only, from the smallest to the largest: what is not finite differs from itself.
class RandomContents {
 public:
  explicit RandomContents(std::uint64_t seed, RandomLimits limits = {}) : random_(seed), limits_(limits) {}

  template <class M>
  M make() {
    M message;
    fill(message);
    return message;
  }

  void fill(bool& flag) { flag = below(2) == 1; }
  void fill(double& number) {
    constexpr double kOdd[] = {0.0,
                               -0.0,
                               0.1,
                               1e-310,
                               std::numeric_limits<double>::max(),
                               std::numeric_limits<double>::lowest(),
                               std::numeric_limits<double>::denorm_min()};
    number = below(4) == 0 ? kOdd[below(std::size(kOdd))] : std::normal_distribution<double>(0.0, 10.0)(random_);
  }
  void fill(std::string& text) {
    static const std::vector<std::string> kPieces = {"a", "Z", "0", " ", "\"", "\\", "\n", "\x01", "ü", "漢", "🦶", "/", "<"};
    text.clear();
    for (std::size_t count = below(limits_.characters + 1); count > 0; --count) text += kPieces[below(kPieces.size())];
  }
  void fill(msg::Id& id) {
    for (std::uint8_t& octet : id) octet = static_cast<std::uint8_t>(below(256));
  }
  template <std::integral N>
  requires(!std::same_as<N, bool>) void fill(N& number) { number = static_cast<N>(random_()); }
  template <class E>
  requires std::is_enum_v<E>
  void fill(E& value) { value = static_cast<E>(below(values_of<E>())); }
  template <class T>
  void fill(std::vector<T>& list) {
    list.resize(below(limits_.items + 1));
    for (T& item : list) fill(item);
  }
  template <msg::Struct M>
  void fill(M& message) {
    msg::fields(message, [this](const char*, auto& member) { fill(member); });
    if constexpr (std::is_same_v<M, msg::Placement>)  // one base at most
      if (message.base().size() > 1) message.base().resize(1);
  }

 private:
  std::size_t below(std::size_t bound) { return static_cast<std::size_t>(random_() % bound); }

  std::mt19937_64 random_;
  RandomLimits limits_;
};

}  // namespace foothold::test
