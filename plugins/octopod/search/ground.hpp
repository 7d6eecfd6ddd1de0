// A terrain made ready for the octopod: nodes (centroids of the fine triangles), neighbours, and what was found out of each node
// and orientation, kept for later requests. Postures and verdicts are made when they are first asked for.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "contact/equilibrium.hpp"
#include "foothold/planner.hpp"
#include "octopod/posture/posture.hpp"

namespace foothold::octopod {

// What postures and verdicts depend on beside the terrain.
struct GroundOptions {
  double resolution = 0.2;  // m, bound of the fine triangles' circumradius
  int neighbours = 10;      // nearest centroids, beside those across a triangle's edges
  double friction = 0.4;
  int cone_edges = 10;     // 0: the exact circular cone
  double clearance = 0.0;  // m, bodies and legs above the ground
};

// A state of the search: 8 * node + orientation. 0 to 3 are the paper's four axes; half a turn more exchanges A and B.
using State = int;
inline int node_of(State state) { return state / kOrientations; }
inline int orientation_of(State state) { return state % kOrientations; }

// Used by one thread at a time.
class Ground final : public PreparedScene {
 public:
  // Throws InvalidScene.
  Ground(const Model& model, std::shared_ptr<const terrain::Surface> surface, const GroundOptions& options);
  ~Ground() override;

  const Model& model() const;
  const terrain::Surface& surface() const;
  const GroundOptions& options() const;

  int nodes() const;
  Vector3d place(int node) const;   // m, on the surface
  Vector3d normal(int node) const;  // faces up
  int nearest_node(const Vector3d& point) const;
  std::span<const int> nearest(int node) const;   // the paper's ten nearest
  std::span<const int> adjacent(int node) const;  // those and the triangles across the edges, sorted, without doubles

  // Kept once computed.
  const Built& standing(State state) const;
  bool stable(State state) const;               // false if there is no posture
  double critical_friction(State state) const;  // least at which it is stable; infinity if none
  // Forgets postures and verdicts: for benches that measure a first look.
  void forget() const;

  std::vector<Shape> shapes() const override;

 private:
  struct Kept;
  std::unique_ptr<Kept> kept_;
};

}  // namespace foothold::octopod
