// Planar workspace: the poses of the free foot in the plane of the foot that holds, on a grid (paper, section 3.2.2, Figures 8 and
// 9).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "hyrecro/reach/planar_postures.hpp"
#include "hyrecro/reach/reachability.hpp"

namespace foothold::hyrecro {

// Immutable after construction; any thread. Grid points are multiples of `position_step`, headings of `heading_step` (which divides
// 2 pi).
class PlanarWorkspace {
 public:
  // Computes it: every grid pose by exact reachability (self-collisions with `clearance` included, scene not): level postures in
  // closed form, and where there is none and both legs may lean (headings equal or opposite) by Exact. Only poses that no symmetry
  // of the robot takes to each other are computed. With `admit` only poses count whose conservative solution it takes; it must not
  // tell apart what a symmetry of the robot takes to each other. Empty if stopped.
  static std::optional<PlanarWorkspace> make(const Model& model, double position_step, double heading_step, double clearance,
                                             const std::stop_token& stop = {}, const Admit& admit = {});

  double position_step() const { return position_step_; }
  double heading_step() const { return heading_step_; }
  int headings() const { return headings_; }
  int extent() const { return extent_; }  // grid indices run from -extent to +extent
  // i, j in [-extent, extent], k in [0, headings).
  bool reachable(int i, int j, int k) const;
  // The conservative solution of a reachable pose: the one whose bodies fill the largest bounding box in the frame of the sole that
  // holds (paper: "maximizes the volume"), of the level postures where there are any. Computed from one stored number.
  Coordinates conservative(int i, int j, int k) const;
  // r_max: longest reach along X, m. r_opt: of the circle through the places where most headings are reachable (paper, Figure 9),
  // m; as these are a band, its mean radius, which hardly depends on the steps. The band's inner edge is where the plates meet.
  double r_max() const { return r_max_; }
  double r_opt() const { return r_opt_; }
  // Grid positions with at least one heading.
  struct Cell {
    int i = 0, j = 0;
    int count = 0;  // reachable headings
  };
  const std::vector<Cell>& cells() const { return cells_; }

 private:
  PlanarWorkspace() = default;
  struct Table;
  struct Canonical {
    std::size_t entry;
    bool holding_turned, mirrored, free_turned;
  };
  std::size_t index(int i, int j, int k) const;
  Canonical canonical(int i, int j, int k) const;
  PlanarPose pose(int i, int j, int k) const;
  void measure();

  double position_step_ = 0.0, heading_step_ = 0.0;
  int headings_ = 0, extent_ = 0;
  double r_max_ = 0.0, r_opt_ = 0.0;
  std::vector<Cell> cells_;
  std::shared_ptr<const Table> table_;
};

}  // namespace foothold::hyrecro
