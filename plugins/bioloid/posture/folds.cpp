// Rectangles in the leg's plane.
#include "bioloid/posture/folds.hpp"

#include <algorithm>

namespace foothold::bioloid {
namespace {

// Along the four axes: the signed offset of the centres and how far both reach.
struct Axes {
  std::array<Lanes, 4> offset, extent;
};
FOOTHOLD_INLINE Axes axes(const Flat& a, const Flat& b) {
  const Lanes c = magnitude(a.cosine * b.cosine + a.sine * b.sine), s = magnitude(b.sine * a.cosine - b.cosine * a.sine);
  const Lanes x = b.x - a.x, z = b.z - a.z;
  return {{a.cosine * x - a.sine * z, a.sine * x + a.cosine * z, b.cosine * x - b.sine * z, b.sine * x + b.cosine * z},
          {a.half_x + b.half_x * c + b.half_z * s, a.half_z + b.half_x * s + b.half_z * c, b.half_x + a.half_x * c + a.half_z * s,
           b.half_z + a.half_x * s + a.half_z * c}};
}

}  // namespace

Flat flat(const Legs& legs, const Stand& at, std::size_t link) {
  const auto& half = legs.boxes[link].half;
  const Plane2& c = at.centre[link];
  if (link == kHipBlock) return {all(0.0), all(1.0), c.x, c.z, half.x, half.z};
  const std::size_t pitch = std::min<std::size_t>(link - 1, 2);
  const Lanes deep = link == kFoot ? half.y * magnitude(at.roll_sine) + half.z * magnitude(at.roll_cosine) : half.z;
  return {at.sine[pitch], at.cosine[pitch], c.x, c.z, half.x, deep};
}

Lanes gap(const Flat& a, const Flat& b) {
  const Axes g = axes(a, b);
  Lanes best = magnitude(g.offset[0]) - g.extent[0];
  for (std::size_t k = 1; k < 4; ++k) best = larger(best, magnitude(g.offset[k]) - g.extent[k]);
  return best;
}

Lanes gap(const Flat& a0, const Flat& b0, const Flat& a1, const Flat& b1) {
  const Axes g = axes(a0, b0), h = axes(a1, b1);
  constexpr long long kSign = ~0x7fffffffffffffffLL;
  Lanes best = all(-1e9);
  for (std::size_t k = 0; k < 4; ++k) {
    // The second offset counts along the first's side: negative if it lies on the other.
    const LaneBits other_side = (reinterpret_cast<LaneBits>(g.offset[k]) ^ reinterpret_cast<LaneBits>(h.offset[k])) & kSign;
    const Lanes there = reinterpret_cast<Lanes>(reinterpret_cast<LaneBits>(magnitude(h.offset[k])) | other_side);
    best = larger(best, smaller(magnitude(g.offset[k]) - g.extent[k], there - h.extent[k]));
  }
  return best;
}

}  // namespace foothold::bioloid
