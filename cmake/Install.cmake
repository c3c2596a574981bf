# The places of everything but the library under `cmake --install build/release --prefix P`. The command finds its host and plug-ins
# relative to itself: P can be moved. The component `command` is in its Debian package too, `command_here` is not, and
# `command_debian` is there in its stead (Packages.cmake).
set(here COMPONENT command_here)
set(debian COMPONENT command_debian EXCLUDE_FROM_ALL)
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME command)

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
      # A build for the quick tests has no peers. Those of another predicate than the first have a folder of its name.
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

# Schemas of the data that commands print, for other programs.
install(DIRECTORY ${PROJECT_BINARY_DIR}/schemas/ DESTINATION share/axiscert/schemas)

install(FILES ${PROJECT_BINARY_DIR}/axiscert.1 DESTINATION share/man/man1 ${here})
install(FILES ${PROJECT_BINARY_DIR}/debian/axiscert.1.gz DESTINATION share/man/man1 ${debian})
install(DIRECTORY ${PROJECT_BINARY_DIR}/completion/share DESTINATION .)

# For plug-ins: headers, and find_package(axiscert). libaxiscert-dev has plugin.h, and the package file that finds the rest.
set(formulae kernel/include/axiscert/formulae.hpp kernel/include/axiscert/exact_number.hpp)
install(FILES kernel/include/axiscert/plugin.h DESTINATION include/axiscert ${here})
install(FILES ${formulae} DESTINATION include/axiscert)
foreach(place here debian)
  set(folder ${package_folder})
  if(place STREQUAL "debian")
    set(folder lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/axiscert)
  endif()
  install(TARGETS axiscert axiscert_plugin EXPORT axiscert_${place}Targets RUNTIME DESTINATION bin ${${place}})
  install(EXPORT axiscert_${place}Targets FILE axiscertTargets.cmake NAMESPACE axiscert:: DESTINATION ${folder} ${${place}})
  install(FILES cmake/axiscertAddPlugin.cmake DESTINATION ${folder} ${${place}})
endforeach()
install(FILES ${PROJECT_BINARY_DIR}/axiscertConfig.cmake ${PROJECT_BINARY_DIR}/axiscertConfigVersion.cmake
        DESTINATION ${package_folder} ${here})

# The documents, where the links of README.md lead. Debian has its own place for the license and what changed.
install(FILES README.md NOTICE CITATION.cff CITATION.bib DESTINATION share/doc/axiscert)
install(FILES LICENSE CHANGELOG.md DESTINATION share/doc/axiscert ${here})
install(DIRECTORY docs DESTINATION share/doc/axiscert FILES_MATCHING PATTERN "*.md" PATTERN "*.svg" PATTERN precision_claims.json
        PATTERN docs/checks EXCLUDE)
install(DIRECTORY examples/plugin examples/certified examples/pipe DESTINATION share/doc/axiscert/examples)
install(FILES examples/bits.py examples/boxes-by-corners.jsonl examples/cgal-double.jsonl DESTINATION share/doc/axiscert/examples)
install(FILES cmake/debian/copyright ${PROJECT_BINARY_DIR}/debian/changelog.gz DESTINATION share/doc/axiscert ${debian})
install(FILES cmake/debian/lintian-overrides DESTINATION share/lintian/overrides RENAME axiscert ${debian})
