# The Debian packages: feedscope, python3-feedscope (numpy) and libfeedscope-dev, by packaging/package.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME feedscope)
set(CPACK_PACKAGE_CONTACT "Feedscope developers <feedscope@feedscope.example>")
set(CPACK_PACKAGE_HOMEPAGE_URL ${FEEDSCOPE_HOMEPAGE})
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_COMPONENTS_ALL application development)
if(FEEDSCOPE_PYTHON)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE ${FEEDSCOPE_DEBIAN_RELEASE})
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

set(CPACK_DEBIAN_APPLICATION_PACKAGE_NAME feedscope)
set(CPACK_DEBIAN_APPLICATION_PACKAGE_DEPENDS "libosmesa6 | libegl-mesa0, qt6-qpa-plugins, libqt6svg6")
set(CPACK_DEBIAN_APPLICATION_PACKAGE_RECOMMENDS "libgl1-mesa-dri, qt6-wayland, qt6-translations-l10n")
set(CPACK_COMPONENT_APPLICATION_DESCRIPTION
  "show what a CNC control does with an NC program
Feedscope shows the path with the corner blends that a control inserts, the
feed, acceleration and jerk of every axis, and what limits the feed where an
NC program is slow. It simulates published models of real controls on
published machines, in a window and on the command line, and writes tables,
pictures and reports.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-feedscope)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "feedscope (= ${PROJECT_VERSION}-${FEEDSCOPE_DEBIAN_RELEASE}), python3, python3-numpy")
set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
  ${PROJECT_SOURCE_DIR}/packaging/debian/python/postinst ${PROJECT_SOURCE_DIR}/packaging/debian/python/prerm)
set(CPACK_COMPONENT_PYTHON_DESCRIPTION
  "simulate NC programs from Python
The simulation library of Feedscope as a Python module: programs are read and
simulated on published control models and machines; the motion comes as numpy
arrays.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libfeedscope-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "feedscope (= ${PROJECT_VERSION}-${FEEDSCOPE_DEBIAN_RELEASE}), libeigen3-dev, libfmt-dev, libtbb-dev, libtomlplusplus-dev, libcmark-dev, libexpat1-dev, zlib1g-dev, libnlopt-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
  "simulate NC programs from C++
The simulation library of Feedscope with headers and a CMake package, to be
found by find_package(Feedscope).")

# Changelog and copyright, where Debian has them.
foreach(component application python development)
  string(TOUPPER ${component} upper)
  set(doc ${CMAKE_INSTALL_DATADIR}/doc/${CPACK_DEBIAN_${upper}_PACKAGE_NAME})
  set(optional)
  if(NOT component STREQUAL application)
    set(optional EXCLUDE_FROM_ALL)
  endif()
  install(FILES ${PROJECT_SOURCE_DIR}/packaging/debian/copyright DESTINATION ${doc} COMPONENT ${component} ${optional})
  install(FILES ${PROJECT_BINARY_DIR}/changelog.Debian.gz DESTINATION ${doc} COMPONENT ${component} ${optional})
endforeach()
configure_file(${PROJECT_SOURCE_DIR}/packaging/debian/changelog.in ${PROJECT_BINARY_DIR}/changelog.Debian @ONLY)
execute_process(COMMAND gzip -9nc ${PROJECT_BINARY_DIR}/changelog.Debian OUTPUT_FILE ${PROJECT_BINARY_DIR}/changelog.Debian.gz
  COMMAND_ERROR_IS_FATAL ANY)
include(CPack)
