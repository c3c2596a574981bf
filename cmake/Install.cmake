# The places of everything but the library under `cmake --install build/release --prefix P`. The command finds its host and plug-ins
# relative to itself: P can be moved.
install(TARGETS axiscert EXPORT axiscertTargets RUNTIME DESTINATION bin)
if(TARGET axiscert_plugin_host)
  install(TARGETS axiscert_plugin_host RUNTIME DESTINATION libexec/axiscert)
endif()

# Plug-ins that come along: `peer/NAME` and `fault/NAME`.
foreach(room kernel/peers kernel/sphere_triangle/faults)
  get_filename_component(folder ${room} NAME)
  get_property(targets DIRECTORY ${PROJECT_SOURCE_DIR}/${room} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target ${targets})
    get_target_property(type ${target} TYPE)
    if(type STREQUAL MODULE_LIBRARY)
      # A build for the quick tests has no peers. Those of another test than the first have a folder of its name.
      get_target_property(room ${target} AXISCERT_ROOM)
      if(NOT room)
        set(room "")
      endif()
      install(TARGETS ${target} LIBRARY DESTINATION lib/axiscert/${folder}/${room} OPTIONAL)
    endif()
  endforeach()
  # Which ones this build lacks, and for want of what.
  install(FILES ${PROJECT_BINARY_DIR}/${folder}/absent.txt DESTINATION lib/axiscert/${folder} OPTIONAL)
endforeach()

# Those from npm, as programs: `npm ci --ignore-scripts` in their folder brings the engines.
set(programs_folder lib/axiscert/peers/npm)
set(programs_of kernel/peers/npm)
install(FILES ${programs_of}/package.json ${programs_of}/package-lock.json ${programs_of}/.npmrc DESTINATION ${programs_folder})
install(DIRECTORY ${programs_of}/engines DESTINATION ${programs_folder} FILES_MATCHING PATTERN "*.mjs")
foreach(test sphere-triangle moving-sphere box-box box-triangle)
  install(DIRECTORY ${programs_of}/${test} DESTINATION ${programs_folder} FILES_MATCHING PATTERN "*.json")
endforeach()

# The corpus, which `run --corpus` replays.
install(DIRECTORY fuzz/corpus DESTINATION share/axiscert FILES_MATCHING PATTERN "*.jsonl")

install(FILES ${PROJECT_BINARY_DIR}/axiscert.1 DESTINATION share/man/man1)
install(DIRECTORY ${PROJECT_BINARY_DIR}/completion/share DESTINATION .)

# For plug-ins: one header, and find_package(axiscert).
add_library(axiscert_plugin INTERFACE)
target_include_directories(axiscert_plugin INTERFACE $<INSTALL_INTERFACE:include>)
set_target_properties(axiscert_plugin PROPERTIES EXPORT_NAME plugin)
install(TARGETS axiscert_plugin EXPORT axiscertTargets)
install(FILES kernel/include/axiscert/plugin.h DESTINATION include/axiscert)

install(EXPORT axiscertTargets NAMESPACE axiscert:: DESTINATION ${package_folder})
install(FILES ${PROJECT_BINARY_DIR}/axiscertConfig.cmake ${PROJECT_BINARY_DIR}/axiscertConfigVersion.cmake
              cmake/axiscertAddPlugin.cmake
        DESTINATION ${package_folder})
install(FILES README.md LICENSE NOTICE CHANGELOG.md DESTINATION share/doc/axiscert)
