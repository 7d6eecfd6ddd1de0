# What is installed, in two components: `foothold` for a host that plans or asks for plans, `dev` for who writes planners or clients.
# Programs look for what they load beside themselves (../lib/foothold), so that any prefix works. Included after all targets.
set(private_dir lib/foothold)
set(share_dir ${CMAKE_INSTALL_DATADIR}/foothold)
set(doc_dir ${CMAKE_INSTALL_DATADIR}/doc)
set(FOOTHOLD_CONFIG_DIR /etc/foothold CACHE PATH "Folder of the installed server's configuration")
set(FOOTHOLD_UNIT_DIR /lib/systemd/system CACHE PATH "Folder of systemd's units")

# --- component foothold
install(TARGETS footholdd RUNTIME DESTINATION ${CMAKE_INSTALL_SBINDIR})
install(TARGETS foothold-worker RUNTIME DESTINATION ${private_dir})
get_property(planners GLOBAL PROPERTY FOOTHOLD_PLANNERS)
install(TARGETS ${planners} LIBRARY DESTINATION ${private_dir}/plugins)
install(FILES config/footholdd.yaml DESTINATION ${FOOTHOLD_CONFIG_DIR})
install(DIRECTORY config/robots config/scenes DESTINATION ${FOOTHOLD_CONFIG_DIR} FILES_MATCHING PATTERN "*.yaml" PATTERN "*.urdf")
install(DIRECTORY config/dds config/requests DESTINATION ${share_dir})
# The requests name their scenes as ../scenes/*.
install(DIRECTORY config/scenes DESTINATION ${share_dir} FILES_MATCHING PATTERN "*.yaml")
install(FILES config/systemd/footholdd.service config/systemd/foothold.slice DESTINATION ${FOOTHOLD_UNIT_DIR})
install(FILES config/systemd/robot-network.conf config/systemd/dds-security.conf DESTINATION ${doc_dir}/foothold/examples)
install(FILES config/OPERATING.md DESTINATION ${doc_dir}/foothold)
install(FILES server/footholdd.8 DESTINATION ${CMAKE_INSTALL_MANDIR}/man8)
install(FILES idl/foothold.idl idl/PROTOCOL.md DESTINATION ${share_dir}/idl)

# What an administrator may change is kept in upgrades.
file(GLOB conffiles CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}/config config/footholdd.yaml config/robots/*.yaml
  config/robots/*.urdf config/scenes/*.yaml)
list(TRANSFORM conffiles PREPEND ${FOOTHOLD_CONFIG_DIR}/)
list(JOIN conffiles "\n" conffiles)
file(CONFIGURE OUTPUT debian/conffiles CONTENT "${conffiles}\n" @ONLY)

# --- component dev
include(cmake/dev.cmake)

# Debian wants these in every package; the changelog is compressed as its tools do.
set(changelog ${CMAKE_CURRENT_BINARY_DIR}/changelog.gz)
add_custom_command(OUTPUT ${changelog} COMMAND gzip -9nc ${PROJECT_SOURCE_DIR}/config/debian/changelog > ${changelog}
  DEPENDS config/debian/changelog VERBATIM)
add_custom_target(changelog DEPENDS ${changelog})
foreach(component foothold dev)
  set(package foothold)
  if(component STREQUAL dev)
    set(package foothold-dev)
  endif()
  install(FILES config/debian/copyright ${changelog} DESTINATION ${doc_dir}/${package} COMPONENT ${component})
endforeach()

set(installed_targets footholdd foothold-worker foothold foothold-terrain foothold-truss foothold_bus_cyclone foothold_bus_fastdds
  ${planners} ${exported})
add_custom_target(installed DEPENDS ${installed_targets} foothold_documents changelog)

# Debian's manual pages are compressed.
install(CODE [[
  file(GLOB pages "$ENV{DESTDIR}${CMAKE_INSTALL_PREFIX}/share/man/man?/foothold*.[18]")
  foreach(page ${pages})
    execute_process(COMMAND gzip -9nf ${page} COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
]])
