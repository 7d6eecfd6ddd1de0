// The links of one leg against each other, in the leg's plane; both legs at once. Private to posture/.
#pragma once

#include "bioloid/posture/bends.hpp"

namespace foothold::bioloid {

// Pairs of one leg's links that may meet: all but neighbours.
struct Fold {
  std::size_t a, b;
};
inline constexpr std::array<Fold, 5> kFolds{
    {{kHipBlock, kShin}, {kHipBlock, kAnkleBlock}, {kHipBlock, kFoot}, {kThigh, kAnkleBlock}, {kThigh, kFoot}}};

// A link's box seen along the pitch axes; the foot's as the ankle block carries it, with the roll's spread.
struct Flat {
  Lanes sine, cosine, x, z, half_x, half_z;
};
Flat flat(const Legs& legs, const Stand& at, std::size_t link);

// From the centre of the first's box to the second's, seen from the first.
FOOTHOLD_INLINE Plane2 offset(const Stand& at, const Fold& fold) {
  const Plane2 &one = at.centre[fold.a], &two = at.centre[fold.b];
  const Lanes x = two.x - one.x, z = two.z - one.z;
  if (fold.a == kHipBlock) return {x, z};
  const Lanes s = at.sine[fold.a - 1], c = at.cosine[fold.a - 1];
  return {c * x - s * z, s * x + c * z};
}

// The widest gap along the rectangles' four axes: not more than the distance.
Lanes gap(const Flat& a, const Flat& b);
// The same along one axis that is fixed in one of the two links, on the same side at both instants; the less of both.
Lanes gap(const Flat& a0, const Flat& b0, const Flat& a1, const Flat& b1);
// Bends of the one, seen from the other.
FOOTHOLD_INLINE Lanes bend_of(const Legs& legs, const Rates& r, const Fold& fold) {
  const std::array<Lanes, kLinks> turn{all(0.0), r.pitch[0], r.pitch[1], r.pitch[2], r.pitch[2]};
  const Lanes roll = fold.b == kFoot ? r.ankle : all(0.0);
  const auto squared = [](Lanes v) { return v * v; };
  const Lanes between = squared(magnitude(turn[fold.b] - turn[fold.a]) + roll);
  Lanes from_a = legs.boxes[fold.b].reach * between;
  Lanes from_b = legs.boxes[fold.a].reach_back * between + legs.boxes[fold.b].reach * squared(roll);
  for (std::size_t k = fold.a + 1; k < fold.b && k <= kShin; ++k) {
    const double length = k == kThigh ? legs.thigh_length : legs.shin_length;
    from_a += length * squared(turn[k] - turn[fold.a]);
    from_b += length * squared(magnitude(turn[k] - turn[fold.b]) + roll);
  }
  return larger(from_a, from_b);
}

}  // namespace foothold::bioloid
