// `method: paper`: the hierarchical planner of the paper, ported faithfully. PPT (A* over transition footholds), then on each face
// PPIC (continuous way) and PPID (footholds along it).
#pragma once

#include "hyrecro/reach/reachability.hpp"
#include "hyrecro/scene/prepared.hpp"

namespace foothold::hyrecro {

enum class FaceRule {
  kPaper,
  kZhu
};  // PPID: algorithms 1 and 2, or Zhu et al. 2020: the reachable point nearest the way's crossing
enum class FaceWay { kVisibility, kGrid };  // PPIC: visibility graph, or the A* of Zhu et al. on a 0.1 m grid

struct PaperOptions {
  FaceRule rule = FaceRule::kPaper;
  FaceWay way = FaceWay::kVisibility;
  double safe_inset = 0.07;   // m, of the "safe" polygon
  double least_dot = 0.998;   // eps of algorithm 2: u_cand . u_best must be at least this
  double r_max = 0.0;         // m, of algorithm 1; 0: the workspace's
  double reach_radius = 0.0;  // m, of the k-d tree query; 0: from the model
  // m: in every stance each leg alone must have room to lift its foot so far, as motions do; 0 (the paper): need not. The scene's
  // workspace must be made with the same demand.
  double lift = 0.0;
  // Answers of `exact` are kept with the scene for later requests. The paper has no such thing: for comparisons of what is found,
  // not of time.
  bool keeps = false;
};

// Milliseconds that each part took, for the bench's tables 1 and 2.
struct PaperTimes {
  double ppt = 0.0;
  std::vector<double> ppi;  // one for each face of the route, in its order; 0 where there is nothing to walk
};

// Used by one thread at a time. The scene must have been sampled with both_headings = false to be the paper's.
Found plan_paper(const Model& model, const PreparedTruss& scene, Reachability& reachability, const Foothold& start,
                 const Foothold& goal, const PaperOptions& options, const std::stop_token& stop, const OnStride& on_stride,
                 PaperTimes* times = nullptr);

// Footholds from `from` (excluded) to `to` (included) on one face: PPIC and PPID alone. Empty if PPID gets stuck.
std::optional<std::vector<Stride>> plan_face(const Model& model, const PreparedTruss& scene, const Foothold& from,
                                             const Foothold& to, const PaperOptions& options, const std::stop_token& stop);

}  // namespace foothold::hyrecro
