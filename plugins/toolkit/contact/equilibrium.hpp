// Static equilibrium of a stance: can contact forces inside the friction cones hold the robot's weight? Each verdict carries its
// proof: such forces, or a wrench that separates the weight from all that the contacts can give.
//
// The wrench that holds the weight is w = (0, 0, 1, 0, 0, 0), about the centre of mass, in weights. Contact i at r_i from the
// centre of mass gives f_i in its cone and the torque r_i x f_i (Hirukawa et al. 2006). Either w is such a sum, or (Farkas) there
// is a y with y.w > 0 and y.(f, r_i x f) <= 0 for every f of every cone.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "contact/contact.hpp"

namespace foothold::contact {

struct Verdict {
  bool stable = false;
  // False only where rounding hides both proofs; `stable` is then false. Seen within 1e-9 weights of the border of stability, with
  // circular cones within 1e-8.
  bool proved = false;
  // If stable: the force on the robot at each contact, in weights, world frame. Else empty.
  std::vector<Vector3d> forces;
  // If not: y, about the centre of mass; first what multiplies forces (1), then what multiplies torques (1/m). Else zero.
  Vector6d separating = Vector6d::Zero();
  int pivots = 0;  // steps of the simplex method
};

// How far the contacts hold more than the weight.
struct Reach {
  double length = 0.0;  // the greatest t for which w + t h is held; infinity if any is
  // If finite, y: y.h = 1 and y.(f, r x f) <= 0 for every f of every cone, within 1e-10; so no wrench v with y.v > 0 is held. Units
  // as Verdict::separating.
  Vector6d supporting = Vector6d::Zero();
};

// A primal simplex method on the six rows of the balance. Columns (directions on the cones) are never written down: the best of
// each cone is found in closed form, so that a pyramid of any number of edges and the circular cone cost about the same.
// Deterministic: the same calls in the same order give the same bytes on any machine.
//
// Keeps its last basis and starts the next question from it if that has as many contacts: cheap for a sequence of neighbouring
// stances. No allocation after the first call with the greatest number of contacts. One thread at a time; any number of objects.
class Equilibrium {
 public:
  // Throws std::invalid_argument for 1, 2 or less than 0 edges, or more than 1024.
  explicit Equilibrium(FrictionCone cone);
  ~Equilibrium();
  Equilibrium(Equilibrium&&) noexcept;
  Equilibrium& operator=(Equilibrium&&) noexcept;

  // The verdict is this object's: it stays until the next call. `com`: centre of mass, m, world frame. No contacts: not stable.
  // Throws std::invalid_argument if mu is negative or anything is not finite, or if a normal is not of unit length within 1e-6.
  const Verdict& judge(std::span<const Contact> contacts, const Vector3d& com, double mu);

  // Of the stance judged last, for a wrench h about its centre of mass (weights, weights x m; not zero). Throws std::logic_error if
  // the last verdict was not `stable`, or was left to the second judge at the border of stability (see reaches()).
  [[nodiscard]] Reach reach(const Vector6d& h) const;
  // Whether reach() may be asked now.
  [[nodiscard]] bool reaches() const;

  // The next question starts from nothing, as the first one did: its answer no longer depends on what was asked before.
  void forget();

  [[nodiscard]] FrictionCone cone() const;

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

}  // namespace foothold::contact
