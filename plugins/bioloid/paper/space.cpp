// Points, limits and the advance of one iteration.
#include "bioloid/paper/space.hpp"

#include <cmath>

namespace foothold::bioloid::paper {
namespace {

constexpr double kRounding = 1e-6;  // of a step

}  // namespace

bool Space::within_limits(const Point& point) const {
  for (int k = 0; k < dimension(); ++k)
    if (!(point[k] >= low[k] - kRounding * step[k] && point[k] <= high[k] + kRounding * step[k])) return false;
  return true;
}

bool Space::moves(const Point& from, const Point& to) const {
  return within_limits(to) && valid(to) && (!joins || joins(from, to));
}

bool same(const Space& space, const Point& a, const Point& b) {
  return ((a - b).cwiseAbs().array() <= kRounding * space.step.array()).all();
}

Point advanced(const Space& space, const Point& from, const Point& goal, const Directions& directions, int times) {
  Point out = from;
  for (int k = 0; k < space.dimension(); ++k) {
    const double way = directions[k] * times * space.step[k], left = goal[k] - from[k];
    const bool towards = way * left > 0.0;
    const bool arrives = towards && std::abs(left) <= std::abs(way) + kRounding * space.step[k];
    out[k] = arrives ? goal[k] : from[k] + way;
    // What wanders back to its goal by sums of steps is on it, not a rounding beside it.
    if (std::abs(out[k] - goal[k]) <= kRounding * space.step[k]) out[k] = goal[k];
  }
  return out;
}

}  // namespace foothold::bioloid::paper
