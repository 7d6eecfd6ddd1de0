// The one symbol of the plugin.
#include <iterator>

#include "foothold/export.hpp"
#include "hexpiderix/planner.hpp"
#include "hexpiderix/schema.hpp"

FOOTHOLD_EXPORT_PLANNER(
    foothold::hexpiderix::HexpiderixPlanner,
    (foothold::PlannerInfo{
        .name = "hexpiderix",
        .version = "0.1.0",
        .description = "Hex-piderix: radial hexapod, postures of proved greatest stability on slopes, walks over any ground",
        .joints = foothold::hexpiderix::kJointNames,
        .limbs = foothold::hexpiderix::kLimbs,
        .start_needs =
            "base: a point of the ground and the heading; or, with joints, the thorax' pose; contacts name the supporting legs",
        .goal_needs = "nothing: the robot adapts where it stands; or base: a point of the ground to walk to, with a heading or "
                      "any_orientation",
        .prepare_parameters = "",
        .parameters = foothold::hexpiderix::kParameters,
        .parameter_count = std::size(foothold::hexpiderix::kParameters)}))
