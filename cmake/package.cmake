# The Debian packages, by `cmake --build --preset release --target deb`: build/release/packages/*.deb.
set(CPACK_GENERATOR DEB)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_PACKAGE_NAME foothold)
set(CPACK_PACKAGE_VENDOR foothold)
set(CPACK_PACKAGE_CONTACT "foothold maintainers <foothold@packages.debian.org>")
set(CPACK_PACKAGE_DIRECTORY ${CMAKE_BINARY_DIR}/packages)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL foothold dev)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(debian ${PROJECT_SOURCE_DIR}/config/debian)
set(CPACK_DEBIAN_FOOTHOLD_PACKAGE_NAME foothold)
set(CPACK_DEBIAN_FOOTHOLD_PACKAGE_SECTION science)
set(CPACK_DEBIAN_FOOTHOLD_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_FOOTHOLD_PACKAGE_CONTROL_EXTRA
  ${CMAKE_BINARY_DIR}/debian/conffiles ${debian}/triggers ${debian}/postinst ${debian}/prerm ${debian}/postrm)
set(CPACK_COMPONENT_FOOTHOLD_DESCRIPTION
"planning server for walking and climbing robots
footholdd takes plan requests over DDS (Cyclone DDS or Fast DDS), lets each
robot's planner work in a supervised process of its own, and sends the
footholds as they are found. Each step was checked apart from the search
that made it, and every request ends in exactly one final state.
.
This package holds the server with its systemd unit, the planners, and the
command foothold, which asks for plans, draws them and finds faults.")

set(CPACK_DEBIAN_DEV_PACKAGE_NAME foothold-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS
  "foothold (= ${PROJECT_VERSION}), libeigen3-dev, libfastcdr-dev, libssl-dev, libyaml-cpp-dev")
set(CPACK_COMPONENT_DEV_DESCRIPTION
"headers and libraries for planners and clients of foothold
What find_package(foothold) offers in CMake: foothold::api for planners of
robots of one's own, foothold::client for programs that ask footholdd for
plans, and the IDL for clients in other languages.
.
A planner to copy is in /usr/share/doc/foothold-dev/examples/template.")

include(CPack)

# Made anew when something that is installed has changed.
execute_process(COMMAND dpkg --print-architecture OUTPUT_VARIABLE architecture OUTPUT_STRIP_TRAILING_WHITESPACE)
set(deb ${CPACK_PACKAGE_DIRECTORY}/foothold_${PROJECT_VERSION}_${architecture}.deb)
file(GLOB_RECURSE files CONFIGURE_DEPENDS cmake/* config/* idl/*.idl idl/*.md plugins/template/* plugins/toolkit/*.1 clients/cpp/examples/* server/*.8)
add_custom_command(OUTPUT ${deb} COMMAND ${CMAKE_CPACK_COMMAND} -G DEB > packages.log
  DEPENDS ${installed_targets} ${files} WORKING_DIRECTORY ${CMAKE_BINARY_DIR} VERBATIM USES_TERMINAL)
add_custom_target(deb DEPENDS ${deb})
add_dependencies(deb installed)
