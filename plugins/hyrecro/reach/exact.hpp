// `exact`: deterministic reachability from the closed form of the inverse kinematics.
#pragma once

#include "hyrecro/reach/cell_search.hpp"
#include "hyrecro/reach/reach_filter.hpp"
#include "hyrecro/reach/reachability.hpp"

namespace foothold::hyrecro {

// Positives always carry coordinates: within limits, closing with the pose within kSingular, bodies `clearance` apart. A negative
// means that no cell of the search held a solution; against random search with 10,000 tries at most one positive in a thousand is
// missed (tests). Keeps its arrays between calls; used by one thread at a time.
class Exact final : public Reachability {
 public:
  Exact(const Model& model, double clearance, const CellSearchOptions& options = {});

  Reach reach(const Isometry3d& free_in_holding, const Admit& admit) override;
  // Solutions of a pose that lie apart from each other, roomy ones first, until `take` returns true or there are no more. Returns
  // whether one was taken.
  bool for_each_solution(const Isometry3d& free_in_holding, const Offer& take);

 private:
  const Model model_;
  const double clearance_;
  const std::shared_ptr<const ReachFilter> filter_;
  CellSearch cells_;
};

}  // namespace foothold::hyrecro
