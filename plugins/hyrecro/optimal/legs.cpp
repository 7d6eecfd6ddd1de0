#include "hyrecro/optimal/legs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "hyrecro/optimal/narrow.hpp"

namespace foothold::hyrecro {
namespace {

// Per stride of a leg: postures' searches in closed form, and by exact reachability, and candidates looked at, before the leg is
// given up.
constexpr std::size_t kTries = 24, kLooks = 4000, kExactTries = 1;
constexpr std::array<double, 5> kAside{0.0, 0.025, -0.025, 0.06, -0.06};  // m, beside the way
constexpr std::array<double, 5> kShares{0.0, 1.0, 0.5, 0.75, 0.25};       // between shortest and longest; 0: even
constexpr std::array<double, 3> kRound{0.25, 0.35, 0.45};                 // m, where ends are too near each other
constexpr std::array<double, 4> kFooting{0.3, 0.2, 0.4, 0.13};            // m, round a foothold
constexpr double kBesideRoom = 0.05;  // m: so far beside the room for a plate in line with the edges an end may stand
constexpr double kNear = 0.15;        // m: ends nearer than this are

constexpr double kNearly = 0.06;  // m: bounds that are nearer than this to what is asked for are looked at closely
constexpr double kMicro = 1e-6;   // m, rad

std::int64_t micro(double value) { return std::llround(value / kMicro); }
double quarter(double heading) { return std::round(heading / (0.5 * std::numbers::pi)) * 0.5 * std::numbers::pi; }

}  // namespace

int Legs::least_anywhere(const Foothold& u, const Foothold& v) const {
  const int least = bounds_.least(u, v);
  if (least != 1) return least;
  const Vector3d& plate = strides_.model().plate;
  return (v.at - u.at).norm() < std::min(plate.x(), plate.y()) + strides_.scene().clearance ? 2 : 1;
}

int Legs::least(const Foothold& u, const Advances& of_u, const Foothold& v, const Advances& of_v) {
  const int anywhere = least_anywhere(u, v);
  if (anywhere == 0) return 0;
  const double way = strip(u.face).along.dot(v.at - u.at);
  const int along = way >= 0.0 ? bounds_.least_along(way, of_u.forth, of_v.back) : bounds_.least_along(-way, of_u.back, of_v.forth);
  return std::max(anywhere, along);
}

double Legs::furthest_along(const Foothold& from, double sense) {
  const Strip& along = strip(from.face);
  const double at = along.across(from.at), heading = from.heading - std::atan2(along.along.y(), along.along.x());
  const auto [entry, fresh] = furthest_.try_emplace(
      {micro(along.low - at), micro(along.high - at), micro(wrapped(heading)), static_cast<std::int64_t>(sense), 0, 0, 0});
  if (fresh) {
    const Advances quick = advances_of(from);
    entry->second = std::min(furthest(bounds_, along, strides_.model().plate.head<2>(), from, sense) + kMicro,
                             sense > 0.0 ? quick.forth : quick.back);
  }
  return entry->second;
}

int Legs::least_exactly(const Foothold& u, const Foothold& v) {
  const int quick = least(u, v);
  if (quick < 2) return quick;
  const Strip& along = strip(u.face);
  const double way = along.along.dot(v.at - u.at), sense = way < 0.0 ? -1.0 : 1.0, reach = bounds_.reach();
  const Advances of_u = advances_of(u), of_v = advances_of(v);
  const double most = (way < 0.0 ? of_u.back + of_v.forth : of_u.forth + of_v.back) + (quick - 2) * reach;
  if (most > std::fabs(way) + kNearly) return quick;
  if (quick > 2) return std::max(quick, bounds_.least_along(std::fabs(way), furthest_along(u, sense), furthest_along(v, -sense)));
  const double turned = std::atan2(along.along.y(), along.along.x());
  const auto [entry, fresh] =
      two_may_do_.try_emplace({micro(along.low), micro(along.high), micro(wrapped(u.heading - turned)), micro(along.across(u.at)),
                               micro(wrapped(v.heading - turned)), micro(along.across(v.at)), micro(way)});
  if (fresh) entry->second = two_may_do(bounds_, along, strides_.model().plate.head<2>(), u, v);
  return entry->second ? 2 : 3;
}

int Legs::least(const Foothold& u, const Foothold& v) { return least(u, advances_of(u), v, advances_of(v)); }

const Strip& Legs::strip(int face) {
  const auto [entry, fresh] = strips_.try_emplace(face);
  if (fresh)
    entry->second = strip_of(strides_.scene().truss.faces[static_cast<std::size_t>(face)].outline,
                             0.5 * std::min(strides_.model().plate.x(), strides_.model().plate.y()));
  return entry->second;
}

std::optional<std::vector<Stride>> Legs::find(const Foothold& u, const Foothold& v, int count, const Banned& banned) {
  start_ = u;
  goal_ = v;
  banned_ = &banned;
  chain_.clear();
  open_.resize(std::max(open_.size(), static_cast<std::size_t>(count)));
  most_tried_ = tried_ + kTries * static_cast<std::size_t>(count);
  most_looks_ = kLooks * static_cast<std::size_t>(count);
  most_exact_ = kExactTries * static_cast<std::size_t>(count);
  if (!walk(count)) return std::nullopt;
  return chain_;
}

bool Legs::has_footing(const Foothold& u, bool thorough) {
  std::vector<Foothold> around;
  for (const double distance : kFooting)
    for (int side = 0; side < 8; ++side) {
      const double to = quarter(u.heading) + side * 0.25 * std::numbers::pi;
      for (const double heading : {to, quarter(to)}) {
        const Foothold next{u.face, u.at + distance * direction(to), heading};
        if (!strides_.on_face(next)) continue;
        ++tried_;
        if (strides_.level(next, u)) return true;
        around.push_back(next);
        if (heading == quarter(to)) break;
      }
    }
  return thorough &&
         std::any_of(around.begin(), around.end(), [&](const Foothold& next) { return strides_.exact(next, u).has_value(); });
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
    if (tried_ >= most_tried_ || most_looks_ == 0) return false;
    --most_looks_;
    if (least_anywhere(from, next) != 1 || least_anywhere(next, goal_) > left - 1 || same(next, goal_) || !strides_.on_face(next))
      continue;
    const std::optional<Coordinates> found = judge(from, next, false);
    if (!found) continue;
    chain_.push_back({next, *found});
    if (walk(left - 1)) return true;
    chain_.pop_back();
  }
  return false;
}

const Legs::Rooms& Legs::rooms(int face) {
  const auto [entry, fresh] = rooms_.try_emplace(face);
  if (!fresh) return entry->second;
  const truss::Face& there = strides_.scene().truss.faces[static_cast<std::size_t>(face)];
  for (const Region& region : shrunk(there, 0.5 * std::min(strides_.model().plate.x(), strides_.model().plate.y()))) {
    geometry::PolygonPaths paths(region.outline, region.holes);
    if (paths.reflex_vertices() > 0) entry->second.push_back(std::move(paths));
  }
  return entry->second;
}

// Empty if the way is straight, or none leads there.
std::vector<Vector2d> Legs::bent_way(const Foothold& from, const Foothold& to) {
  for (const geometry::PolygonPaths& room : rooms(from.face)) {
    const Vector2d a = room.nearest(from.at), b = room.nearest(to.at);
    if ((a - from.at).norm() > kBesideRoom || (b - to.at).norm() > kBesideRoom) continue;
    std::vector<Vector2d> way = room.path(a, b);
    if (way.size() <= 2) return {};
    way.front() = from.at;
    way.back() = to.at;
    return way;
  }
  return {};
}

int Legs::likely(const Foothold& u, const Foothold& v) {
  const std::vector<Vector2d> way = bent_way(u, v);
  double length = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) length += (way[i] - way[i - 1]).norm();
  return std::max(least(u, v), static_cast<int>(std::ceil(length / bounds_.reach())));
}

// At distances along `way`, which begins at `from` and ends at the goal.
void Legs::along(const std::vector<Vector2d>& way, const Foothold& from, int left, std::vector<Foothold>& out) const {
  double length = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) length += (way[i] - way[i - 1]).norm();
  const Vector2d ahead = (way[1] - way[0]).normalized(), behind = (way.back() - way[way.size() - 2]).normalized();
  const double shift = bounds_.shift(), hips = bounds_.reach() - 2.0 * shift;
  const double first = shift * std::fabs(direction(from.heading).dot(ahead)) + shift + hips;
  const double rest = shift * std::fabs(direction(goal_.heading).dot(behind)) + shift + hips + (left - 2) * bounds_.reach();
  const double shortest = std::clamp(length - rest, 0.0, first), longest = std::min(first, length);
  for (const double beside : kAside)
    for (const double share : kShares) {
      const double wanted =
          share == 0.0 ? std::min(length * first / (first + rest), longest) : shortest + share * (longest - shortest);
      double distance = wanted;
      std::size_t piece = 1;
      while (piece + 1 < way.size() && distance > (way[piece] - way[piece - 1]).norm()) {
        distance -= (way[piece] - way[piece - 1]).norm();
        ++piece;
      }
      const Vector2d to = (way[piece] - way[piece - 1]).normalized(), aside(-to.y(), to.x());
      const double heading = std::atan2(to.y(), to.x());
      const Vector2d at = way[piece - 1] + distance * to + beside * aside;
      out.push_back({from.face, at, heading});
      if (quarter(heading) != heading) out.push_back({from.face, at, quarter(heading)});
    }
}

// The ends' shifts as far as they go, the rest in a straight line: how a leg must go that hardly is possible.
void Legs::tight(const Foothold& from, int left, std::vector<Foothold>& out) const {
  const Vector2d difference = goal_.at - from.at, u = direction(from.heading);
  const Vector2d rest = bounds_.rest(difference, u, direction(goal_.heading));
  const double length = rest.norm(), shift = bounds_.shift(), hips = bounds_.reach() - 2.0 * shift;
  if (length < 1e-6) return;
  const double a = std::clamp((difference - rest).dot(u), -shift, shift);
  const double first = length * (hips + shift) / (left * bounds_.reach() - 2.0 * shift);
  out.push_back({from.face, from.at + a * u + first / length * rest, std::atan2(rest.y(), rest.x())});
}

void Legs::candidates(const Foothold& from, int left, std::vector<Foothold>& out) {
  out.clear();
  const double length = (goal_.at - from.at).norm();
  if (length > 1e-6) tight(from, left, out);
  if (length > 1e-6) along({from.at, goal_.at}, from, left, out);
  if (const std::vector<Vector2d> bent = bent_way(from, goal_); !bent.empty()) along(bent, from, left, out);
  if (length > kNear && left < 3) return;
  for (const double distance : kRound)
    for (int side = 0; side < 4; ++side) {
      const double to = side * 0.5 * std::numbers::pi;
      out.push_back({from.face, from.at + distance * direction(to), to});
    }
}

}  // namespace foothold::hyrecro
