#include "pairs.hpp"

#include <cmath>
#include <numbers>

namespace foothold::collision {

double Pairs::length() { return kind_ == Kind::kAnywhere ? uniform(0.0, 0.3) : 0.05 * integer(0, 6); }

Isometry3d Pairs::pose() {
  Isometry3d out = Isometry3d::Identity();
  if (kind_ == Kind::kAnywhere) {
    out.translate(Vector3d(uniform(-0.4, 0.4), uniform(-0.4, 0.4), uniform(-0.4, 0.4)));
    out.rotate(Eigen::Quaterniond(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)).normalized());
    return out;
  }
  out.translate(0.05 * Vector3d(integer(-8, 8), integer(-8, 8), integer(-8, 8)));
  for (const Vector3d& axis : {Vector3d(Vector3d::UnitX()), Vector3d(Vector3d::UnitY()), Vector3d(Vector3d::UnitZ())})
    out.rotate(Eigen::AngleAxisd(0.25 * std::numbers::pi * integer(0, 7), axis));
  if (kind_ == Kind::kNearlyLattice) {
    const double little = std::pow(10.0, uniform(-12.0, -4.0));
    out.rotate(Eigen::AngleAxisd(little, Vector3d(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)).normalized()));
    out.translate(little * Vector3d(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)));
  }
  return out;
}

Capsule Pairs::capsule() {
  const Isometry3d at = pose();
  const double half = integer(0, 7) == 0 ? 0.0 : length();
  return {at * Vector3d(0.0, 0.0, -half), at * Vector3d(0.0, 0.0, half), 0.1 * length()};
}

Box Pairs::box() { return {pose(), Vector3d(length(), length(), length())}; }

std::vector<Vector3d> Pairs::polygon() {
  const Isometry3d at = pose();
  std::vector<Vector3d> out;
  if (kind_ != Kind::kAnywhere && integer(0, 1) == 0) {
    const double x = length(), y = length();
    for (const auto& [i, j] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) out.push_back(at * Vector3d(i * x, j * y, 0.0));
    return out;
  }
  const int count = integer(3, 6);
  const double radius = 0.05 + length();
  for (int k = 0; k < count; ++k) {
    const double angle = 2.0 * std::numbers::pi * (k + uniform(0.0, 0.9)) / count;
    out.push_back(at * Vector3d(radius * std::cos(angle), 0.7 * radius * std::sin(angle), 0.0));
  }
  return out;
}

}  // namespace foothold::collision
