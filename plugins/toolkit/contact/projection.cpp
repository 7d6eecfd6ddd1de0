#include "contact/projection.hpp"

#include <Eigen/QR>
#include <cmath>
#include <numbers>

#include "contact/stance_check.hpp"

namespace foothold::contact {

namespace {

constexpr int kRounds = 400;
constexpr double kTouches = 1e-14;    // distance from w at which the nearest point is w
constexpr double kHolds = 3e-10;      // ... at which its forces hold: a third of what a certificate forgives
constexpr double kOverhang = 0.5e-5;  // greatest u.g of a separating u, as a part of u.w
constexpr double kRoundoff = 1e-16;   // u.g of what cannot be told from 0
// A circular cone is taken a little wider, by a part of mu that certificates forgive: then rays near to the best one are as good as
// the best one is for the cone as it is, and the search ends instead of making rays ever closer to each other.
constexpr double kWidening = 2e-10;
constexpr double kDependent = 1e-12;

using Columns = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, 6>;
using Weights = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 6, 1>;

// A direction on a cone and its wrench.
struct Ray {
  std::size_t contact = 0;
  Vector3d force = Vector3d::Zero();
  Vector6d wrench = Vector6d::Zero();
};

struct Farthest {
  Ray ray;             // of a cone wider by kWidening if circular
  double reach = 0.0;  // y.g, greatest over the cones as they are
};

struct Cones {
  std::span<const Contact> contacts;
  const Vector3d& com;
  double length, mu;
  FrictionCone cone;

  // Where y.g is greatest.
  [[nodiscard]] Farthest farthest(const Vector6d& y) const {
    const double wider = cone.edges == 0 ? mu * (1.0 + kWidening) : mu;
    Farthest best;
    best.reach = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      const Vector3d& n = contacts[i].normal;
      const Vector3d r = (contacts[i].point - com) / length;
      const auto [t, b] = tangents(n);
      const Vector3d v = y.head<3>() + y.tail<3>().cross(r);
      double angle = std::atan2(v.dot(b), v.dot(t));
      if (cone.edges > 0) {
        const double apart = 2.0 * std::numbers::pi / cone.edges;
        angle = apart * std::round(angle / apart);
      }
      const Vector3d along = std::cos(angle) * t + std::sin(angle) * b;
      if (const double reach = v.dot(n) + mu * v.dot(along); reach > best.reach) {
        best.reach = reach;
        best.ray.contact = i;
        best.ray.force = n + wider * along;
        best.ray.wrench << best.ray.force, r.cross(best.ray.force);
      }
    }
    return best;
  }
};

// The rays whose weights are positive, with the weights of least distance from w.
struct ActiveSet {
  std::vector<Ray> rays;
  Weights weights = Weights::Zero(0);

  [[nodiscard]] Columns columns() const {
    Columns out(6, static_cast<Eigen::Index>(rays.size()));
    for (std::size_t j = 0; j < rays.size(); ++j) out.col(static_cast<Eigen::Index>(j)) = rays[j].wrench;
    return out;
  }

  void drop(std::size_t j) {
    rays.erase(rays.begin() + static_cast<std::ptrdiff_t>(j));
    Weights fewer(static_cast<Eigen::Index>(rays.size()));
    for (Eigen::Index k = 0; k < fewer.size(); ++k) fewer[k] = weights[k < static_cast<Eigen::Index>(j) ? k : k + 1];
    weights = fewer;
  }

  // False if the ray adds nothing.
  bool add(const Ray& ray, const Vector6d& w) {
    if (rays.size() == 6) drop_least();
    rays.push_back(ray);
    const Weights before = weights;
    weights.resize(static_cast<Eigen::Index>(rays.size()));
    weights << before, 0.0;
    for (bool fresh = true; !rays.empty(); fresh = false) {
      const Eigen::ColPivHouseholderQR<Columns> factored(columns());
      if (fresh && std::abs(factored.matrixR().diagonal().tail<1>()[0]) < kDependent) break;
      const Weights target = factored.solve(w);
      if (fresh && !(target[target.size() - 1] > 0.0)) break;
      if ((target.array() > 0.0).all()) {
        weights = target;
        return true;
      }
      retreat(target);
    }
    if (!rays.empty()) drop(rays.size() - 1);
    return false;
  }

 private:
  // As far towards the target as all weights stay positive; what becomes 0 leaves.
  void retreat(const Weights& target) {
    double part = 1.0;
    Eigen::Index leaving = 0;
    for (Eigen::Index j = 0; j < target.size(); ++j) {
      if (target[j] > 0.0) continue;
      const double here = weights[j] / (weights[j] - target[j]);
      if (here <= part) {
        part = here;
        leaving = j;
      }
    }
    weights += part * (target - weights);
    drop(static_cast<std::size_t>(leaving));
  }

  void drop_least() {
    Eigen::Index least = 0;
    weights.minCoeff(&least);
    drop(static_cast<std::size_t>(least));
  }
};

// The unit vector along w's part that is orthogonal to the rays: as exact as it can be, however small the part. Zero if they span
// all.
Vector6d orthogonal_to(const ActiveSet& active, const Vector6d& remainder) {
  Vector6d out = remainder.normalized();
  if (active.rays.empty()) return out;
  const Eigen::ColPivHouseholderQR<Columns> factored(active.columns());
  if (factored.rank() == 6) return Vector6d::Zero();
  for (int k = 0; k < 2; ++k) {
    Vector6d turned = factored.householderQ().transpose() * out;
    turned.head(factored.rank()).setZero();
    out = (factored.householderQ() * turned).normalized();
  }
  return out;
}

}  // namespace

Verdict judge_by_projection(std::span<const Contact> contacts, const Vector3d& com, double mu, FrictionCone cone) {
  require_cone(cone);
  const Cones cones{contacts, com, require_stance(contacts, com, mu), mu, cone};
  const Vector6d w = Vector6d::Unit(2);
  ActiveSet active;
  Vector6d remainder = w, u = w;
  Verdict out;
  for (; out.pivots < kRounds && remainder.norm() > kTouches; ++out.pivots) {
    u = orthogonal_to(active, remainder);
    if (u.isZero()) break;
    const auto [ray, reach] = cones.farthest(u);
    if (contacts.empty() || reach <= std::max(kRoundoff, kOverhang * u[2] * (remainder.norm() > kHolds ? 1.0 : 0.0))) break;
    if (!active.add(ray, w)) break;
    remainder = w - active.columns() * active.weights;
  }
  out.stable = remainder.norm() <= kHolds;
  if (out.stable) {
    out.proved = true;
    out.forces.assign(contacts.size(), Vector3d::Zero());
    for (std::size_t j = 0; j < active.rays.size(); ++j)
      out.forces[active.rays[j].contact] += active.weights[static_cast<Eigen::Index>(j)] * active.rays[j].force;
    return out;
  }
  out.proved = contacts.empty() || (!u.isZero() && cones.farthest(u).reach <= kOverhang * u[2]);
  out.separating << u.head<3>(), u.tail<3>() / cones.length;
  return out;
}

}  // namespace foothold::contact
