# What `cmake --install build/release --prefix P` puts where. The command finds its host and its plug-ins relative to
# itself, and the package file finds the rest relative to it: P can be moved.
include(CMakePackageConfigHelpers)
set(package_folder lib/cmake/axiscert)

install(TARGETS axiscert EXPORT axiscertTargets RUNTIME DESTINATION bin)
if(TARGET axiscert_plugin_host)
  install(TARGETS axiscert_plugin_host RUNTIME DESTINATION libexec/axiscert)
endif()

# Plug-ins that come along: `peer/NAME` and `fault/NAME`.
foreach(folder peers faults)
  if(NOT EXISTS ${PROJECT_SOURCE_DIR}/kernel/${folder}/CMakeLists.txt)
    continue()
  endif()
  get_property(targets DIRECTORY ${PROJECT_SOURCE_DIR}/kernel/${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target ${targets})
    get_target_property(type ${target} TYPE)
    if(type STREQUAL MODULE_LIBRARY)
      install(TARGETS ${target} LIBRARY DESTINATION lib/axiscert/${folder})
    endif()
  endforeach()
  # Which ones this build lacks, and for want of what.
  install(FILES ${PROJECT_BINARY_DIR}/${folder}/absent.txt DESTINATION lib/axiscert/${folder} OPTIONAL)
endforeach()

# The corpus, which `run --corpus` replays.
install(DIRECTORY fuzz/corpus DESTINATION share/axiscert FILES_MATCHING PATTERN "*.jsonl")

install(FILES ${PROJECT_BINARY_DIR}/axiscert.1 DESTINATION share/man/man1)

# For plug-ins: one header, and find_package(axiscert).
add_library(axiscert_plugin INTERFACE)
target_include_directories(axiscert_plugin INTERFACE $<INSTALL_INTERFACE:include>)
set_target_properties(axiscert_plugin PROPERTIES EXPORT_NAME plugin)
install(TARGETS axiscert_plugin EXPORT axiscertTargets)
install(FILES kernel/plugin.h DESTINATION include/axiscert)

# The certified predicate, which needs none of the above: a component of its own, and the Debian package.
configure_file(cmake/axiscert.pc.in ${PROJECT_BINARY_DIR}/axiscert.pc @ONLY)
install(TARGETS axiscert_certified EXPORT axiscertCertifiedTargets LIBRARY DESTINATION lib COMPONENT library)
target_include_directories(axiscert_certified INTERFACE $<INSTALL_INTERFACE:include>)
install(FILES kernel/certified.h kernel/certified.hpp kernel/plugin.h DESTINATION include/axiscert COMPONENT library)
install(FILES ${PROJECT_BINARY_DIR}/axiscert.pc DESTINATION lib/pkgconfig COMPONENT library)
install(EXPORT axiscertCertifiedTargets NAMESPACE axiscert:: DESTINATION ${package_folder} COMPONENT library)

install(EXPORT axiscertTargets NAMESPACE axiscert:: DESTINATION ${package_folder})
configure_package_config_file(cmake/axiscertConfig.cmake.in ${PROJECT_BINARY_DIR}/axiscertConfig.cmake
                              INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/axiscertConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/axiscertConfig.cmake ${PROJECT_BINARY_DIR}/axiscertConfigVersion.cmake
              cmake/axiscertAddPlugin.cmake
        DESTINATION ${package_folder})

install(FILES ${PROJECT_BINARY_DIR}/axiscertConfig.cmake ${PROJECT_BINARY_DIR}/axiscertConfigVersion.cmake
        DESTINATION ${package_folder} COMPONENT library)
install(FILES LICENSE NOTICE docs/certified.md DESTINATION share/doc/libaxiscert COMPONENT library)

# `cpack -G DEB` in the build folder: the library, its headers and its package files, with the dependencies that
# dpkg-shlibdeps finds.
set(CPACK_PACKAGE_NAME libaxiscert-dev)
set(CPACK_PACKAGE_VENDOR axiscert)
set(CPACK_PACKAGE_CONTACT "the authors of axiscert <axiscert@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "exact sphere-triangle predicate, SIMD, for C and C++")
set(CPACK_COMPONENTS_ALL library)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libaxiscert-dev)
set(CPACK_DEBIAN_LIBRARY_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
include(CPack)

install(FILES README.md LICENSE NOTICE CHANGELOG.md DESTINATION share/doc/axiscert)
