#include "stances.hpp"

#include <cmath>
#include <numbers>

namespace foothold::contact {

namespace {

double between(std::mt19937_64& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

Vector3d in_box(std::mt19937_64& random, const Vector3d& half) {
  Vector3d out;
  for (Eigen::Index k = 0; k < 3; ++k) out[k] = between(random, -half[k], half[k]);
  return out;
}

}  // namespace

Stance random_stance(std::mt19937_64& random) { return random_stance(random, 4 + static_cast<int>(random() % 5)); }

Stance random_stance(std::mt19937_64& random, int contacts) {
  Stance out;
  const double steepest = between(random, 0.1, 70.0 * std::numbers::pi / 180.0);
  Vector3d middle = Vector3d::Zero();
  for (int i = 0; i < contacts; ++i) {
    const double tilt = steepest * std::sqrt(between(random, 0.0, 1.0)), turn = between(random, 0.0, 2.0 * std::numbers::pi);
    out.contacts.push_back(
        {in_box(random, {0.3, 0.25, 0.15}), {std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), std::cos(tilt)}});
    middle += out.contacts.back().point / contacts;
  }
  out.com = middle + Vector3d(between(random, -0.15, 0.15), between(random, -0.15, 0.15), between(random, 0.05, 0.25));
  out.mu = between(random, 0.1, 0.8);
  return out;
}

Stance neighbour(std::mt19937_64& random, const Stance& stance, double metres) {
  Stance out = stance;
  for (Contact& c : out.contacts) {
    c.point += in_box(random, Vector3d::Constant(metres));
    c.normal = (c.normal + in_box(random, Vector3d::Constant(metres))).normalized();
  }
  out.com += in_box(random, Vector3d::Constant(metres));
  return out;
}

Eigen::Matrix<double, 6, Eigen::Dynamic> generators(const Stance& stance, int edges) {
  Eigen::Matrix<double, 6, Eigen::Dynamic> out(6, static_cast<Eigen::Index>(stance.contacts.size()) * edges);
  Eigen::Index column = 0;
  for (const Contact& c : stance.contacts) {
    const auto [t, b] = tangents(c.normal);
    for (int j = 0; j < edges; ++j, ++column) {
      const double angle = 2.0 * std::numbers::pi * j / edges;
      const Vector3d f = c.normal + stance.mu * (std::cos(angle) * t + std::sin(angle) * b);
      out.col(column) << f, (c.point - stance.com).cross(f);
    }
  }
  return out;
}

}  // namespace foothold::contact
