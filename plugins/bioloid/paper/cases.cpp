// The paper's obstacle as a judge of points and of straight movements, and the three demonstrations.
#include "bioloid/paper/cases.hpp"

#include <algorithm>

namespace foothold::bioloid::paper {
namespace {

constexpr double kForbiddenLow[] = {2.0, 3.0}, kForbiddenHigh[] = {9.0, 12.0};  // X, Y
constexpr double kGreatestAngle = 25.0;                                         // deg, itself not allowed

bool outside(const Point& point) {
  for (int k = 0; k < 2; ++k)
    if (point[k] < kForbiddenLow[k] || point[k] > kForbiddenHigh[k]) return true;
  return false;
}

// The part of the segment within the obstacle's slabs, closed, is empty.
bool passes_outside(const Point& from, const Point& to) {
  double begin = 0.0, end = 1.0;
  for (int k = 0; k < 2; ++k) {
    const double way = to[k] - from[k];
    if (way == 0.0) {
      if (from[k] < kForbiddenLow[k] || from[k] > kForbiddenHigh[k]) return true;
      continue;
    }
    const double a = (kForbiddenLow[k] - from[k]) / way, b = (kForbiddenHigh[k] - from[k]) / way;
    begin = std::max(begin, std::min(a, b));
    end = std::min(end, std::max(a, b));
  }
  return begin > end;
}

Space around_the_obstacle(const Point& high) {
  return {.low = Point::Zero(high.size()),
          .high = high,
          .step = Point::Ones(high.size()),
          .valid = outside,
          .joins = passes_outside,
          .place = {}};
}

}  // namespace

Case plane_case() {
  return {around_the_obstacle(Eigen::Vector2d(10.0, 20.0)), Eigen::Vector2d(7.0, 17.0), Eigen::Vector2d(5.0, 2.0)};
}

Case space_case() {
  return {around_the_obstacle(Eigen::Vector3d(10.0, 20.0, 10.0)), Eigen::Vector3d(7.0, 17.0, 7.0), Eigen::Vector3d(5.0, 2.0, 5.0)};
}

Case joints_case() {
  Space space{.low = Point::Constant(3, -90.0),
              .high = Point::Constant(3, 90.0),
              .step = Point::Ones(3),
              .valid = {},
              .joins = {},
              .place = {}};
  space.valid = [](const Point& angles) { return angles.cwiseAbs().maxCoeff() < kGreatestAngle; };
  return {std::move(space), Point::Zero(3), Eigen::Vector3d(20.0, -15.0, 10.0)};
}

}  // namespace foothold::bioloid::paper
