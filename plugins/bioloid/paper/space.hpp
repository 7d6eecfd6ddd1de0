// What the paper's algorithms move in: n coordinates with limits and a fixed advance each, and a judge of points ("valid movement /
// not valid movement", paper, section II.D). Nine joints of a leg, or a point in a plane: to the algorithms it is the same.
//
// The units are the caller's. Values; the functions are called on the thread that plans.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>

namespace foothold::bioloid::paper {

inline constexpr int kMostCoordinates = 18;
using Point = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kMostCoordinates, 1>;
// A choice for each coordinate and iteration: +1 forward, -1 back, 0 still.
using Directions = Eigen::Matrix<int, Eigen::Dynamic, 1, 0, kMostCoordinates, 1>;

struct Space {
  Point low, high;  // limits, included
  Point step;       // advance of a coordinate in one iteration, > 0
  // Whether a point within the limits is valid.
  std::function<bool(const Point&)> valid;
  // Whether the movement from a valid point to another one is valid. Empty: whenever both are, as in the paper, which judges points
  // only. With it nothing is jumped that the movement would hit.
  std::function<bool(const Point&, const Point&)> joins;
  // The Cartesian position of the end effector, for the trimming; empty: the point itself.
  std::function<Point(const Point&)> place;
  double equal = 1e-9;  // positions no farther apart count as equal, in their unit

  int dimension() const { return static_cast<int>(low.size()); }
  bool within_limits(const Point& point) const;
  // Limits, point and movement; the search's only question.
  bool moves(const Point& from, const Point& to) const;
};

// Equal up to rounding: a millionth of a step in every coordinate.
bool same(const Space& space, const Point& a, const Point& b);

// Every coordinate one step (`times` its own) in its direction. A coordinate that would pass its goal, or come nearer to it than
// rounding, stops on it: the paper's goals lie a whole number of steps away, ours need not.
Point advanced(const Space& space, const Point& from, const Point& goal, const Directions& directions, int times = 1);

}  // namespace foothold::bioloid::paper
