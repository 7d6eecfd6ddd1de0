// The footholds of a leg: from one foothold to another on the same face in a given number of strides.
//
// Candidates lie along the way at shares of what each stride can cover, headed along it; where that fails they move sideways, turn,
// or go round. The way is straight; on faces with reflex corners the shortest way inside is tried as well. Every choice keeps the
// strides that are left enough by StrideBounds, so that with as many strides as the bound demands hardly anything is tried in vain.
// Depth first, with a limit of tries.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

#include "geometry/polygon_path.hpp"
#include "hyrecro/optimal/strides.hpp"

namespace foothold::hyrecro {

using Banned = std::function<bool(const Foothold&, const Foothold&)>;

// Borrows `strides`. Used by one thread at a time.
class Legs {
 public:
  explicit Legs(Strides& strides) : strides_(strides), bounds_(strides.bounds()) {}

  // Least strides of a leg that no posture contradicts: StrideBounds, also along the face's strip, and 2 where both plates would
  // overlap.
  int least(const Foothold& u, const Foothold& v);
  // The same with both footholds' advances() along strip(), for those that ask often.
  int least(const Foothold& u, const Advances& of_u, const Foothold& v, const Advances& of_v);
  // The same to the millimetre, for those that ask seldom (milliseconds where it is near).
  int least_exactly(const Foothold& u, const Foothold& v);
  const Strip& strip(int face);
  Advances advances_of(const Foothold& foothold) { return advances(bounds_, strip(foothold.face), foothold); }

  // What a leg along the face takes about: least(), or more where the straight way leaves the face.
  int likely(const Foothold& u, const Foothold& v);

  // Whether a stride leads to `u` from a likely place around; legs to where none does are not looked for. gates.hpp finds what
  // leads there all the same.
  // `thorough`: asked by exact reachability where the closed form finds none.
  bool has_footing(const Foothold& u, bool thorough);

  // Exactly `count` strides from `u` to `v`, the last one to `v`; empty if none was found. Precondition: count >= least(u, v) > 0.
  std::optional<std::vector<Stride>> find(const Foothold& u, const Foothold& v, int count, const Banned& banned);

  // The same with far more tries: the first and the last foothold all over the strip, the ones between by find(). Tenths of a
  // second where there is none.
  std::optional<std::vector<Stride>> find_thoroughly(const Foothold& u, const Foothold& v, int count, const Banned& banned);

  std::size_t tried() const { return tried_; }  // strides judged, since construction

 private:
  // Where a foot may stand on a face, by the plate's half width; empty for faces without reflex corners, where ways are straight.
  using Rooms = std::vector<geometry::PolygonPaths>;
  // Without the strip.
  int least_anywhere(const Foothold& u, const Foothold& v) const;
  struct Reached {
    Stride stride;         // from the end to there
    double advance = 0.0;  // m
  };
  std::vector<Reached> reached_from(const Foothold& end, double sense, double least, double most, const Banned& banned);
  std::optional<std::vector<Stride>> two(const Foothold& u, const Foothold& v, const Banned& banned);
  template <typename Take>
  bool scan(const Foothold& end, double sense, double least, double most, const Take& take);
  double furthest_along(const Foothold& from, double sense);
  bool walk(int left);
  std::optional<Coordinates> judge(const Foothold& from, const Foothold& to, bool last);
  void candidates(const Foothold& from, int left, std::vector<Foothold>& out);
  void along(const std::vector<Vector2d>& way, const Foothold& from, int left, std::vector<Foothold>& out) const;
  void tight(const Foothold& from, int left, std::vector<Foothold>& out) const;
  const Rooms& rooms(int face);
  std::vector<Vector2d> bent_way(const Foothold& from, const Foothold& to);

  Strides& strides_;
  const StrideBounds& bounds_;
  Foothold start_, goal_;
  const Banned* banned_ = nullptr;
  std::vector<Stride> chain_;
  std::vector<std::vector<Foothold>> open_;  // candidates by depth
  std::unordered_map<int, Rooms> rooms_;     // by face
  std::unordered_map<int, Strip> strips_;    // by face
  // What narrow.hpp found: by the strip's borders and the ends' headings and places across, in micrometres and microradians.
  using Ends = std::array<std::int64_t, 7>;
  std::map<Ends, bool> two_may_do_;
  std::map<Ends, double> furthest_;
  std::size_t tried_ = 0, most_tried_ = 0, most_looks_ = 0, most_exact_ = 0;
};

}  // namespace foothold::hyrecro
