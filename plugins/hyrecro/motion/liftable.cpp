#include "hyrecro/motion/liftable.hpp"

namespace foothold::hyrecro {

bool free_foot_liftable(Reachability& exact, const Isometry3d& free_in_holding, double height) {
  return exact.reach(free_in_holding * Eigen::Translation3d(0.0, 0.0, height), {}).reachable;
}

bool holding_foot_liftable(Reachability& exact, const Isometry3d& free_in_holding, double height) {
  return free_foot_liftable(exact, free_in_holding.inverse(Eigen::Isometry), height);
}

}  // namespace foothold::hyrecro
