# One flag set a floating-point mode, owned by a target; and the functions that the folders share.

# Round to nearest, one rounding an operation. g++ contracts a*b+c into a fused operation by default wherever the
# instruction set has one, vector intrinsics included; every translation unit here forbids it.
add_library(kernel_fp INTERFACE)
target_compile_options(kernel_fp INTERFACE -ffp-contract=off)

# For code that changes the rounding mode: no compiler moves an operation across the change.
add_library(interval_fp INTERFACE)
target_compile_options(interval_fp INTERFACE -frounding-math)

# For plug-ins: axiscert/plugin.h. The names with :: are those that find_package(axiscert) gives.
add_library(axiscert_plugin INTERFACE)
add_library(axiscert::plugin ALIAS axiscert_plugin)
target_include_directories(axiscert_plugin INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/kernel/include> $<INSTALL_INTERFACE:include>)
set_target_properties(axiscert_plugin PROPERTIES EXPORT_NAME plugin)

add_library(axiscert_warnings INTERFACE)
target_compile_options(axiscert_warnings INTERFACE -Wall -Wextra -Wconversion -Wno-sign-conversion)
if(AXISCERT_WARNINGS_ARE_ERRORS AND "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}" MATCHES "^(GNU 12|Clang 16)\\.")
  target_compile_options(axiscert_warnings INTERFACE -Werror)
endif()

# Flags of code whose own speed hardly matters: command lines, reports. -O1 takes two thirds of the compile time of -O2.
# A folder within a library that has others takes the flags alone.
set(axiscert_light_flags $<$<CONFIG:Release>:-O1>)
add_library(axiscert_light INTERFACE)
target_compile_options(axiscert_light INTERFACE ${axiscert_light_flags})

# Flags of tests that spend their time in the libraries that they test, not in templates of a library's headers.
add_library(axiscert_unoptimized INTERFACE)
target_compile_options(axiscert_unoptimized INTERFACE $<$<CONFIG:Release>:-O0>)

# axiscert_unity(TARGET): its sources compiled forty at a time. The headers of JSON and of the command line, and what each source
# instantiates of them, take 8 seconds a file, precompiled or not; forty files take 40. So names in unnamed namespaces are a target's
# own, not a file's. Sources that compile for several instruction sets include themselves and stay alone, as, by CMake, those with
# options of their own.
function(axiscert_unity target)
  get_target_property(sources ${target} SOURCES)
  axiscert_vectors_among(vectors ${sources})
  if(vectors)
    set_property(SOURCE ${vectors} PROPERTY SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 40)
endfunction()

# axiscert_library(OBJECT|STATIC NAME SOURCES... [PUBLIC libraries...] [PRIVATE libraries...] [UNITY]): a library that a sanitized build
# takes whole from the build beside it. UNITY: compiled as by axiscert_unity.
function(axiscert_library type name)
  cmake_parse_arguments(arg "UNITY" "" "PUBLIC;PRIVATE" ${ARGN})
  if(AXISCERT_REUSES_TARGETS)
    axiscert_reuse(${name} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE})
    return()
  endif()
  add_library(${name} ${type} ${arg_UNPARSED_ARGUMENTS})
  target_link_libraries(${name} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE} axiscert_warnings)
  target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
  if(arg_UNITY)
    axiscert_unity(${name})
  endif()
  set_property(GLOBAL APPEND PROPERTY AXISCERT_REUSABLE ${name})
endfunction()

# axiscert_sources(result FOLDERS folders... [EXCEPT names...]): the sources of the folders, so that a new file takes no line here. Tests,
# benchmarks, fuzz targets and programs (`_test`, `_bench`, `_target`, `write_`, `print_`) are named by whoever makes them.
function(axiscert_sources result)
  cmake_parse_arguments(arg "" "" "FOLDERS;EXCEPT" ${ARGN})
  list(TRANSFORM arg_FOLDERS APPEND /*.cpp)
  file(GLOB sources CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} ${arg_FOLDERS})
  list(FILTER sources EXCLUDE REGEX "_(test|bench|target)\\.cpp$")
  list(FILTER sources EXCLUDE REGEX "(^|/)(write|print)_[a-z_]*\\.cpp$")
  list(REMOVE_ITEM sources ${arg_EXCEPT})
  set(${result} ${sources} PARENT_SCOPE)
endfunction()

# axiscert_vectors_among(result SOURCES...): those that compile for several instruction sets.
function(axiscert_vectors_among result)
  set(among "")
  foreach(source ${ARGN})
    get_filename_component(path ${source} ABSOLUTE)
    if(EXISTS ${path})
      file(STRINGS ${path} vectors REGEX "foreach_target\\.h" LIMIT_COUNT 1)
      if(vectors)
        list(APPEND among ${source})
      endif()
    endif()
  endforeach()
  set(${result} ${among} PARENT_SCOPE)
endfunction()

# axiscert_vector_sources(SOURCES...): in a sanitized build, those of these that compile for several instruction sets lose UBSan, whose
# checks of hundreds of vector operations a function take minutes of compile time each, and keep AddressSanitizer. With -O2: below it
# nothing is inlined before AddressSanitizer, and clang takes six times as long.
function(axiscert_vector_sources)
  axiscert_vectors_among(vectors ${ARGN})
  if(AXISCERT_SANITIZED AND vectors)
    set_property(SOURCE ${vectors} APPEND PROPERTY COMPILE_OPTIONS -fno-sanitize=undefined -O2)
    set_property(SOURCE ${vectors} PROPERTY SKIP_PRECOMPILE_HEADERS ON)  # which is not of -O2
  endif()
endfunction()

# axiscert_instances(VARIABLE list.h template.cpp.in result): the template once for each `X(name, ...)` line of an X-macro
# list, with @VARIABLE@ replaced by the name; the generated sources in `result`.
function(axiscert_instances variable list template result)
  get_filename_component(list ${list} ABSOLUTE)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${list})
  file(READ ${list} text)
  get_filename_component(stem ${template} NAME_WE)
  string(REGEX MATCHALL "\n  X\\([a-z0-9_]+," entries "${text}")
  foreach(entry ${entries})
    string(REGEX REPLACE ".*\\(([a-z0-9_]+),$" "\\1" ${variable} "${entry}")
    set(source ${CMAKE_CURRENT_BINARY_DIR}/${stem}_${${variable}}.cpp)
    configure_file(${template} ${source} @ONLY)
    list(APPEND sources ${source})
  endforeach()
  set(${result} ${sources} PARENT_SCOPE)
endfunction()
