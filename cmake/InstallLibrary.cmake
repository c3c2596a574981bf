# The certified predicate, which needs nothing of the command: the component `library`, and the Debian packages. Its package
# file finds the rest relative to itself: the folder can be moved.
include(CMakePackageConfigHelpers)
set(package_folder lib/cmake/axiscert)
set(AXISCERT_FINDS_HIGHWAY "")
if(NOT BUILD_SHARED_LIBS)  # a static library leaves it to who links it
  set(AXISCERT_FINDS_HIGHWAY "include(CMakeFindDependencyMacro)\nfind_dependency(hwy CONFIG)\n")
endif()
configure_package_config_file(cmake/axiscertConfig.cmake.in ${PROJECT_BINARY_DIR}/axiscertConfig.cmake
                              INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/axiscertConfigVersion.cmake COMPATIBILITY SameMinorVersion)

# axiscert_install_library(component lib runtime options...): the library and what building against it takes, under `lib`;
# what its programs need at run time as the component `runtime`.
function(axiscert_install_library component lib runtime)
  set(with COMPONENT ${component} ${ARGN})
  if(runtime STREQUAL component)
    install(TARGETS axiscert_certified EXPORT ${component}Targets LIBRARY DESTINATION ${lib} ${with}
            ARCHIVE DESTINATION ${lib} ${with})
  else()
    install(TARGETS axiscert_certified EXPORT ${component}Targets LIBRARY DESTINATION ${lib} COMPONENT ${runtime} ${ARGN}
            NAMELINK_SKIP)
    install(TARGETS axiscert_certified LIBRARY DESTINATION ${lib} ${with} NAMELINK_ONLY)
  endif()
  file(RELATIVE_PATH prefix /${lib}/pkgconfig /)
  string(REGEX REPLACE "/$" "" prefix ${prefix})
  configure_file(cmake/axiscert.pc.in ${PROJECT_BINARY_DIR}/${component}/axiscert.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/${component}/axiscert.pc DESTINATION ${lib}/pkgconfig ${with})
  install(EXPORT ${component}Targets FILE axiscertCertifiedTargets.cmake NAMESPACE axiscert::
          DESTINATION ${lib}/cmake/axiscert ${with})
  install(FILES ${PROJECT_BINARY_DIR}/axiscertConfig.cmake ${PROJECT_BINARY_DIR}/axiscertConfigVersion.cmake
          DESTINATION ${lib}/cmake/axiscert ${with})
  install(FILES kernel/include/axiscert/certified.h kernel/include/axiscert/certified.hpp kernel/include/axiscert/contact.h kernel/include/axiscert/contact.hpp
          kernel/include/axiscert/plugin.h DESTINATION include/axiscert ${with})
endfunction()

axiscert_install_library(library lib library)
install(FILES LICENSE NOTICE docs/certified.md DESTINATION share/doc/libaxiscert COMPONENT library)
if(NOT PROJECT_IS_TOP_LEVEL OR NOT BUILD_SHARED_LIBS)
  return()  # Debian's packages have the shared library
endif()

# For the Debian packages (Packages.cmake): `runtime` is libaxiscert0, what a program needs that was linked with it;
# `development` is libaxiscert-dev.
axiscert_install_library(development lib/${CMAKE_LIBRARY_ARCHITECTURE} runtime EXCLUDE_FROM_ALL)

# Files that Debian requires of every package: who may copy it, and what changed.
find_program(AXISCERT_GZIP gzip REQUIRED)
configure_file(cmake/debian/changelog.in ${PROJECT_BINARY_DIR}/debian/changelog @ONLY)
execute_process(COMMAND ${AXISCERT_GZIP} -9nc ${PROJECT_BINARY_DIR}/debian/changelog
                OUTPUT_FILE ${PROJECT_BINARY_DIR}/debian/changelog.gz COMMAND_ERROR_IS_FATAL ANY)
foreach(package runtime:libaxiscert0 development:libaxiscert-dev)
  string(REPLACE ":" ";" package ${package})
  list(POP_FRONT package component)
  install(FILES cmake/debian/copyright NOTICE DESTINATION share/doc/${package} COMPONENT ${component} EXCLUDE_FROM_ALL)
  install(FILES ${PROJECT_BINARY_DIR}/debian/changelog.gz DESTINATION share/doc/${package} COMPONENT ${component} EXCLUDE_FROM_ALL)
endforeach()
install(FILES docs/certified.md DESTINATION share/doc/libaxiscert-dev COMPONENT development EXCLUDE_FROM_ALL)
