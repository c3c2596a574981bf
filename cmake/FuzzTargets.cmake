# Fuzz targets (docs/fuzzing.md): programs that libFuzzer drives. They take clang, so the preset asan-ubsan builds them.
option(AXISCERT_FUZZ_TARGETS "build the libFuzzer targets; takes clang and its runtimes" OFF)

if(AXISCERT_FUZZ_TARGETS)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "AXISCERT_FUZZ_TARGETS is ON, and the compiler is ${CMAKE_CXX_COMPILER_ID}: libFuzzer comes with clang. "
                        "Use the preset asan-ubsan, or clang++-16 (packages: clang-16 libclang-rt-16-dev libfuzzer-16-dev)")
  endif()
  include(CheckCXXSourceCompiles)
  set(CMAKE_REQUIRED_FLAGS "-fsanitize=fuzzer")
  check_cxx_source_compiles("extern \"C\" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }"
                            AXISCERT_HAS_LIBFUZZER)
  unset(CMAKE_REQUIRED_FLAGS)
  if(NOT AXISCERT_HAS_LIBFUZZER)
    message(FATAL_ERROR "AXISCERT_FUZZ_TARGETS is ON, and a program with -fsanitize=fuzzer cannot be linked: install "
                        "libclang-rt-16-dev and libfuzzer-16-dev, or configure with -DAXISCERT_FUZZ_TARGETS=OFF")
  endif()
endif()

# axiscert_covered(TARGET): its code tells libFuzzer which of it was reached: that of parsers, a kernel has hardly a branch. Not of a
# library of another build. AddressSanitizer's runtime has the functions that it calls, so that every program links as before.
function(axiscert_covered target)
  get_target_property(of_another_build ${target} IMPORTED)
  if(AXISCERT_FUZZ_TARGETS AND NOT of_another_build)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
endfunction()

# axiscert_fuzz_target(NAME RUNS n LENGTH bytes SOURCES... LIBRARIES... [LONG]): the program fuzz_NAME, and the test fuzz.NAME, which
# gives it so many inputs made from the seeds of fuzz/targets/seeds.py, in the quick sanitized build a third. A number of inputs and a seed, and no clock: one
# program does the same every time; of another build (paths, addresses) libFuzzer learns other things. It writes nothing
# but an input at which the target fails.
function(axiscert_fuzz_target name)
  if(NOT AXISCERT_FUZZ_TARGETS)
    return()
  endif()
  cmake_parse_arguments(arg "LONG" "RUNS;LENGTH" "LIBRARIES" ${ARGN})
  add_executable(fuzz_${name} ${arg_UNPARSED_ARGUMENTS})
  target_link_libraries(fuzz_${name} PRIVATE ${arg_LIBRARIES} axiscert_fuzz_support axiscert_geometric_oracle
                                              axiscert_warnings)
  target_link_options(fuzz_${name} PRIVATE -fsanitize=fuzzer)
  set(folder ${PROJECT_BINARY_DIR}/fuzz_targets)
  add_dependencies(fuzz_${name} axiscert_fuzz_seeds)
  add_custom_command(TARGET fuzz_${name} POST_BUILD COMMAND ${CMAKE_COMMAND} -E make_directory ${folder}/found VERBATIM)
  # For ./dev fuzz.
  file(CONFIGURE OUTPUT ${folder}/${name}.options CONTENT "-max_len=${arg_LENGTH}\n" @ONLY)
  if(AXISCERT_TESTS)
    set(long "")
    if(arg_LONG)
      set(long LONG)
    elseif(AXISCERT_REUSES_TARGETS)
      math(EXPR arg_RUNS "${arg_RUNS} / 3")
    endif()
    axiscert_script_test(fuzz.${name} SANITIZED ${long} NEEDS fuzz_${name} TIMEOUT 900
                         COMMAND fuzz_${name} -seed_inputs=@${folder}/seeds/${name}.list -runs=${arg_RUNS} -seed=1
                                       -max_len=${arg_LENGTH} -artifact_prefix=${folder}/found/${name}- -verbosity=0)
  endif()
endfunction()
