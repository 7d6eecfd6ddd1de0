// PPI on one face (section 3.2): the continuous way, then footholds along it by algorithm 1 with algorithm 2 or the rule of Zhu et
// al.
//
// Where algorithm 1 as printed does not say, or does not end, it does what the text describes:
// - Each round first asks whether the other foot reaches the destination itself (text on Figure 10's last face).
// - Where d - r_opt is less than any reach that the workspace has (the destination is too near, or lies right but is turned wrong),
//   an additional foothold is put as near as can be to the circle of r_opt round the destination, such that the destination can be
//   reached from it (same text).
// - Where no circle crosses the way ahead, its end is the crossing.
// - A face that takes more rounds than its way has half optimal reaches ends the walk.
#pragma once

#include "hyrecro/paper/joint_solutions.hpp"
#include "hyrecro/paper/way.hpp"
#include "hyrecro/paper/workspace_order.hpp"

namespace foothold::hyrecro {

struct FaceWalk {
  enum class Outcome { kReached, kStuck, kStopped };
  Outcome outcome = Outcome::kStuck;
  std::vector<Stride> strides;
  std::vector<Vector2d> way;  // the continuous one; empty if one stride suffices
  std::string stuck;          // where and why, a sentence without its end
};

// What a walk needs; borrowed.
struct Walker {
  const Model& model;
  const PreparedTruss& scene;
  const WorkspaceOrder& order;
  JointSolutions& solutions;
  const PaperOptions& options;
};

// Footholds from `from` (excluded) to `to` (included), both on the face whose safe polygon is `ground`. One thread at a time.
FaceWalk walk_face(const Walker& walker, const SafeGround& ground, const Foothold& from, const Foothold& to,
                   const std::stop_token& stop);

// Algorithm 2: the foothold for the free foot while the other holds at `current`, `reach` metres along the way (or by Zhu's rule).
// Empty if no candidate passes.
std::optional<Stride> next_best_foothold(const Walker& walker, const SafeGround& ground, const std::vector<Vector2d>& way,
                                         const Foothold& current, double reach);

}  // namespace foothold::hyrecro
