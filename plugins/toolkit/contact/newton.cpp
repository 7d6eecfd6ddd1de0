#include "contact/newton.hpp"

#include <Eigen/Cholesky>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "contact/stance_check.hpp"

namespace foothold::contact {

NewtonEquilibrium::NewtonEquilibrium(const NewtonSettings& settings) : settings_(settings) {
  require_cone(FrictionCone::pyramid(settings.edges));
  if (settings.edges == 0) throw std::invalid_argument("Newton's method needs a pyramid: 3 edges or more");
  if (settings.iterations < 1 || settings.starts < 1) throw std::invalid_argument("Newton's method needs a start and an iteration");
  if (!(settings.tolerance > 0.0)) throw std::invalid_argument("the tolerance of Newton's method must be positive");
}

bool NewtonEquilibrium::stable(std::span<const Contact> contacts, const Vector3d& com, double mu, std::mt19937_64& random) {
  const double length = require_stance(contacts, com, mu);
  iterations_ = 0;
  if (contacts.empty()) return false;
  const Eigen::Index count = static_cast<Eigen::Index>(contacts.size()) * settings_.edges;
  columns_.resize(6, count);
  Eigen::Index column = 0;
  for (const Contact& c : contacts) {
    const auto [t, b] = tangents(c.normal);
    for (int j = 0; j < settings_.edges; ++j, ++column) {
      const double angle = 2.0 * std::numbers::pi * j / settings_.edges;
      const Vector3d f = c.normal + mu * (std::cos(angle) * t + std::sin(angle) * b);
      columns_.col(column) << f, (c.point - com).cross(f) / length;
    }
  }
  for (int start = 0; start < settings_.starts; ++start) {
    lambda_.resize(count);
    for (double& value : lambda_) value = 2.0 / static_cast<double>(count) * (static_cast<double>(random() >> 11) * 0x1p-53);
    t_ = lambda_.sqrt();
    if (converges()) return true;
  }
  return false;
}

// The Jacobian is [G 0; I -2T]. With the residuals (F, r) its shortest step is J^T (p, q), where J J^T (p, q) = -(F, r); the second
// row block, (I + 4 T^2) q = -r - G^T p, leaves six equations: G D G^T p = -F + G (I + 4 T^2)^-1 r with D = 4 T^2 (I + 4 T^2)^-1.
bool NewtonEquilibrium::converges() {
  for (int k = 0; k <= settings_.iterations; ++k) {
    Vector6d balance = columns_ * lambda_.matrix();
    balance[2] -= 1.0;
    residual_ = lambda_ - t_.square();
    if (balance.cwiseAbs().maxCoeff() <= settings_.tolerance && residual_.abs().maxCoeff() <= settings_.tolerance) return true;
    if (k == settings_.iterations) break;
    ++iterations_;
    weight_ = (1.0 + 4.0 * t_.square()).inverse();
    const Eigen::Matrix<double, 6, 6> six = columns_ * (1.0 - weight_).matrix().asDiagonal() * columns_.transpose();
    const Eigen::LDLT<Eigen::Matrix<double, 6, 6>> factored(six);
    const Vector6d p = factored.solve(Vector6d(columns_ * (weight_ * residual_).matrix() - balance));
    if (!p.allFinite()) return false;
    const auto along = (columns_.transpose() * p).array();
    // q into residual_; then the step is (G^T p + q, -2 T q).
    residual_ = -weight_ * (residual_ + along);
    lambda_ += along + residual_;
    t_ -= 2.0 * t_ * residual_;
  }
  return false;
}

std::vector<Vector3d> NewtonEquilibrium::forces() const {
  std::vector<Vector3d> out(static_cast<std::size_t>(columns_.cols() / settings_.edges), Vector3d::Zero());
  for (Eigen::Index j = 0; j < columns_.cols(); ++j)
    out[static_cast<std::size_t>(j / settings_.edges)] += lambda_[j] * columns_.col(j).head<3>();
  return out;
}

}  // namespace foothold::contact
