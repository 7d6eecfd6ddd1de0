// The equilibrium test of Molla-Santamaria et al. 2023, section 4, as printed: the baseline beside Equilibrium.
//
// Unknowns: lambda_ij, the forces along the pyramids' edges, and t_ij. Equations: (2), sum lambda_ij (f_ij, p_i x f_ij) = w, and
// (3), lambda_ij = t_ij^2. Newton's method for this system, which has fewer equations than unknowns, from random lambda: each step
// is the shortest one that solves the linearised equations. It proves nothing when it does not converge.
#pragma once

#include <random>
#include <vector>

#include "contact/contact.hpp"

namespace foothold::contact {

struct NewtonSettings {
  int edges = 10;           // of each pyramid (paper)
  int iterations = 50;      // of one start
  int starts = 1;           // tries before the stance counts as unstable
  double tolerance = 1e-9;  // greatest residual of an equation, in weights and weights x greatest distance
};

// Keeps its arrays; one thread at a time.
class NewtonEquilibrium {
 public:
  // Throws std::invalid_argument for fewer than 3 edges, no iterations, no starts or a tolerance that is not positive.
  explicit NewtonEquilibrium(const NewtonSettings& settings);

  // True if Newton's method converges. Errors as Equilibrium::judge. `random`: where lambda starts, evenly between 0 and 2 /
  // (number of lambdas) weights.
  bool stable(std::span<const Contact> contacts, const Vector3d& com, double mu, std::mt19937_64& random);

  // After stable() said true: the force at each contact, in weights, world frame.
  [[nodiscard]] std::vector<Vector3d> forces() const;
  // Newton steps of the last call, over all starts.
  [[nodiscard]] int iterations() const { return iterations_; }

 private:
  using Columns = Eigen::Matrix<double, 6, Eigen::Dynamic>;

  bool converges();

  NewtonSettings settings_;
  Columns columns_;
  Eigen::ArrayXd lambda_, t_, residual_, weight_;
  int iterations_ = 0;
};

}  // namespace foothold::contact
