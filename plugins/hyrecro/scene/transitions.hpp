// Transition footholds: where a gripper may stand to reach another face (paper, section 2.3).
//
// Convex: between two faces of one solid that share an edge; the sole's centre stands `convex` (d_cnvx) from that edge. Concave:
// between faces of different solids whose planes meet in front of both; the centre stands `concave` (d_cncv) from the line in which
// the planes meet, inside the face. Footholds head towards the edge (paper) and, where `both_headings` is set, away from it as
// well.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "hyrecro/route/route.hpp"

namespace foothold::hyrecro {

struct SamplingOptions {
  double convex = 0.07;   // m, d_cnvx
  double concave = 0.25;  // m, d_cncv
  double step = 0.05;     // m, between samples along an edge
  bool both_headings = false;
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
  // Samples inside the face by the true footprint of the plate; convex ones by polygon offsetting (polyclipping) of the outline.
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
  std::unique_ptr<const Tree> tree_;
};

// The part of a face in which a sole's centre keeps `inset` (m) from every edge: the paper's "safe" polygon. May have several
// parts.
struct Region {
  Polygon outline;             // counter-clockwise
  std::vector<Polygon> holes;  // clockwise
};
std::vector<Region> shrunk(const truss::Face& face, double inset);
// The whole plate lies on the face (edges included, 1e-9 m).
bool plate_on_face(const Model& model, const truss::Face& face, const Foothold& foothold);
// The face on which a pose's sole stands, if it does within `tolerance` (m for the distance to the plane, rad for the normal), and
// the foothold; the plate may overhang. Empty if there is none.
std::optional<Foothold> foothold_at(const truss::Truss& truss, const Isometry3d& pose, double tolerance);

}  // namespace foothold::hyrecro
