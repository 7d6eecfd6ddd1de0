// The one symbol of the plugin.
#include <iterator>

#include "bioloid/planner.hpp"
#include "bioloid/schema.hpp"
#include "foothold/export.hpp"

FOOTHOLD_EXPORT_PLANNER(
    foothold::bioloid::BioloidPlanner,
    (foothold::PlannerInfo{
        .name = "bioloid",
        .version = "0.1.0",
        .description = "Bioloid: a humanoid of 18 servos walks on level ground among obstacles, every instant balanced and free",
        .joints = foothold::bioloid::kJointNames,
        .limbs = foothold::bioloid::kLimbs,
        .start_needs = "base: a point of the level ground between the feet, and the heading; or contacts: both soles; with joints, "
                       "base is the torso's pose",
        .goal_needs =
            "base: a point of the ground to walk to, with a heading or any_orientation; or contacts: both soles side by side",
        .prepare_parameters = "",
        .parameters = foothold::bioloid::kParameters,
        .parameter_count = std::size(foothold::bioloid::kParameters)}))
