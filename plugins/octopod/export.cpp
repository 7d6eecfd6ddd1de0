// The one symbol of the plugin.
#include <iterator>

#include "foothold/export.hpp"
#include "octopod/planner.hpp"
#include "octopod/schema.hpp"

FOOTHOLD_EXPORT_PLANNER(
    foothold::octopod::OctopodPlanner,
    (foothold::PlannerInfo{
        .name = "octopod",
        .version = "0.1.0",
        .description = "Octopod: two quadruped modules on rough terrain, stable routes of proved least cost",
        .joints = foothold::octopod::kJointNames,
        .limbs = foothold::octopod::kLimbs,
        .start_needs = "base: a point of the terrain under the robot's middle, X where it looks to; or any_orientation",
        .goal_needs = "base: a point of the terrain; any_orientation",
        .prepare_parameters = "resolution|split|neighbours|friction|cone_edges|clearance|swing_height",
        .parameters = foothold::octopod::kParameters,
        .parameter_count = std::size(foothold::octopod::kParameters)}))
