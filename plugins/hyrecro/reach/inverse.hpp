// Inverse kinematics of HyReCRo: the free variables given, everything else in closed form.
//
// Symbols of Peidro et al. (Int. J. Adv. Robot. Syst. 12:163, 2015), frames of the paper inside; R = Rz(psi0) Ry(hip0 - hip1)
// Rz(-psi1). Regular (|r33| < 1 in the paper's frames): psi0 and psi1 follow from R up to the sign s1; 4 free variables, 4
// branches. Singular (r33 = +-1, the soles' Z axes parallel or antiparallel): psi1 is free as well; 5 free variables, 2 branches.
// Values; any thread.
#pragma once

#include <optional>

#include "hyrecro/model/chain.hpp"

namespace foothold::hyrecro {

// How far |r33| may be from 1 for a pose to count as singular.
inline constexpr double kSingular = 1e-9;
bool singular(const Isometry3d& free_in_holding);

// Signs of a branch: s1 of acos(r33) (regular poses only), s2 of the hip's side: hip0 or pi - hip0.
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

// Empty if the branch has no real solution within the limits for these values.
std::optional<Coordinates> inverse(const Model& model, const Isometry3d& free_in_holding, const Branch& branch, const Free& free);

}  // namespace foothold::hyrecro
