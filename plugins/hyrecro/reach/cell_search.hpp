// Search of the free variables of a pose's inverse kinematics, cell by cell: what `exact` does where there is no closed form.
//
// A grid over the free variables (singular: both angles of the free leg and the place of its length between its limits; regular:
// one angle and that place), for each branch. At each cell's centre the posture's margin to the limits is known in closed form, and
// as it changes with bounded slope, a cell whose centre is too far out of limits holds no solution and is dropped. The others are
// offered if their centre is within limits, roomiest first, and halved.
#pragma once

#include <functional>
#include <vector>

#include "hyrecro/reach/leg_limits.hpp"

namespace foothold::hyrecro {

// Takes a posture (true ends the search) that is within limits; collisions are its own business.
using Offer = std::function<bool(const Coordinates&)>;

struct CellSearchOptions {
  std::size_t most_offers = 20'000;  // of one pose
  std::size_t most_cells = 16'384;   // of one level; the roomiest are kept
};

// Keeps its arrays between calls; used by one thread at a time.
class CellSearch {
 public:
  CellSearch(const Model& model, double clearance, const CellSearchOptions& options = {});
  // True if an offer was taken. Offers only postures whose legs' capsules are `clearance` apart; the rest is for `offer` to judge.
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
    double radius = 0.0;  // m: as far the margin in a cell may differ from that of its centre, hips aside
    double shift = 0.0;   // m: as far the free leg's hip may be from that of its centre
  };

  void set_up(const Isometry3d& pose);
  void set_ticks(std::size_t level);
  Posture at(const Cell& cell) const;
  bool may_hold(const Posture& posture, const Grid& grid) const;
  void add(Cell cell, const Grid& grid);
  void refine(const Grid& grid);
  bool legs_apart(const Cell& cell, const Posture& posture) const;
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
  std::array<std::vector<Tick>, 2> first_, second_;
  int lengths_ = 1;
  std::size_t offers_ = 0;
  std::vector<Cell> cells_, halved_, inside_;
};

}  // namespace foothold::hyrecro
