// The planar parallel mechanism 2RPR-PR: two linear actuators side by side move a body along a slider and turn it.
//
// The base carries the actuators' pins at x = -b and x = +b, the body its own at -p and +p seen from its turning point, which
// slides along the base's Y axis. T(base, body) = Ty(y) Rz(phi). Lengths l (left) and r (right):
//   l^2 = (p - b cos phi)^2 + (y + b sin phi)^2,  r^2 = (p - b cos phi)^2 + (y - b sin phi)^2
// (Peidro, Gil, Marin, Reinoso, Int. J. Adv. Robot. Syst. 12:163, 2015). Metres and radians. Values; any thread.
#pragma once

namespace foothold::kinematics {

struct Interval {
  double low = 0.0;
  double high = -1.0;
  bool empty() const { return !(low <= high); }
  bool holds(double value, double tolerance = 0.0) const { return value >= low - tolerance && value <= high + tolerance; }
};

class PlanarMechanism {
 public:
  struct Pose {
    double phi = 0.0;  // rad, of the body about Z
    double y = 0.0;    // m, of its turning point
  };
  struct Lengths {
    double left = 0.0;  // m
    double right = 0.0;
  };

  // Precondition: 0 < b, p and b + p < shortest < longest.
  PlanarMechanism(double b, double p, double shortest, double longest);

  // Both actuators, whatever their limits.
  Lengths lengths(const Pose& pose) const;
  // The pose that belongs to two lengths, in the only assembly with y > 0 and |phi| < 90 deg. Precondition: such a pose exists;
  // it does for lengths between shortest and longest if greatest_phi() is below 90 deg. Error below 1e-14.
  Pose forward(const Lengths& lengths) const;
  // All y for which both actuators keep their limits at `phi`; empty if none.
  Interval offsets(double phi) const;
  // |phi| beyond which offsets() is empty.
  double greatest_phi() const { return greatest_phi_; }
  double base() const { return b_; }
  double body() const { return p_; }
  double shortest() const { return shortest_; }
  double longest() const { return longest_; }

 private:
  double b_, p_, shortest_, longest_;
  double greatest_phi_;
};

}  // namespace foothold::kinematics
