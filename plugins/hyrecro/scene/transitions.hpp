// Transition footholds: where a gripper may stand to reach another face (paper, section 2.3).
//
// Convex: between two faces that share an edge which both fall away from (two sides of a beam); the sole's centre stands `convex`
// (d_cnvx) from that edge. Concave: between faces whose planes meet such that parts of both are seen in front of each other; the
// centre stands `concave` (d_cncv) from the line in which the planes meet, wherever that line runs. The paper tells them by beams
// (same or different), which comes to the same for beams and fails for plates and meshes.
//
// The plate's true footprint lies on the face, all of it. Footholds head towards the edge (paper) and, where `both_headings` is
// set, away from it as well. Only footholds that have a partner on the other face are taken: two soles that both head across one
// line are apart by at most the distance between the hip axes along that line (the legs' planes are parallel, so nothing but the
// turned hip sets them apart).
//
// Samples lie every `step` along the line, centred, so that both ends of each free stretch have the same remainder; both ends are
// samples too.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "geometry/region.hpp"
#include "hyrecro/route/route.hpp"

namespace foothold::hyrecro {

struct SamplingOptions {
  double convex = 0.07;   // m, d_cnvx
  double concave = 0.25;  // m, d_cncv
  double step = 0.05;     // m, between samples along an edge
  bool both_headings = false;
  // m, further distances that are sampled besides (none in the paper). The least for a convex one is half the plate's length, where
  // the plate ends at the edge.
  std::vector<double> also_convex, also_concave;
};

struct TransitionFoothold {
  Foothold foothold;
  Isometry3d pose;   // of the sole, world
  int towards = -1;  // the face on the other side
  bool convex = true;
};

// All of a scene, with a k-d tree over their positions. Immutable after construction; any thread.
class Transitions {
 public:
  // Time: of the order of the pairs of faces nearer than 2 d_cncv, and of the footholds.
  Transitions(const Model& model, const truss::Truss& truss, const SamplingOptions& options);
  ~Transitions();
  Transitions(Transitions&&) noexcept;

  const std::vector<TransitionFoothold>& all() const { return all_; }
  const std::vector<int>& of_face(int face) const { return by_face_[static_cast<std::size_t>(face)]; }
  // Indices into all() within `radius` (m) of `point`, on other faces than `face`, nearest first.
  std::vector<int> near(const Vector3d& point, double radius, int face) const;

 private:
  struct Tree;
  std::vector<TransitionFoothold> all_;
  std::vector<std::vector<int>> by_face_;
  std::unique_ptr<Tree> tree_;  // built by the first near()
};

// The part of a face in which a sole's centre keeps `inset` (m) from every edge: the paper's "safe" polygon (its Figure 2c), by
// polygon offsetting with mitred corners. May have several parts.
using geometry::Region;
std::vector<Region> shrunk(const truss::Face& face, double inset);
// The whole plate lies on the face (edges included, 1e-9 m).
bool plate_on_face(const Model& model, const truss::Face& face, const Foothold& foothold);
// The face on which a pose's sole stands, if it does within `tolerance` (m for the distance to the plane, rad for the normal), and
// the foothold; the sole's centre lies on the face, the plate may overhang. Of several faces (flush beams) the one on which the
// centre is farthest from the edges. Empty if there is none.
std::optional<Foothold> foothold_at(const truss::Truss& truss, const Isometry3d& pose, double tolerance);

}  // namespace foothold::hyrecro
