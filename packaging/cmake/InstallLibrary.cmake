# The simulation library for other programs: find_package(Feedscope) gives Feedscope::core and the folder FEEDSCOPE_DATA
# with the shipped machines. A component of its own, which a plain installation leaves out:
# cmake --install build/program --component development, and --component machines where Feedscope itself is not installed
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/Feedscope)
set_target_properties(feedscope_core PROPERTIES EXPORT_NAME core)
install(TARGETS feedscope_core EXPORT FeedscopeTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development EXCLUDE_FROM_ALL)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/core DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/feedscope
  COMPONENT development EXCLUDE_FROM_ALL FILES_MATCHING PATTERN "*.h"
  PATTERN json_parts.h EXCLUDE)  # needs a library that no other header does
install(DIRECTORY ${PROJECT_SOURCE_DIR}/machines DESTINATION ${CMAKE_INSTALL_DATADIR}/feedscope
  COMPONENT machines EXCLUDE_FROM_ALL)
install(EXPORT FeedscopeTargets NAMESPACE Feedscope:: DESTINATION ${package}
  COMPONENT development EXCLUDE_FROM_ALL)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/FeedscopeConfig.cmake.in ${PROJECT_BINARY_DIR}/FeedscopeConfig.cmake
  INSTALL_DESTINATION ${package} PATH_VARS CMAKE_INSTALL_DATADIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/FeedscopeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/FeedscopeConfig.cmake ${PROJECT_BINARY_DIR}/FeedscopeConfigVersion.cmake
  DESTINATION ${package} COMPONENT development EXCLUDE_FROM_ALL)
