// Small spaces in which the algorithms' results are known, and judges of paths that know nothing of how they were found.
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <vector>

#include "bioloid/paper/paper.hpp"

namespace foothold::bioloid::paper::testing {

inline Point point(std::initializer_list<double> values) {
  Point out(static_cast<Eigen::Index>(values.size()));
  int k = 0;
  for (const double value : values) out[k++] = value;
  return out;
}

inline Space grid(const Point& high, std::function<bool(const Point&)> valid) {
  return {.low = Point::Zero(high.size()),
          .high = high,
          .step = Point::Ones(high.size()),
          .valid = std::move(valid),
          .joins = {},
          .place = {}};
}

inline std::vector<Point> points(std::initializer_list<std::initializer_list<double>> values) {
  std::vector<Point> out;
  for (const auto& value : values) out.push_back(point(value));
  return out;
}

// From start to goal, every point within its limits and valid, every movement at most `steps` steps of each coordinate.
inline void expect_valid(const Space& space, const std::vector<Point>& path, const Point& start, const Point& goal,
                         double steps = 1.0) {
  ASSERT_FALSE(path.empty());
  EXPECT_EQ(path.front(), start);
  EXPECT_EQ(path.back(), goal);
  for (std::size_t k = 0; k < path.size(); ++k) {
    EXPECT_TRUE(space.valid(path[k])) << path[k].transpose();
    EXPECT_TRUE((path[k].array() >= space.low.array()).all() && (path[k].array() <= space.high.array()).all())
        << path[k].transpose();
    if (k == 0) continue;
    EXPECT_LE(((path[k] - path[k - 1]).cwiseAbs().array() / space.step.array()).maxCoeff(), steps + 1e-9) << k;
  }
}

}  // namespace foothold::bioloid::paper::testing
