# foothold_add_planner(name SOURCES ... [LIBRARIES ...]): a planner's shared library, plugins/<name>.so of this build; target
# planner_<name>, all of them: planners. In a project that has it from find_package(foothold), it is also installed where a server
# of the package looks for planners.
add_custom_target(planners)
function(foothold_add_planner name)
  cmake_parse_arguments(PLANNER "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_library(planner_${name} MODULE ${PLANNER_SOURCES})
  target_link_libraries(planner_${name} PRIVATE foothold::api ${PLANNER_LIBRARIES})
  set_target_properties(planner_${name} PROPERTIES
    PREFIX "" OUTPUT_NAME ${name} LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/plugins
    CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  add_dependencies(planners planner_${name})
  if(COMMAND foothold_ours)
    foothold_ours(planner_${name})
    set_property(GLOBAL APPEND PROPERTY FOOTHOLD_PLANNERS planner_${name})
  else()
    # -ffp-contract=off: the same plan on every machine.
    target_compile_options(planner_${name} PRIVATE -Wall -Wextra -ffp-contract=off)
    set_target_properties(planner_${name} PROPERTIES CXX_EXTENSIONS OFF)
    install(TARGETS planner_${name} LIBRARY DESTINATION lib/foothold/plugins)
  endif()
endfunction()
