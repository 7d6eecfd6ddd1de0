// Inverse kinematics of HyReCRo: the free variables given, everything else in closed form.
//
// Symbols of Peidro et al. (Int. J. Adv. Robot. Syst. 12:163, 2015), frames of the paper inside; R = Rz(psi0) Ry(hip0 - hip1)
// Rz(-psi1). Regular (the soles' Z axes, in the paper's frames, not parallel): psi0 and psi1 follow from R up to the sign s1; 4
// free variables, 4 branches. Singular (parallel or antiparallel): psi1 is free as well; 5 free variables, 2 branches. Values; any
// thread.
#pragma once

#include <optional>

#include "hyrecro/model/chain.hpp"

namespace foothold::hyrecro {

// A pose counts as singular if the soles' Z axes (paper's frames) are this near to parallel, rad: far below what a check of the
// contact tells apart, far above rounding. The solutions of a pose that is taken as singular are off by that much at most.
inline constexpr double kSingular = 1e-7;
bool singular(const Isometry3d& free_in_holding);

// Signs of a branch: s1 of sin(hip0 - hip1) (regular poses only), s2 of cos(hip0).
struct Branch {
  int s1 = 1, s2 = 1;
};

struct Free {
  double phi1 = 0.0;    // rad, of the free leg's ankle mechanism
  double lambda = 0.0;  // m, of the free leg
  double split0 = 0.5;  // 0..1: where y1 lies in the interval that lambda leaves it, leg 0
  double split1 = 0.5;  // the same for leg 1
  double psi1 = 0.0;    // rad, singular poses only
};

// Empty if the branch has no real solution within the limits for these values. Closes with forward() within 1e-9 (m, rad) for
// regular poses and for poses that are singular by construction.
std::optional<Coordinates> inverse(const Model& model, const Isometry3d& free_in_holding, const Branch& branch, const Free& free);

// Branch and free variables of given coordinates: inverse() of their pose with these gives them back.
Branch branch_of(const Coordinates& coordinates);
Free free_of(const Model& model, const Coordinates& coordinates);

// y1 of a leg with the angles phi1 and phi2 whose length is lambda: where both mechanisms keep their limits; empty if nowhere.
kinematics::Interval first_offsets(const Model& model, double phi1, double phi2, double lambda);

}  // namespace foothold::hyrecro
