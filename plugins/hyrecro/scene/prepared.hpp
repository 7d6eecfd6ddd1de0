// What HyReCRo keeps of a scene: its faces, its solids, its transition footholds, and what later requests find out about them.
#pragma once

#include <memory>

#include "foothold/planner.hpp"
#include "hyrecro/reach/planar_workspace.hpp"
#include "hyrecro/scene/portals.hpp"

namespace foothold::hyrecro {

// Immutable but for what is mutable; used by one thread at a time.
struct PreparedTruss final : PreparedScene {
  PreparedTruss(const Model& model, truss::Truss truss, const SamplingOptions& options, double clearance);
  std::vector<Shape> shapes() const override;  // beams as boxes, faces given by themselves and faces of meshes as polygons

  truss::Truss truss;
  Obstacles obstacles;
  Transitions transitions;
  std::optional<Portals> portals;  // of large scenes
  double clearance;                // m
  // Set by the planner before plan_paper(), which alone reads it; shared between scenes.
  mutable std::shared_ptr<const PlanarWorkspace> workspace;
  // What a search wants to find again in later requests of the same scene (`optimal`: transitions judged, faces' strides). Owned by
  // the search.
  struct Kept {
    virtual ~Kept() = default;
  };
  mutable std::unique_ptr<Kept> kept;
  mutable std::unique_ptr<Kept> kept_by_paper;  // the same for `method: paper`
};

}  // namespace foothold::hyrecro
