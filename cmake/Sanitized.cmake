# Sanitized builds. The sanitizers watch code where memory is at risk: the plug-in host, parsers, pipe, journal, vector kernels,
# families, reports, and the tests marked SANITIZED. Every other library is taken whole from the build in AXISCERT_BUILT, of the
# preset release, which exports its targets as built::NAME. AXISCERT_SANITIZE_ALL compiles and sanitizes these too.
set(AXISCERT_SANITIZED OFF)
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize=")
  set(AXISCERT_SANITIZED ON)
endif()
set(AXISCERT_REUSES_TARGETS OFF)
if(AXISCERT_SANITIZED AND AXISCERT_BUILT AND NOT AXISCERT_SANITIZE_ALL)
  set(AXISCERT_REUSES_TARGETS ON)
endif()

if(AXISCERT_REUSES_TARGETS)
  if(NOT EXISTS ${AXISCERT_BUILT}/axiscertBuilt.cmake)
    message(FATAL_ERROR "${AXISCERT_BUILT} is no configured build, and a sanitized build takes libraries from one. First "
                        "cmake --preset release && cmake --build --preset release; or sanitize everything: preset asan-ubsan-all")
  endif()
  include(${AXISCERT_BUILT}/axiscertBuilt.cmake)
  get_property(imported DIRECTORY PROPERTY IMPORTED_TARGETS)
  list(FILTER imported INCLUDE REGEX "^built::")
  set_target_properties(${imported} PROPERTIES IMPORTED_GLOBAL ON SYSTEM OFF)
endif()

# axiscert_reuse(NAME [PUBLIC libraries...] [PRIVATE libraries...]): NAME is the library built::NAME, and takes these libraries of
# this build where the other build has its own.
function(axiscert_reuse name)
  cmake_parse_arguments(arg "" "" "PUBLIC;PRIVATE" ${ARGN})
  get_target_property(config built::${name} IMPORTED_CONFIGURATIONS)
  foreach(kind OBJECTS LOCATION)
    get_target_property(files built::${name} IMPORTED_${kind}_${config})
    foreach(file ${files})
      if(file AND NOT EXISTS ${file})
        message(FATAL_ERROR "${name} is not built in ${AXISCERT_BUILT} (${file}): first cmake --build --preset release")
      endif()
    endforeach()
  endforeach()
  list(TRANSFORM arg_PRIVATE REPLACE "^(.+)$" "$<LINK_ONLY:\\1>")
  set_target_properties(built::${name} PROPERTIES INTERFACE_LINK_LIBRARIES "${arg_PUBLIC};${arg_PRIVATE}"
                                                  INTERFACE_INCLUDE_DIRECTORIES ${PROJECT_SOURCE_DIR})
  add_library(${name} ALIAS built::${name})
endfunction()

# axiscert_export_built(): what a sanitized build takes from this one. A library that it takes names those that it links.
function(axiscert_export_built)
  get_property(reusable GLOBAL PROPERTY AXISCERT_REUSABLE)
  export(TARGETS ${reusable} kernel_fp interval_fp axiscert_light axiscert_warnings gmp mpfr random123 axiscert_called axiscert_kernel
         FILE ${PROJECT_BINARY_DIR}/axiscertBuilt.cmake NAMESPACE built::)
endfunction()
