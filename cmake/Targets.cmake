# One flag set a floating-point mode, owned by a target; and the functions that the folders share.

# Round to nearest, one rounding an operation. g++ contracts a*b+c into a fused operation by default wherever the
# instruction set has one, vector intrinsics included; every translation unit here forbids it.
add_library(kernel_fp INTERFACE)
target_compile_options(kernel_fp INTERFACE -ffp-contract=off)

add_library(axiscert_warnings INTERFACE)
target_compile_options(axiscert_warnings INTERFACE -Wall -Wextra -Wconversion -Wno-sign-conversion)

# axiscert_unity(TARGET): its sources compiled eight at a time, for most of what a file costs is headers and what it instantiates of
# them. So names in unnamed namespaces are a target's own, not a file's. Not those that compile for several instruction sets, which
# include themselves, nor, as CMake has it, those with options of their own.
function(axiscert_unity target)
  get_target_property(sources ${target} SOURCES)
  foreach(source ${sources})
    get_filename_component(path ${source} ABSOLUTE)
    if(EXISTS ${path})
      file(STRINGS ${path} vectors REGEX "foreach_target\\.h" LIMIT_COUNT 1)
      if(vectors)
        set_property(SOURCE ${source} PROPERTY SKIP_UNITY_BUILD_INCLUSION ON)
      endif()
    endif()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
endfunction()

# axiscert_test(NAME SOURCES... LIBRARIES libraries... [PRECOMPILE header]): a GoogleTest program, one CTest test a case.
# Suites whose names end in "Long", typed ones (SuiteLong/0) too, get the label `long`. PRECOMPILE: what many of the sources
# include, read once.
function(axiscert_test name)
  if(NOT AXISCERT_TESTS)
    return()
  endif()
  cmake_parse_arguments(arg "" "PRECOMPILE" "LIBRARIES" ${ARGN})
  add_executable(${name} ${arg_UNPARSED_ARGUMENTS})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} axiscert_warnings GTest::gtest_main)
  axiscert_unity(${name})
  if(arg_PRECOMPILE)
    target_precompile_headers(${name} PRIVATE <gtest/gtest.h> "${PROJECT_SOURCE_DIR}/${arg_PRECOMPILE}")
  endif()
  include(GoogleTest)
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST TEST_FILTER -*Long.*:*Long/* TEST_LIST ${name}_fast PROPERTIES TIMEOUT 900)
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST TEST_FILTER *Long.*:*Long/* TEST_LIST ${name}_long
                       PROPERTIES LABELS long TIMEOUT 7200)
endfunction()

# axiscert_bench(NAME SOURCES... LIBRARIES libraries...): a Google Benchmark program; `./dev bench` runs it.
function(axiscert_bench name)
  if(NOT AXISCERT_TESTS OR NOT AXISCERT_BENCHMARKS)
    return()
  endif()
  cmake_parse_arguments(arg "" "" "LIBRARIES" ${ARGN})
  add_executable(${name} ${arg_UNPARSED_ARGUMENTS})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} axiscert_warnings benchmark::benchmark_main)
endfunction()

# axiscert_vector_sources(SOURCES...): of these, those that compile for several instruction sets lose UBSan, whose checks of
# hundreds of vector operations a function take minutes of compile time each, and keep AddressSanitizer, where there are any.
function(axiscert_vector_sources)
  if(NOT CMAKE_CXX_FLAGS MATCHES "-fsanitize=")
    return()
  endif()
  foreach(source ${ARGV})
    get_filename_component(path ${source} ABSOLUTE)
    file(STRINGS ${path} vectors REGEX "foreach_target\\.h" LIMIT_COUNT 1)
    if(vectors)
      set_property(SOURCE ${source} APPEND PROPERTY COMPILE_OPTIONS -fno-sanitize=undefined)
    endif()
  endforeach()
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
  # One template over sixteen number types takes a third of a sanitized build: the first of them is sanitized.
  if(CMAKE_CXX_FLAGS MATCHES "-fsanitize=")
    list(REMOVE_AT sources 0)
    set_property(SOURCE ${sources} APPEND PROPERTY COMPILE_OPTIONS -fno-sanitize=all)
    set_property(SOURCE ${sources} PROPERTY SKIP_PRECOMPILE_HEADERS ON)
  endif()
endfunction()

# axiscert_c_plugin(folder name options...): NAME.c as a plug-in with a fault, ${PROJECT_BINARY_DIR}/FOLDER/NAME.so. Never
# sanitized: what is wrong with it is for axiscert to find, and the process that loads it need not be sanitized.
function(axiscert_c_plugin folder name)
  set(target ${folder}_${name})
  add_library(${target} MODULE ${name}.c)
  set_target_properties(${target} PROPERTIES PREFIX "" OUTPUT_NAME ${name} C_VISIBILITY_PRESET hidden
                                             LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${folder})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_options(${target} PRIVATE -fno-sanitize=all ${ARGN})
  target_link_libraries(${target} PRIVATE kernel_fp axiscert_warnings)
endfunction()
