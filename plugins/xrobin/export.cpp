// The one symbol of the plugin.
#include <iterator>

#include "foothold/export.hpp"
#include "planner.hpp"
#include "schema.hpp"

FOOTHOLD_EXPORT_PLANNER(foothold::xrobin::XrobinPlanner,
                        (foothold::PlannerInfo{
                            .name = "xrobin",
                            .version = "0.1.0",
                            .description = "Xrobin: binary mobile parallel robot, proved best words of cycles",
                            .joints = "piston_l|piston_r",
                            .limbs = "A|B",
                            .start_needs = "base or contacts of A and B (default: the origin); joints are compared",
                            .goal_needs = "base: where body A shall be; its heading counts unless any_orientation",
                            .prepare_parameters = "method|cycles|grid_cells|clearance",
                            .parameters = foothold::xrobin::kParameters,
                            .parameter_count = std::size(foothold::xrobin::kParameters)}))
