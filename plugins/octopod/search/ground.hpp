// A terrain made ready for the octopod: nodes (centroids of the fine triangles), neighbours, and what was found out of each node
// and orientation, kept for later requests. Postures and verdicts are made when they are first asked for.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "contact/equilibrium.hpp"
#include "foothold/planner.hpp"
#include "octopod/posture/posture.hpp"
#include "terrain/surface.hpp"

namespace foothold::octopod {

// What postures and verdicts depend on beside the terrain.
struct GroundOptions {
  double resolution = 0.2;  // m, bound of the fine triangles' circumradius
  terrain::Split split = terrain::Split::kMidpoint;
  int neighbours = 10;  // nearest centroids, beside those across a triangle's edges
  double friction = 0.4;
  int cone_edges = 10;     // 0: the exact circular cone
  double clearance = 0.0;  // m, bodies and legs above the ground
  // Postures by the paper's Newton and centroid tree, verdicts by its Newton: slow, and kept only to be compared with.
  bool as_printed = false;
};

// A state of the search: 8 * node + orientation. 0 to 3 are the paper's four axes; half a turn more exchanges A and B.
using State = int;
inline int node_of(State state) { return state / kOrientations; }
inline int orientation_of(State state) { return state % kOrientations; }

// Used by one thread at a time.
class Ground final : public PreparedScene {
 public:
  // The surface's terrain is as the file gave it: feet stand on it. Its ground triangles are cut finer for the nodes.
  // Throws InvalidScene (too many fine triangles) and std::invalid_argument for options out of range.
  Ground(const Model& model, std::shared_ptr<const terrain::Surface> surface, const GroundOptions& options);
  ~Ground() override;

  const Model& model() const;
  const terrain::Surface& surface() const;
  const GroundOptions& options() const;

  int nodes() const;
  int states() const { return kOrientations * nodes(); }
  const Vector3d& place(int node) const;   // m, on the surface
  const Vector3d& normal(int node) const;  // faces up
  double slope(int node) const;            // rad
  int nearest_node(const Vector3d& point) const;
  std::span<const int> nearest(int node) const;  // the paper's ten nearest, nearest first
  // Where the robot may go next: those, the nodes that have this one among theirs, and the triangles across the edges. Sorted,
  // without doubles; a is adjacent to b whenever b is to a.
  std::span<const int> adjacent(int node) const;
  std::span<const double> lengths(int node) const;  // to those, straight, m: d of the paper

  // Kept once computed.
  const Built& standing(State state) const;
  bool stands(State state) const { return standing(state).hindrance == Hindrance::kNone; }
  bool stable(State state) const;               // false if there is no posture
  double critical_friction(State state) const;  // least at which it is stable; infinity if none
  // Whether the robot can go from one state to the next, once keep_passage() has said so.
  std::optional<bool> passage(State from, State to) const;
  void keep_passage(State from, State to, bool open) const;
  long postures_made() const;  // since the beginning
  // Forgets postures, verdicts and passages: for benches that measure a first look.
  void forget() const;

  std::vector<Shape> shapes() const override;

 private:
  struct Kept;
  std::unique_ptr<Kept> kept_;
};

}  // namespace foothold::octopod
