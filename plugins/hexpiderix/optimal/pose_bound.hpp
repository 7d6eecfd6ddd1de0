// What no thorax pose of a box of poses can exceed: an upper bound of NESM, or the certainty that none of them is a posture.
//
// The robot as it is at the box' middle moves and turns as one body; beside that, a supporting leg's foot stays where it is and its
// knee follows within the arcs that the foot's distance allows, and a swinging leg is raised. Metres, radians. Any thread.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "contact/support_polygon.hpp"
#include "hexpiderix/stance/stance.hpp"

namespace foothold::hexpiderix {

// Along, across, height; roll, pitch, yaw: counted from the frame of the supports.
using PoseVector = std::array<double, 6>;

class PoseBound {
 public:
  // `frame`: origin on the ground, Z its normal, X the heading.
  PoseBound(const Model& model, const Plane& ground, const Footholds& footholds, const Isometry3d& frame, double clearance);

  Isometry3d pose(const PoseVector& at) const;
  // Upper bound of NESM over all poses within `half` of `middle`; empty if none of them is a posture.
  std::optional<double> operator()(const PoseVector& middle, const PoseVector& half) const;

 private:
  struct Spread {
    double shift, turn;  // of the box: how far the thorax moves (m) and turns (rad) from the middle
    double rise, tilt;   // of that along the ground's normal (m) and about axes in the ground (rad): a yaw lifts nothing
  };
  // A leg's first moment as at the middle, kg m in the thorax' frame, and how far it can be from that, kg m.
  struct Moment {
    Vector3d rigid = Vector3d::Zero();
    double beside = 0.0;
  };
  // Add a leg's share; false if the leg cannot reach from anywhere in the box.
  bool supporting(std::size_t leg, const Isometry3d& thorax, const Spread& spread, Moment& sum) const;
  bool swinging(std::size_t leg, const Isometry3d& thorax, const Spread& spread, Moment& sum) const;
  // Of a centre of mass in a box round `centre` with half edges `half` along the frame's axes, grown by `radius`.
  double nesm_over(const Vector3d& centre, const PoseVector& half, double radius) const;

  struct Edge {
    Vector3d corner, along, rise, left;  // unit vectors; left and rise lie across the edge
    double cos_psi;
  };
  // A leg's directions in the thorax' frame, and its axis.
  struct Mount {
    Vector3d out, side, coxa;
  };
  void tabulate_swing(std::size_t leg);

  const Model& model_;
  Plane ground_;
  Footholds footholds_;
  Isometry3d frame_;
  double clearance_;
  std::vector<Edge> edges_;
  std::array<Mount, kLegs> mounts_;
  std::array<Vector3d, 6> corners_;  // of the thorax' underside, its frame
  std::array<std::vector<Vector3d>, kLegs>
      swinging_;                           // first moments, kg m in the thorax' frame, from model.lift on in small steps
  double greatest_lift_ = 0.0;             // m, of a swing leg within its limits
  double moment_per_lift_ = 0.0;           // kg m/m, at most
  double shortest_ = 0.0, longest_ = 0.0;  // m, of a leg from the femur's axis to the foot, within q3's limits
};

}  // namespace foothold::hexpiderix
