// How many strides a leg takes at least: a bound in closed form, without any lattice.
//
// In a face both soles lie in one plane, so the hip plate's normal is one vector and hip_drop cancels: seen from above, a stride is
// p = s0 e(h0) + T - s1 e(h1), with h0, h1 the headings, s0, s1 the shifts lambda sin(phi1) of the upper pins and |T| at most the
// distance t of the hip axes. Regular postures have psi = 0, so |s| <= S. In singular ones (h1 = h0 or h0 + pi) both legs lean by
// the same psi along the same line; one shift may exceed S then, but |s0| + |s1| <= 2 S still holds, with S the greatest half of
// that sum over all psi. A chain of n strides from u to v therefore keeps v - u within
//   { a e(h_u) + b e(h_v) : |a|, |b| <= S }  grown by  (n - 1) 2 S + n t :
// each foothold between gives both its shifts, 2 S, in any direction.
//
// On a narrow face there is less. Both upper pins of a regular posture are at one height, and at the low heights that allow the
// greatest shifts small shifts are not possible: a foot that heads across the face either shifts its hip aside, where the strip
// ends, or keeps the other foot from its greatest shift. One stride's advance along a strip, from a sole with this heading and
// place to any sole that stands in the strip, is advance(); the strides at both ends of a chain keep to it, those between to r_max.
// Values; any thread.
#pragma once

#include <vector>

#include "hyrecro/model/model.hpp"
#include "hyrecro/route/route.hpp"

namespace foothold::hyrecro {

class StrideBounds {
 public:
  explicit StrideBounds(const Model& model);

  double shift() const { return shift_; }                        // S, m
  double reach() const { return 2.0 * shift_ + hip_distance_; }  // r_max: the longest stride in a face, m
  double transition_reach() const { return transition_reach_; }  // no two soles are further apart in any posture, m
  // What is left of `difference` when both ends have given the best of their shifts: the strides' hips and the footholds between
  // must make up for it.
  Vector2d rest(const Vector2d& difference, const Vector2d& heading_u, const Vector2d& heading_v) const;
  // Strides that lead from `u` to `v` on one face at least; 0 if they are equal.
  int least(const Foothold& u, const Foothold& v) const;
  // The same for the difference v - u of their places and the unit vectors of their headings. Does not ask whether they are equal:
  // at least 1.
  int least(const Vector2d& difference, const Vector2d& heading_u, const Vector2d& heading_v) const;

  // Greatest advance (m) along a direction of one stride in a face: from a sole that heads along `heading` (unit, seen in axes of
  // which X is the direction) to any that stands from `low` to `high` (m) to its left. Symmetric: from there to here it is the
  // same.
  double advance(const Vector2d& heading, double low, double high) const;
  // The same if the other heads along `other`, or along what lies within `turn` (rad) of it; less than `enough` need not be exact.
  double advance(const Vector2d& heading, double low, double high, const Vector2d& other, double turn, double enough) const;
  // Strides of a chain that advances by `distance` (m), if the first advances by `first` at most and the last by `last`.
  int least_along(double distance, double first, double last) const;

 private:
  // Shifts of one leg, and the greatest of the other at the heights that they allow, rounded up; m.
  struct Shifts {
    double low = 0.0, high = 0.0, other = 0.0;
  };
  struct Upright {
    double least = 0.0, most = 0.0;  // m, shifts at one height, rounded outwards
  };
  void couple_shifts(const Model& model);

  double shift_ = 0.0, hip_distance_ = 0.0, transition_reach_ = 0.0;
  std::vector<Shifts> coupled_;   // falling
  std::vector<Upright> upright_;  // by height, the greatest shifts first
};

// A strip that holds all places of soles on a face: its direction, and the range across it.
struct Strip {
  Vector2d along = Vector2d::UnitX();  // unit
  double low = 0.0, high = 0.0;        // m, of the places' component along (-along.y, along.x)
  double inset = 0.0;                  // m, by which the outline is wider on either side

  double across(const Vector2d& place) const { return along.x() * place.y() - along.y() * place.x(); }
};
// The narrowest along an edge of the outline. `inset`: no sole's centre is nearer to the outline, m.
Strip strip_of(const Polygon& outline, double inset);

// What the strides from (or to) a foothold advance at most along its strip, forwards and backwards, m.
struct Advances {
  double forth = 0.0, back = 0.0;
};
Advances advances(const StrideBounds& bounds, const Strip& strip, const Foothold& foothold);

// Same face, place and heading (modulo 2 pi) within 1e-9.
bool same(const Foothold& a, const Foothold& b);
inline Vector2d direction(double heading) { return {std::cos(heading), std::sin(heading)}; }

}  // namespace foothold::hyrecro
