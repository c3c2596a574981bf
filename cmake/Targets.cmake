# One flag set a floating-point mode, owned by a target; and the functions that the folders share.

# Round to nearest, one rounding an operation. g++ contracts a*b+c into a fused operation by default wherever the
# instruction set has one, vector intrinsics included; every translation unit here forbids it.
add_library(kernel_fp INTERFACE)
target_compile_options(kernel_fp INTERFACE -ffp-contract=off)

add_library(axiscert_warnings INTERFACE)
target_compile_options(axiscert_warnings INTERFACE -Wall -Wextra -Wconversion -Wno-sign-conversion)
if(AXISCERT_WARNINGS_ARE_ERRORS AND "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}" MATCHES "^(GNU 12|Clang 16)\\.")
  target_compile_options(axiscert_warnings INTERFACE -Werror)
endif()

# Flags of code whose own speed hardly matters: command lines, reports. -O1 takes two thirds of the compile time of -O2.
# A room within a library that has others takes the flags alone.
set(axiscert_light_flags $<$<CONFIG:Release>:-O1>)
add_library(axiscert_light INTERFACE)
target_compile_options(axiscert_light INTERFACE ${axiscert_light_flags})

# Flags of tests that spend their time in the libraries that they test, not in templates of a library's headers.
add_library(axiscert_unoptimized INTERFACE)
target_compile_options(axiscert_unoptimized INTERFACE $<$<CONFIG:Release>:-O0>)

# Sanitized builds. Sanitizers are for the code where memory is at risk (the plug-in host, parsers, pipe, journal, vector kernels,
# families, reports) and for its tests, marked MEMORY below. All else is linked as the other compiler built it in the folder
# AXISCERT_BUILT, of the preset release: a sanitized build compiles for minutes what g++ has compiled already.
# AXISCERT_SANITIZE_ALL, of the preset asan-ubsan-all, compiles and sanitizes all of it.
set(AXISCERT_SANITIZED OFF)
if(CMAKE_CXX_FLAGS MATCHES "-fsanitize=")
  set(AXISCERT_SANITIZED ON)
endif()
set(AXISCERT_REUSES_OBJECTS OFF)
if(AXISCERT_SANITIZED AND AXISCERT_BUILT AND NOT AXISCERT_SANITIZE_ALL)
  set(AXISCERT_REUSES_OBJECTS ON)
endif()
# axiscert_reused(result TARGET SOURCES...): the sources, or where objects are reused theirs from the same target of that build.
function(axiscert_reused result target)
  set(found ${ARGN})
  if(AXISCERT_REUSES_OBJECTS)
    file(RELATIVE_PATH room ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
    string(REPLACE "${CMAKE_CURRENT_BINARY_DIR}/" "" found "${found}")
    list(TRANSFORM found PREPEND ${AXISCERT_BUILT}/${room}/CMakeFiles/${target}.dir/)
    list(TRANSFORM found APPEND .o)
    foreach(object ${found})
      if(NOT EXISTS ${object})
        message(FATAL_ERROR "${object} is not there: a sanitized build reuses objects of another one; build that first: "
                            "./dev build release, or sanitize everything with the preset asan-ubsan-all")
      endif()
    endforeach()
    set_property(SOURCE ${found} PROPERTY EXTERNAL_OBJECT ON)
  endif()
  set(${result} ${found} PARENT_SCOPE)
endfunction()
# axiscert_objects(NAME SOURCES... [PUBLIC libraries...] [PRIVATE libraries...] [UNITY]): an object library, reused where objects are.
# UNITY: compiled as by axiscert_unity, so none of its sources may have options of its own.
function(axiscert_objects name)
  cmake_parse_arguments(arg "UNITY" "" "PUBLIC;PRIVATE" ${ARGN})
  set(compiled ${arg_UNPARSED_ARGUMENTS})
  if(arg_UNITY AND AXISCERT_REUSES_OBJECTS)
    axiscert_vectors_among(alone ${compiled})
    list(REMOVE_ITEM compiled ${alone})
    list(LENGTH compiled count)
    math(EXPR last "(${count} - 1) / ${axiscert_unity_batch}")
    set(compiled ${alone})
    foreach(batch RANGE ${last})
      list(APPEND compiled Unity/unity_${batch}_cxx.cxx)
    endforeach()
  endif()
  axiscert_reused(sources ${name} ${compiled})
  if(AXISCERT_REUSES_OBJECTS)
    add_library(${name} INTERFACE)
    target_link_libraries(${name} INTERFACE ${sources} ${arg_PUBLIC} ${arg_PRIVATE})
    target_include_directories(${name} INTERFACE ${PROJECT_SOURCE_DIR})
  else()
    add_library(${name} OBJECT ${sources})
    target_link_libraries(${name} PUBLIC ${arg_PUBLIC} PRIVATE ${arg_PRIVATE} axiscert_warnings)
    target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>)
    if(arg_UNITY)
      axiscert_unity(${name})
    endif()
  endif()
endfunction()

# g++ collects its garbage from 1 GB on, not from 128 MB: a tenth of the time of the large sources, which take 1.7 GB then, not 1.3.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options("$<$<COMPILE_LANGUAGE:CXX>:--param=ggc-min-expand=100;--param=ggc-min-heapsize=1000000>")
endif()

# ccache and lld where they are installed: neither changes a byte of what is computed.
find_program(AXISCERT_CCACHE ccache)
if(AXISCERT_CCACHE)
  # Precompiled headers take these allowances; no source here uses __TIME__. With CCACHE_DEPEND a source is not preprocessed
  # a second time, which would cost a build without a warm cache a third of its time.
  set(CMAKE_CXX_COMPILER_LAUNCHER env CCACHE_DEPEND=1 CCACHE_SLOPPINESS=pch_defines,time_macros
      ${AXISCERT_CCACHE})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-fpch-preprocess>)
  endif()
endif()
if(NOT AXISCERT_ONLY_LIBRARY)  # packages are linked as the system links
  include(CheckLinkerFlag)
  check_linker_flag(CXX -fuse-ld=lld AXISCERT_HAS_LLD)
  if(AXISCERT_HAS_LLD)
    add_link_options(-fuse-ld=lld)
  endif()
endif()

# The programs that the tests with the label `quick` need, which `./dev test` runs. The others have the label `long`; ./dev test --long
# runs both.
add_custom_target(axiscert_quick)

# axiscert_unity(TARGET): its sources compiled forty at a time. The headers of JSON and of the command line, and what each source instantiates
# of them, take 8 seconds a file, precompiled or not; forty files take 40. So names in unnamed namespaces are a target's own, not a file's.
# Sources that compile for several instruction sets include themselves and stay alone, as, by CMake, those with options of their own.
set(axiscert_unity_batch 40)
function(axiscert_unity target)
  get_target_property(sources ${target} SOURCES)
  axiscert_vectors_among(vectors ${sources})
  if(vectors)
    set_property(SOURCE ${vectors} PROPERTY SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${axiscert_unity_batch})
endfunction()

# axiscert_sources(result ROOMS folders... [EXCEPT names...]): the sources of the rooms, so that a new file takes no line here. Tests,
# benchmarks, fuzz targets and programs (`_test`, `_bench`, `_target`, `write_`, `print_`) are named by whoever makes them.
function(axiscert_sources result)
  cmake_parse_arguments(arg "" "" "ROOMS;EXCEPT" ${ARGN})
  list(TRANSFORM arg_ROOMS APPEND /*.cpp)
  file(GLOB sources CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} ${arg_ROOMS})
  list(FILTER sources EXCLUDE REGEX "_(test|bench|target)\\.cpp$")
  list(FILTER sources EXCLUDE REGEX "(^|/)(write|print)_[a-z_]*\\.cpp$")
  list(REMOVE_ITEM sources ${arg_EXCEPT})
  set(${result} ${sources} PARENT_SCOPE)
endfunction()

# Settings for every test: where the tree and the build are, the meshes of the package assimp-testmodels, and by how much the
# numbers of queries are divided. The same for all of them, so that they can share a precompiled header.
add_library(axiscert_test_settings INTERFACE)
target_compile_definitions(axiscert_test_settings INTERFACE
  SOURCE_FOLDER="${PROJECT_SOURCE_DIR}" BUILD_FOLDER="${PROJECT_BINARY_DIR}" TEST_MODELS="${TEST_MODELS}"
  TRIAL_DIVISOR=${AXISCERT_TRIAL_DIVISOR})

# axiscert_test_header(LAYER LIBRARIES libraries... HEADERS headers... [UNOPTIMIZED]): the precompiled header of a layer's tests, read
# once; with UNOPTIMIZED it and they are compiled at -O0, else at -O1.
function(axiscert_test_header layer)
  if(NOT AXISCERT_TESTS)
    return()
  endif()
  cmake_parse_arguments(arg "UNOPTIMIZED" "" "LIBRARIES;HEADERS" ${ARGN})
  set(flags axiscert_light)
  if(arg_UNOPTIMIZED)
    set(flags axiscert_unoptimized)
  endif()
  set_property(GLOBAL PROPERTY AXISCERT_FLAGS_OF_${layer}_TESTS ${flags})
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${layer}_test_header.cpp)
  file(CONFIGURE OUTPUT ${source} CONTENT "" @ONLY)
  add_library(${layer}_test_header OBJECT EXCLUDE_FROM_ALL ${source})
  target_link_libraries(${layer}_test_header PRIVATE ${arg_LIBRARIES} axiscert_test_settings ${flags} axiscert_warnings
                                                       GTest::gtest GTest::gmock)
  target_precompile_headers(${layer}_test_header PRIVATE <gtest/gtest.h> <gmock/gmock.h> ${arg_HEADERS})
endfunction()

# axiscert_test(NAME SOURCES... [ROOMS folders...] LIBRARIES libraries... [HEADER layer] [NEEDS targets...] [MEMORY] [REUSED filter]
# [LONG]): a GoogleTest program, one CTest test a case (one for all where objects are reused), of its sources and the `_test.cpp` of its rooms. Suites whose names end in "Long", typed
# ones (SuiteLong/0) too, get the label `long`, the others `quick`; with LONG all get `long`, and in a sanitized build all that are not
# marked MEMORY. HEADER: the layer whose precompiled header it
# takes. UNOPTIMIZED: compiled at -O0. NEEDS: what has to be built for it to run. REUSED: the cases about code of which a sanitized build reuses the objects.
function(axiscert_test name)
  if(NOT AXISCERT_TESTS)
    return()
  endif()
  cmake_parse_arguments(arg "LONG;MEMORY;UNOPTIMIZED" "HEADER;REUSED" "LIBRARIES;ROOMS;NEEDS" ${ARGN})
  set(sources ${arg_UNPARSED_ARGUMENTS})
  if(arg_ROOMS)
    list(TRANSFORM arg_ROOMS APPEND /*_test.cpp)
    file(GLOB found CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} ${arg_ROOMS})
    list(APPEND sources ${found})
  endif()
  add_executable(${name} ${sources})
  list(FILTER sources INCLUDE REGEX "_test\\.cpp$")
  list(TRANSFORM sources PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/ REGEX "^[^/]")
  set_property(GLOBAL APPEND PROPERTY AXISCERT_TESTED ${sources})
  get_property(flags GLOBAL PROPERTY AXISCERT_FLAGS_OF_${arg_HEADER}_TESTS)
  if(arg_UNOPTIMIZED)
    set(flags axiscert_unoptimized)
  elseif(NOT flags)
    set(flags axiscert_light)
  endif()
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} axiscert_test_settings ${flags} axiscert_warnings GTest::gtest GTest::gmock
                                        GTest::gtest_main)
  axiscert_unity(${name})
  if(arg_HEADER)
    target_precompile_headers(${name} REUSE_FROM ${arg_HEADER}_test_header)
  endif()
  set(label quick)
  if(arg_LONG OR (AXISCERT_SANITIZED AND NOT arg_MEMORY))
    set(label long)
  else()
    add_dependencies(axiscert_quick ${name})
  endif()
  if(arg_NEEDS)
    add_dependencies(${name} ${arg_NEEDS})
  endif()
  if(AXISCERT_REUSES_OBJECTS)
    # A sanitized program takes half a second to start, longer than most of its cases.
    if(label STREQUAL quick)
      add_test(NAME ${name} COMMAND ${name} --gtest_brief=1 --gtest_filter=-*Long.*:*Long/*:${arg_REUSED})
      # g++'s objects have no frame pointers, so the stack of each allocation in them reads as a new one, of which AddressSanitizer keeps
      # all: fill_test took 12 minutes with that and takes half a minute without. To see whole stacks, run the program alone.
      set_tests_properties(${name} PROPERTIES LABELS quick TIMEOUT 900 ENVIRONMENT ASAN_OPTIONS=malloc_context_size=1)
    endif()
    return()
  endif()
  include(GoogleTest)
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST TEST_FILTER -*Long.*:*Long/* TEST_LIST ${name}_fast
                       PROPERTIES LABELS ${label} TIMEOUT 900)
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST TEST_FILTER *Long.*:*Long/* TEST_LIST ${name}_long
                       PROPERTIES LABELS long TIMEOUT 7200)
endfunction()

# axiscert_script_test(NAME COMMAND command... [NEEDS targets...] [TIMEOUT seconds] [MEMORY] [LONG]): a test that is a script or a
# program's exit code, with the label `quick` or `long`, as axiscert_test has them.
function(axiscert_script_test name)
  cmake_parse_arguments(arg "LONG;MEMORY" "TIMEOUT" "COMMAND;NEEDS" ${ARGN})
  add_test(NAME ${name} COMMAND ${arg_COMMAND})
  set_property(GLOBAL APPEND PROPERTY AXISCERT_TESTED ${arg_COMMAND})
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 1200)
  endif()
  set(label quick)
  if(arg_LONG OR (AXISCERT_SANITIZED AND NOT arg_MEMORY))
    set(label long)
  elseif(arg_NEEDS)
    add_dependencies(axiscert_quick ${arg_NEEDS})
  endif()
  # Scripts take longest: begun first, none of them is the last to end, alone on one core.
  set_tests_properties(${name} PROPERTIES LABELS ${label} TIMEOUT ${arg_TIMEOUT} COST 1000)
endfunction()

# axiscert_require_tests(): fails where a `_test.cpp` or `_test.py` of the tree belongs to no test, in a build that has all of them.
function(axiscert_require_tests)
  if(NOT AXISCERT_TESTS OR NOT AXISCERT_PEERS OR NOT AXISCERT_EXAMPLES OR NOT AXISCERT_TRIAL_DIVISOR EQUAL 1)
    return()
  endif()
  get_property(tested GLOBAL PROPERTY AXISCERT_TESTED)
  foreach(room kernel exact proofs fuzz reports cli examples)
    file(GLOB_RECURSE found CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${room}/*_test.cpp ${room}/*_test.py)
    foreach(file ${found})
      if(NOT ${PROJECT_SOURCE_DIR}/${file} IN_LIST tested)
        message(SEND_ERROR "${file} is in no test: name its folder among the ROOMS of an axiscert_test, or the file in an "
                           "axiscert_test or axiscert_script_test, in ${room}/CMakeLists.txt or one below it")
      endif()
    endforeach()
  endforeach()
endfunction()

# axiscert_bench(NAME SOURCES... LIBRARIES libraries...): a Google Benchmark program; `./dev bench` runs it.
function(axiscert_bench name)
  if(NOT AXISCERT_TESTS OR NOT AXISCERT_BENCHMARKS)
    return()
  endif()
  cmake_parse_arguments(arg "" "" "LIBRARIES" ${ARGN})
  add_executable(${name} ${arg_UNPARSED_ARGUMENTS})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} axiscert_test_settings axiscert_warnings benchmark::benchmark_main)
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

# axiscert_c_plugin(folder name source options...): the source as a plug-in ${PROJECT_BINARY_DIR}/FOLDER/NAME.so, the target
# FOLDER_NAME, of which axiscert_FOLDER is all. Never sanitized: what is wrong with a plug-in is for axiscert to find, and the process
# that loads it need not be sanitized.
function(axiscert_c_plugin folder name source)
  set(plugin ${folder}_${name})
  add_library(${plugin} MODULE ${source})
  set_target_properties(${plugin} PROPERTIES PREFIX "" OUTPUT_NAME ${name} C_VISIBILITY_PRESET hidden CXX_VISIBILITY_PRESET hidden
                                             LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${folder})
  target_include_directories(${plugin} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_options(${plugin} PRIVATE -fno-sanitize=all -fmacro-prefix-map=${PROJECT_SOURCE_DIR}/= ${ARGN})
  target_link_libraries(${plugin} PRIVATE kernel_fp axiscert_warnings)
  if(NOT TARGET axiscert_${folder})
    add_custom_target(axiscert_${folder})
  endif()
  add_dependencies(axiscert_${folder} ${plugin})
endfunction()

# axiscert_c_plugins(folder options...): such a plug-in of each .c and .cpp file here that is not a test, by the file's name.
function(axiscert_c_plugins folder)
  file(GLOB sources CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} *.c *.cpp)
  list(FILTER sources EXCLUDE REGEX "_test\\.cpp$")
  foreach(source ${sources})
    get_filename_component(name ${source} NAME_WE)
    axiscert_c_plugin(${folder} ${name} ${source} ${ARGN})
  endforeach()
endfunction()
