// The paper's rule within a face against that of Zhu et al. on many random faces, since one face, as in the paper's figure 11,
// shows one case.
#pragma once

#include <memory>

#include "hyrecro/paper/paper.hpp"

namespace foothold::bench {

struct RuleTally {
  int faces = 0, fewer = 0, same = 0, more = 0;  // steps of the paper's rule against Zhu's
  int paper_stuck = 0, zhu_stuck = 0;
  double paper_steps = 0.0, zhu_steps = 0.0;  // in all, where neither got stuck
};

// Zigzags of three to five strips, 0.16 to 0.40 m wide, with a way of figure 11's length (2.631 m); the same for every call.
// `options` without the rule.
RuleTally compare_rules(const hyrecro::Model& model, std::shared_ptr<const hyrecro::PlanarWorkspace> workspace,
                        hyrecro::PaperOptions options, int faces);

}  // namespace foothold::bench
