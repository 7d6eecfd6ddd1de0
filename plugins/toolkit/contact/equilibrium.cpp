#include "contact/equilibrium.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "contact/certificate.hpp"
#include "contact/projection.hpp"
#include "contact/simplex.hpp"
#include "contact/stance_check.hpp"

namespace foothold::contact {

struct Equilibrium::Work {
  const simplex::Kernel& kernel = simplex::kernel();
  simplex::Problem problem;
  Verdict verdict;
  bool balanced = false;  // the basis is that of a stable verdict
  int warm = -1;          // contacts of the last stance, whose basis is kept; -1: none
};

namespace {

constexpr double kResidual = 1e-11;  // of the balance, above which the basis is factored anew
constexpr double kUnproved = 0.5 * kBalanceTolerance;

// The verdict's forces; kStuck if they balance too badly even from a basis factored anew: so great that their rounding alone is
// too much.
simplex::Outcome balanced(const simplex::Kernel& kernel, simplex::Problem& problem, std::span<const Contact> contacts,
                          std::vector<Vector3d>& forces) {
  forces.resize(contacts.size());
  if (kernel.forces(problem, forces) <= kResidual) return simplex::Outcome::kBalanced;
  kernel.rebuild(problem);
  const simplex::Outcome again = kernel.solve(problem);
  if (again == simplex::Outcome::kBalanced && !(kernel.forces(problem, forces) <= kUnproved)) return simplex::Outcome::kStuck;
  return again;
}

}  // namespace

Equilibrium::Equilibrium(FrictionCone cone) : work_(std::make_unique<Work>()) {
  require_cone(cone);
  simplex::Problem& problem = work_->problem;
  problem.edges = cone.edges;
  const int last = cone.edges % 2 == 0 ? cone.edges / 4 : cone.edges / 2;
  for (int j = 0; j <= last; ++j) {
    const double angle = 2.0 * std::numbers::pi * j / cone.edges;
    problem.cos.push_back(std::cos(angle));
    problem.sin.push_back(std::sin(angle));
  }
}

Equilibrium::~Equilibrium() = default;
Equilibrium::Equilibrium(Equilibrium&&) noexcept = default;
Equilibrium& Equilibrium::operator=(Equilibrium&&) noexcept = default;

void Equilibrium::forget() { work_->warm = -1; }

bool Equilibrium::reaches() const { return work_->balanced; }

Reach Equilibrium::reach(const Vector6d& h) const {
  if (!work_->balanced) throw std::logic_error("reach() is for a stance that was judged stable");
  const double length = work_->problem.length;
  std::array<double, 6> y{};
  Reach out;
  out.length = work_->kernel.reach(work_->problem, {h[0], h[1], h[2], h[3] / length, h[4] / length, h[5] / length}, y);
  if (std::isfinite(out.length)) out.supporting << y[0], y[1], y[2], y[3] / length, y[4] / length, y[5] / length;
  return out;
}

FrictionCone Equilibrium::cone() const { return {work_->problem.edges}; }

const Verdict& Equilibrium::judge(std::span<const Contact> contacts, const Vector3d& com, double mu) {
  const simplex::Kernel& kernel = work_->kernel;
  simplex::Problem& problem = work_->problem;
  Verdict& verdict = work_->verdict;
  const auto count = static_cast<int>(contacts.size());
  const bool warm = work_->warm == count;
  work_->warm = -1;
  work_->balanced = false;
  problem.groups.resize((contacts.size() + simplex::kLanes - 1) / simplex::kLanes);
  problem.mu = mu;
  const bool filled = kernel.fill(problem, contacts, com);
  if (!filled || !(mu >= 0.0) || !std::isfinite(mu) || contacts.empty()) require_stance(contacts, com, mu);
  if (warm) {
    kernel.renew(problem);
  } else {
    kernel.start(problem);
  }
  problem.pivots = 0;
  simplex::Outcome outcome = kernel.solve(problem);
  if (outcome == simplex::Outcome::kBalanced) outcome = balanced(kernel, problem, contacts, verdict.forces);
  work_->warm = count;
  if (outcome == simplex::Outcome::kStuck) {
    // Within rounding of the border of stability: the method that measures the distance from it decides.
    verdict = judge_by_projection(contacts, com, mu, cone());
    verdict.pivots += problem.pivots;
    return verdict;
  }
  verdict.stable = work_->balanced = outcome == simplex::Outcome::kBalanced;
  verdict.proved = true;
  verdict.pivots = problem.pivots;
  if (verdict.stable) {
    verdict.separating.setZero();
  } else {
    verdict.forces.clear();
    const std::array<double, 6>& y = problem.y;
    verdict.separating << y[0], y[1], y[2], y[3] / problem.length, y[4] / problem.length, y[5] / problem.length;
  }
  return verdict;
}

}  // namespace foothold::contact
