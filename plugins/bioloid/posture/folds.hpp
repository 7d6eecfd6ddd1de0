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

// The widest gap along the rectangles' four axes: not more than the distance.
Lanes gap(const Flat& a, const Flat& b);
// The same along one axis that is fixed in one of the two links, on the same side at both instants; the less of both.
Lanes gap(const Flat& a0, const Flat& b0, const Flat& a1, const Flat& b1);
// Bends of the one, seen from the other.
Lanes bend_of(const Legs& legs, const Rates& rates, const Fold& fold);

}  // namespace foothold::bioloid
