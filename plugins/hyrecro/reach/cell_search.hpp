// Search of the free variables of a pose's inverse kinematics, cell by cell: what `exact` does where there is no closed form.
//
// A grid over the free variables (singular: both angles of the free leg and the place of its length between its limits; regular:
// one angle and that place), for each branch. At each cell's centre the posture's margin to the limits is known in closed form, and
// as it changes with bounded slope, a cell whose centre is too far out of limits holds no solution and is dropped. The others are
// offered if their centre is within limits, roomiest first, and halved. Singular poses, whose solutions often fill a small part of
// a cell, first get a climb by the margin from the best cells of the coarsest grid.
#pragma once

#include <functional>
#include <vector>

#include "hyrecro/model/bodies.hpp"
#include "hyrecro/reach/leg_limits.hpp"

namespace foothold::hyrecro {

// Takes a posture (true ends the search) that is within limits and free of itself.
using Offer = std::function<bool(const Coordinates&)>;

struct CellSearchOptions {
  std::size_t most_postures = 6'000;  // looked at for one pose, free of themselves or not
  std::size_t most_offers = 2'000;    // of one pose
  std::size_t most_cells = 6'144;     // of one level; the roomiest are kept
};

// Keeps its arrays between calls; used by one thread at a time.
class CellSearch {
 public:
  CellSearch(const Model& model, double clearance, const CellSearchOptions& options = {});
  // True if an offer was taken.
  bool search(const Isometry3d& free_in_holding, const Offer& offer);

 private:
  struct Tick {  // an angle of a mechanism
    double angle = 0.0, cosine = 1.0, sine = 0.0;
    LegLimits::Stroke stroke{};
  };
  struct Turn {  // a branch's or a posture's psi0 and psi1
    double cos0 = 1.0, sin0 = 0.0, cos1 = 1.0, sin1 = 0.0;
  };
  struct Cell {
    short i = 0, j = 0, k = 0;  // of phi1, phi2 (singular poses), lambda
    signed char s1 = 1, s2 = 1;
    double margin = 0.0;  // m
  };
  struct Posture {
    double margin = 0.0, beyond = 0.0;
    double lambda = 0.0, uz = 0.0, wx = 0.0, wy = 0.0;
    Turn turn;
  };
  struct Grid {
    int angles = 0, lengths = 0;
    double radius = 0.0;  // m: as far the margin in a cell may differ from that of its centre, the hips' swing aside
    double shift = 0.0;   // m: as far the free leg's hip may be from that of its centre
    double legs = 0.0;    // m: as far the legs' distance may differ from that of its centre, the hips' swing aside
  };

  void set_up(const Isometry3d& pose);
  void set_ticks(std::size_t level);
  Posture at(const Cell& cell) const;
  bool spent() const { return postures_ >= options_.most_postures || offers_ >= options_.most_offers; }
  // m: as far the hips' distance across the plane of the leg that holds may differ in a cell.
  double side_change(const Grid& grid) const { return singular_ ? 0.0 : std::hypot(pose_.r(2, 0), pose_.r(2, 1)) * grid.shift; }
  double swing(const Posture& posture, const Grid& grid) const;
  bool may_hold(const Cell& cell, const Posture& posture, const Grid& grid, bool judge_legs) const;
  void add(Cell cell, const Grid& grid, bool judge_legs);
  void refine(const Grid& grid);
  bool climb(const Offer& offer);
  bool take(const Cell& cell, const Posture& posture, const Offer& offer);
  std::array<collision::Capsule, 2> legs(const Cell& cell, const Posture& posture) const;
  bool free_of_itself(const Cell& cell, const Posture& posture);
  Coordinates coordinates(const Cell& cell, const Posture& posture) const;
  bool offer_all(const Offer& offer);
  Tick tick(double angle) const;

  const Model model_;
  const LegLimits limits_;
  const double clearance_;
  const CellSearchOptions options_;
  std::vector<Grid> singular_grids_, regular_grids_;
  std::vector<std::vector<Tick>> singular_ticks_;

  PaperPose pose_{Isometry3d::Identity()};
  bool singular_ = false;
  std::array<Turn, 2> regular_turn_;  // for s1 = 1 and -1
  std::array<std::vector<Tick>, 2> regular_first_, regular_second_;
  // Of the level at hand, by s1: where phi1 and phi2 are in its cells' centres.
  std::array<const Tick*, 2> first_{}, second_{};
  int lengths_ = 1;
  std::size_t postures_ = 0, offers_ = 0;
  Bodies bodies_;  // in the paper's frame of the sole that holds; plates set once for a pose
  std::vector<Cell> cells_, halved_, inside_;
};

}  // namespace foothold::hyrecro
