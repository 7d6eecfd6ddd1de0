#include "contact/equilibrium.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contact/certificate.hpp"
#include "contact/projection.hpp"
#include "contact/simplex.hpp"
#include "contact/stance_check.hpp"

namespace foothold::contact {

struct Equilibrium::Work {
  simplex::Problem problem;
  Verdict verdict;
  double length = 1.0;  // m: the unit of length inside the problem
  bool warm = false;
};

namespace {

constexpr double kResidual = 1e-11;  // of the balance, above which the basis is factored anew
constexpr double kUnproved = 0.5 * kBalanceTolerance;

void fill(simplex::Problem& problem, std::span<const Contact> contacts, const Vector3d& com, double length) {
  problem.groups.resize((contacts.size() + simplex::kLanes - 1) / simplex::kLanes);
  if (!problem.groups.empty()) problem.groups.back() = {};
  const double scale = 1.0 / length;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    simplex::Group& group = problem.groups[i / simplex::kLanes];
    const std::size_t lane = i % simplex::kLanes;
    const Vector3d& n = contacts[i].normal;
    const auto [t, b] = tangents(n);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      group.r[k][lane] = (contacts[i].point[axis] - com[axis]) * scale;
      group.n[k][lane] = n[axis];
      group.t[k][lane] = t[axis];
      group.b[k][lane] = b[axis];
    }
  }
  problem.contacts = static_cast<int>(contacts.size());
}

// Forces of the basis; how far they are from balancing w.
double forces_of(const simplex::Problem& problem, std::span<const Contact> contacts, const Vector3d& com, double length,
                 std::vector<Vector3d>& forces) {
  forces.assign(contacts.size(), Vector3d::Zero());
  for (std::size_t i = 0; i < 6; ++i) {
    const simplex::Column& column = problem.basis.columns[i];
    if (column.contact < 0) continue;
    const auto k = static_cast<std::size_t>(column.contact);
    const auto [t, b] = tangents(contacts[k].normal);
    const double x = std::max(problem.basis.inverse[2][i], 0.0);
    forces[k] += x * (contacts[k].normal + problem.mu * (column.cos * t + column.sin * b));
  }
  Vector3d force = -Vector3d::UnitZ(), torque = Vector3d::Zero();
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    force += forces[k];
    torque += (contacts[k].point - com).cross(forces[k]);
  }
  return std::max(force.cwiseAbs().maxCoeff(), torque.cwiseAbs().maxCoeff() / length);
}

}  // namespace

Equilibrium::Equilibrium(FrictionCone cone) : work_(std::make_unique<Work>()) {
  require_cone(cone);
  simplex::Problem& problem = work_->problem;
  problem.edges = cone.edges;
  for (int j = 0; j < cone.edges; ++j) {
    const double angle = 2.0 * std::numbers::pi * j / cone.edges;
    problem.cos.push_back(std::cos(angle));
    problem.sin.push_back(std::sin(angle));
  }
}

Equilibrium::~Equilibrium() = default;
Equilibrium::Equilibrium(Equilibrium&&) noexcept = default;
Equilibrium& Equilibrium::operator=(Equilibrium&&) noexcept = default;

void Equilibrium::forget() { work_->warm = false; }

FrictionCone Equilibrium::cone() const { return {work_->problem.edges}; }

const Verdict& Equilibrium::judge(std::span<const Contact> contacts, const Vector3d& com, double mu) {
  simplex::Problem& problem = work_->problem;
  Verdict& verdict = work_->verdict;
  const double length = require_stance(contacts, com, mu);
  const bool warm = work_->warm && problem.contacts == static_cast<int>(contacts.size());
  fill(problem, contacts, com, length);
  problem.mu = mu;
  problem.pivots = 0;
  if (warm) {
    simplex::rebuild(problem);
  } else {
    simplex::start_from_nothing(problem);
  }
  work_->warm = true;
  simplex::Outcome outcome = simplex::solve(problem);
  if (outcome == simplex::Outcome::kBalanced && !(forces_of(problem, contacts, com, length, verdict.forces) <= kResidual)) {
    simplex::rebuild(problem);
    outcome = simplex::solve(problem);
    // Forces so great that their rounding alone is too much are no proof.
    if (outcome == simplex::Outcome::kBalanced && !(forces_of(problem, contacts, com, length, verdict.forces) <= kUnproved))
      outcome = simplex::Outcome::kStuck;
  }
  if (outcome == simplex::Outcome::kStuck) {
    // Within rounding of the border of stability: the method that measures the distance from it decides.
    const int pivots = problem.pivots;
    verdict = judge_by_projection(contacts, com, mu, cone());
    verdict.pivots += pivots;
    return verdict;
  }
  verdict.stable = outcome == simplex::Outcome::kBalanced;
  verdict.proved = true;
  verdict.pivots = problem.pivots;
  verdict.separating.setZero();
  if (!verdict.stable) verdict.forces.clear();
  if (outcome == simplex::Outcome::kSeparated) {
    for (std::size_t k = 0; k < 6; ++k)
      verdict.separating[static_cast<Eigen::Index>(k)] = k < 3 ? problem.y[k] : problem.y[k] / length;
  }
  return verdict;
}

}  // namespace foothold::contact
