// Two numbers side by side: the right leg's and the left leg's. SSE2 on x86-64, plain code elsewhere; the same bytes everywhere, as
// nothing is contracted. Private.
#pragma once

#include <cmath>
#include <cstring>

#include "bioloid/model/model.hpp"

namespace foothold::bioloid {

using Lanes = double __attribute__((vector_size(16)));
using LaneBits = long long __attribute__((vector_size(16)));

#define FOOTHOLD_INLINE inline __attribute__((always_inline))

FOOTHOLD_INLINE Lanes all(double value) { return Lanes{value, value}; }
FOOTHOLD_INLINE double of(const Lanes& v, Side side) { return v[index_of(side)]; }
FOOTHOLD_INLINE Lanes larger(Lanes a, Lanes b) { return a > b ? a : b; }
FOOTHOLD_INLINE Lanes smaller(Lanes a, Lanes b) { return a < b ? a : b; }
FOOTHOLD_INLINE Lanes magnitude(Lanes a) { return reinterpret_cast<Lanes>(reinterpret_cast<LaneBits>(a) & 0x7fffffffffffffffLL); }
FOOTHOLD_INLINE Lanes swapped(Lanes a) { return __builtin_shuffle(a, LaneBits{1, 0}); }
FOOTHOLD_INLINE bool both_above(Lanes a, double limit) { return (a[0] >= limit) & (a[1] >= limit); }

FOOTHOLD_INLINE Lanes root(Lanes a) { return Lanes{std::sqrt(a[0]), std::sqrt(a[1])}; }

struct Lanes3 {
  Lanes x, y, z;
  Vector3d at(Side side) const { return {of(x, side), of(y, side), of(z, side)}; }
};
FOOTHOLD_INLINE Lanes3 in_both(const Vector3d& v) { return {all(v.x()), all(v.y()), all(v.z())}; }
FOOTHOLD_INLINE Lanes3 lanes(const Vector3d& right, const Vector3d& left) {
  return {Lanes{right.x(), left.x()}, Lanes{right.y(), left.y()}, Lanes{right.z(), left.z()}};
}
FOOTHOLD_INLINE Lanes dot(const Lanes3& a, const Lanes3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
FOOTHOLD_INLINE Lanes3 operator+(const Lanes3& a, const Lanes3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
FOOTHOLD_INLINE Lanes3 operator-(const Lanes3& a, const Lanes3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
FOOTHOLD_INLINE Lanes3 operator*(Lanes t, const Lanes3& a) { return {t * a.x, t * a.y, t * a.z}; }

// Error below 2e-16. The kernels are those of fdlibm (Sun, 1993) on [-pi/4, pi/4]. Precondition: |angle| < 1000.
FOOTHOLD_INLINE void sine_and_cosine(Lanes angle, Lanes& sine, Lanes& cosine) {
  constexpr double kRound = 6755399441055744.0;  // 1.5 * 2^52: its last bits hold the whole number that is added
  const Lanes moved = angle * 0.63661977236758134308 + kRound, turns = moved - kRound;
  const LaneBits quarter = reinterpret_cast<LaneBits>(moved);
  const Lanes r = (angle - turns * 1.57079632673412561417e+00) - turns * 6.07710050650619224932e-11;
  const Lanes z = r * r;
  const Lanes s =
      r + r * z *
              (-1.66666666666666324348e-01 +
               z * (8.33333333332248946124e-03 +
                    z * (-1.98412698298579493134e-04 +
                         z * (2.75573137070700676789e-06 + z * (-2.50507602534068634195e-08 + z * 1.58969099521155010221e-10)))));
  const Lanes c =
      (1.0 - 0.5 * z) +
      z * z *
          (4.16666666666666019037e-02 +
           z * (-1.38888888888741095749e-03 +
                z * (2.48015872894767294178e-05 +
                     z * (-2.75573143513906633035e-07 + z * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11)))));
  const LaneBits odd = -(quarter & 1), s_bits = reinterpret_cast<LaneBits>(s), c_bits = reinterpret_cast<LaneBits>(c);
  const LaneBits s_sign = (quarter & 2) << 62, c_sign = ((quarter + 1) & 2) << 62;
  sine = reinterpret_cast<Lanes>(((odd & c_bits) | (~odd & s_bits)) ^ s_sign);
  cosine = reinterpret_cast<Lanes>(((odd & s_bits) | (~odd & c_bits)) ^ c_sign);
}

}  // namespace foothold::bioloid
