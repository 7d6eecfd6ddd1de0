// Which foot can leave its face first, before any search asks where it may go.
#pragma once

#include <stop_token>
#include <string>
#include <vector>

#include "hyrecro/motion/motion.hpp"
#include "hyrecro/planner.hpp"

namespace foothold::hyrecro {

// Those of `from` whose other foot hangs in the air or can be lifted as every motion from there begins: along its normal, by its
// leg alone or by the whole robot. Where none is left, `reason` says why the last one is not. Used by one thread at a time.
std::vector<Beginning> departures(const Model& model, const PreparedTruss& scene, const std::vector<Beginning>& from,
                                  const MotionOptions& options, const std::stop_token& stop, std::string& reason);

// A posture on both contacts, free of collisions: one from which each leg alone lifts its foot by `lift` (m; 0: need not), else one
// from which either does, else one from which the whole robot does, else any. Empty if there is none at all. `free_in_holding`:
// pose of the sole of the other foot seen from the one at `sole`. Thread rule of Reachability.
std::optional<Coordinates> standing_on_both(const Model& model, const PreparedTruss& scene, Reachability& exact,
                                            const Isometry3d& sole, const Isometry3d& free_in_holding, const MotionOptions& options,
                                            double lift);

}  // namespace foothold::hyrecro
