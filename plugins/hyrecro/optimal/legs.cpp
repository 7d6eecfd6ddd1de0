#include "hyrecro/optimal/legs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace foothold::hyrecro {
namespace {

// Per stride of a leg: postures' searches in closed form, and by exact reachability, before the leg is given up.
constexpr std::size_t kTries = 40, kExactTries = 2;
constexpr std::array<double, 5> kAside{0.0, 0.025, -0.025, 0.06, -0.06};  // m, beside the way
constexpr std::array<double, 5> kShares{0.0, 1.0, 0.5, 0.75, 0.25};       // between shortest and longest; 0: even
constexpr std::array<double, 3> kRound{0.25, 0.35, 0.45};                 // m, where ends are too near each other
constexpr double kNear = 0.15;                                            // m: ends nearer than this are

double quarter(double heading) { return std::round(heading / (0.5 * std::numbers::pi)) * 0.5 * std::numbers::pi; }

}  // namespace

int Legs::least(const Foothold& u, const Foothold& v) const {
  const int least = bounds_.least(u, v);
  if (least != 1) return least;
  const Vector3d& plate = strides_.model().plate;
  return (v.at - u.at).norm() < std::min(plate.x(), plate.y()) + strides_.scene().clearance ? 2 : 1;
}

std::optional<std::vector<Stride>> Legs::find(const Foothold& u, const Foothold& v, int count, const Banned& banned) {
  start_ = u;
  goal_ = v;
  banned_ = &banned;
  chain_.clear();
  open_.resize(std::max(open_.size(), static_cast<std::size_t>(count)));
  most_tried_ = tried_ + kTries * static_cast<std::size_t>(count);
  most_exact_ = kExactTries * static_cast<std::size_t>(count);
  if (!walk(count)) return std::nullopt;
  return chain_;
}

std::optional<Coordinates> Legs::judge(const Foothold& from, const Foothold& to, bool last) {
  if (*banned_ && (*banned_)(from, to)) return std::nullopt;
  ++tried_;
  std::optional<Coordinates> found = strides_.level(from, to);
  if (!found && last && most_exact_ > 0) {
    --most_exact_;
    found = strides_.exact(from, to);
  }
  return found;
}

bool Legs::walk(int left) {
  const Foothold from = chain_.empty() ? start_ : chain_.back().to;
  if (left == 1) {
    const std::optional<Coordinates> found = judge(from, goal_, true);
    if (found) chain_.push_back({goal_, *found});
    return found.has_value();
  }
  std::vector<Foothold>& open = open_[static_cast<std::size_t>(left) - 1];
  candidates(from, left, open);
  for (const Foothold& next : open) {
    if (tried_ >= most_tried_) return false;
    if (least(from, next) != 1 || least(next, goal_) > left - 1 || same(next, goal_) || !strides_.on_face(next)) continue;
    const std::optional<Coordinates> found = judge(from, next, false);
    if (!found) continue;
    chain_.push_back({next, *found});
    if (walk(left - 1)) return true;
    chain_.pop_back();
  }
  return false;
}

void Legs::candidates(const Foothold& from, int left, std::vector<Foothold>& out) const {
  out.clear();
  const Vector2d way = goal_.at - from.at;
  const double length = way.norm(), heading = length > 1e-6 ? std::atan2(way.y(), way.x()) : from.heading;
  const Vector2d along = direction(heading), aside(-along.y(), along.x());
  const double shift = bounds_.shift(), hips = bounds_.reach() - 2.0 * shift;
  const double first = shift * std::fabs(direction(from.heading).dot(along)) + shift + hips;
  const double rest = shift * std::fabs(direction(goal_.heading).dot(along)) + shift + hips + (left - 2) * bounds_.reach();
  const double shortest = std::max(0.0, length - rest), longest = std::min(first, length);
  const std::array<double, 2> headings{heading, quarter(heading)};
  for (const double beside : kAside)
    for (const double share : kShares) {
      const double distance =
          share == 0.0 ? std::min(length * first / (first + rest), longest) : shortest + share * (longest - shortest);
      for (const double turned : headings) out.push_back({from.face, from.at + distance * along + beside * aside, turned});
      if (headings[0] == headings[1]) out.pop_back();
    }
  if (length > kNear && left < 3) return;
  for (const double distance : kRound)
    for (int side = 0; side < 4; ++side) {
      const double to = side * 0.5 * std::numbers::pi;
      out.push_back({from.face, from.at + distance * direction(to), to});
    }
}

}  // namespace foothold::hyrecro
