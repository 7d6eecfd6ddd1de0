// The one symbol of the plugin.
#include <iterator>

#include "foothold/export.hpp"
#include "hyrecro/planner.hpp"
#include "hyrecro/schema.hpp"

FOOTHOLD_EXPORT_PLANNER(foothold::hyrecro::HyrecroPlanner,
                        (foothold::PlannerInfo{
                            .name = "hyrecro",
                            .version = "0.1.0",
                            .description = "HyReCRo: biped that climbs trusses, proved least numbers of steps",
                            .joints = foothold::hyrecro::kJointNames,
                            .limbs = "A|B",
                            .start_needs = "contacts: where one foot holds, or both; joints may be given with them",
                            .goal_needs = "contacts: one foothold, for either foot",
                            .prepare_parameters = "method|clearance|d_cncv|d_cnvx|transition_step",
                            .parameters = foothold::hyrecro::kParameters,
                            .parameter_count = std::size(foothold::hyrecro::kParameters)}))
