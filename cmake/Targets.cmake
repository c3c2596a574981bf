# One flag set a floating-point mode, owned by a target; and the two helpers the folders share.

# Round to nearest, one rounding an operation. g++ contracts a*b+c into a fused operation by default wherever the
# instruction set has one, vector intrinsics included; every translation unit here forbids it.
add_library(kernel_fp INTERFACE)
target_compile_options(kernel_fp INTERFACE -ffp-contract=off)

add_library(axiscert_warnings INTERFACE)
target_compile_options(axiscert_warnings INTERFACE -Wall -Wextra -Wconversion -Wno-sign-conversion)

# axiscert_test(NAME SOURCES... LIBRARIES libraries...): a GoogleTest program, one CTest test a case. Suites whose names
# end in "Long" get the label `long`.
function(axiscert_test name)
  if(NOT AXISCERT_TESTS)
    return()
  endif()
  cmake_parse_arguments(arg "" "" "LIBRARIES" ${ARGN})
  add_executable(${name} ${arg_UNPARSED_ARGUMENTS})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} axiscert_warnings GTest::gtest_main)
  include(GoogleTest)
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST TEST_FILTER -*Long.* TEST_LIST ${name}_fast PROPERTIES TIMEOUT 900)
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST TEST_FILTER *Long.* TEST_LIST ${name}_long
                       PROPERTIES LABELS long TIMEOUT 7200)
endfunction()

# axiscert_bench(NAME SOURCES... LIBRARIES libraries...): a Google Benchmark program; `./dev bench` runs it.
function(axiscert_bench name)
  if(NOT AXISCERT_TESTS)
    return()
  endif()
  cmake_parse_arguments(arg "" "" "LIBRARIES" ${ARGN})
  add_executable(${name} ${arg_UNPARSED_ARGUMENTS})
  target_link_libraries(${name} PRIVATE ${arg_LIBRARIES} axiscert_warnings benchmark::benchmark_main)
endfunction()
