# Tests, benchmarks and the plug-ins that tests load.

# The programs that the tests with the label `quick` need. The others have the label `long`.
add_custom_target(axiscert_quick)

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

# axiscert_test(NAME SOURCES... [FOLDERS folders... [EXCEPT sources...]] LIBRARIES libraries... [HEADER layer] [NEEDS targets...] [SANITIZED]
# [SKIP_IF_REUSED filter] [UNOPTIMIZED] [LONG]): a GoogleTest program of its sources and the `_test.cpp` of its folders, one CTest test
# a case, or one for all where libraries are reused. Suites whose names end in "Long", typed ones (SuiteLong/0) too, get the label
# `long`, the others `quick`; with LONG all get `long`, and in a sanitized build all that are not marked SANITIZED. HEADER: the layer
# whose precompiled header it takes. NEEDS: what has to be built for it to run. SKIP_IF_REUSED: the cases that a sanitized build leaves
# out where it reuses the code that they test. UNOPTIMIZED: compiled at -O0.
function(axiscert_test name)
  if(NOT AXISCERT_TESTS)
    return()
  endif()
  cmake_parse_arguments(arg "LONG;SANITIZED;UNOPTIMIZED" "HEADER;SKIP_IF_REUSED" "LIBRARIES;FOLDERS;EXCEPT;NEEDS" ${ARGN})
  set(sources ${arg_UNPARSED_ARGUMENTS})
  if(arg_FOLDERS)
    list(TRANSFORM arg_FOLDERS APPEND /*_test.cpp)
    file(GLOB found CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} ${arg_FOLDERS})
    list(REMOVE_ITEM found ${arg_EXCEPT})
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
  if(arg_LONG OR (AXISCERT_SANITIZED AND NOT arg_SANITIZED))
    set(label long)
  else()
    add_dependencies(axiscert_quick ${name})
  endif()
  if(arg_NEEDS)
    add_dependencies(${name} ${arg_NEEDS})
  endif()
  if(AXISCERT_REUSES_TARGETS)
    # A sanitized program takes half a second to start, longer than most of its cases.
    if(label STREQUAL quick)
      add_test(NAME ${name} COMMAND ${name} --gtest_brief=1 --gtest_filter=-*Long.*:*Long/*:${arg_SKIP_IF_REUSED})
      # g++'s objects have no frame pointers, so the stack of each allocation in them reads as a new one, of which AddressSanitizer keeps
      # all: fill_test took 12 minutes with that and takes half a minute without. To see whole stacks, run the program alone.
      set_tests_properties(${name} PROPERTIES LABELS quick TIMEOUT 900 ENVIRONMENT ASAN_OPTIONS=malloc_context_size=1)
    endif()
    return()
  endif()
  include(GoogleTest)
  # A program that does not list its tests in time makes all of ctest fail; the default, 5 seconds, is short beside a build.
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60 TEST_FILTER -*Long.*:*Long/* TEST_LIST ${name}_fast
                       PROPERTIES LABELS ${label} TIMEOUT 900)
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 60 TEST_FILTER *Long.*:*Long/* TEST_LIST ${name}_long
                       PROPERTIES LABELS long TIMEOUT 7200)
endfunction()

# axiscert_script_test(NAME COMMAND command... [NEEDS targets...] [TIMEOUT seconds] [SANITIZED] [LONG]): a test that is a script or a
# program's exit code, with the label `quick` or `long`, as axiscert_test has them.
function(axiscert_script_test name)
  cmake_parse_arguments(arg "LONG;SANITIZED" "TIMEOUT" "COMMAND;NEEDS" ${ARGN})
  add_test(NAME ${name} COMMAND ${arg_COMMAND})
  set_property(GLOBAL APPEND PROPERTY AXISCERT_TESTED ${arg_COMMAND})
  if(NOT arg_TIMEOUT)
    set(arg_TIMEOUT 1200)
  endif()
  set(label quick)
  if(arg_LONG OR (AXISCERT_SANITIZED AND NOT arg_SANITIZED))
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
  foreach(room kernel exact proofs fuzz reports plans cli examples)
    file(GLOB_RECURSE found CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${room}/*_test.cpp ${room}/*_test.py)
    foreach(file ${found})
      if(NOT ${PROJECT_SOURCE_DIR}/${file} IN_LIST tested)
        message(SEND_ERROR "${file} is in no test: name its folder among the FOLDERS of an axiscert_test, or the file in an "
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

# axiscert_c_plugin(folder name source options...): the source as a plug-in ${PROJECT_BINARY_DIR}/FOLDER/NAME.so, the target
# FOLDER_NAME, of which axiscert_FOLDER is all. Every quick test may load it. Never sanitized: what is wrong with a plug-in is for
# axiscert to find, and the process that loads it need not be sanitized.
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
    add_dependencies(axiscert_quick axiscert_${folder})
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
