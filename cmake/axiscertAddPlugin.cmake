# axiscert_add_plugin(NAME sources...): NAME.so, a plug-in for `axiscert run --kernel plugin:NAME.so`, which exports
# axiscert_plugin and nothing else.
#
# -ffp-contract=off: g++ and clang may otherwise fuse a * b + c into one operation with one rounding, wherever the target
# has it, and what is judged would be the compiler's choice, not the source. A kernel that is shipped with contraction is to
# be judged with it: target_compile_options(NAME PRIVATE -ffp-contract=fast) after this, with the other flags of the shipped
# one.
function(axiscert_add_plugin name)
  if(NOT ARGN)
    message(FATAL_ERROR "axiscert_add_plugin(${name}): no sources; axiscert_add_plugin(NAME sources...) was expected")
  endif()
  add_library(${name} MODULE ${ARGN})
  set_target_properties(${name} PROPERTIES PREFIX "" SUFFIX .so C_VISIBILITY_PRESET hidden CXX_VISIBILITY_PRESET hidden
                                           VISIBILITY_INLINES_HIDDEN ON)
  target_compile_options(${name} PRIVATE -ffp-contract=off)
  target_link_libraries(${name} PRIVATE axiscert::plugin)
endfunction()

# axiscert_add_formulae(NAME SOURCE): NAME.so and NAME-exact.so, both from a source that includes <axiscert/formulae.hpp>. The first
# evaluates its formulae in float and double, the second in exact arithmetic, for which it needs GMP (Debian: libgmp-dev).
function(axiscert_add_formulae name source)
  find_path(AXISCERT_GMP_INCLUDE gmpxx.h)
  find_library(AXISCERT_GMP gmp)
  if(NOT AXISCERT_GMP_INCLUDE OR NOT AXISCERT_GMP)
    message(FATAL_ERROR "axiscert_add_formulae(${name}): exact arithmetic needs GMP, with gmpxx.h; the Debian package is libgmp-dev")
  endif()
  axiscert_add_plugin(${name} ${source})
  axiscert_add_plugin(${name}-exact ${source})
  target_compile_features(${name} PRIVATE cxx_std_17)
  target_compile_features(${name}-exact PRIVATE cxx_std_17)
  target_compile_definitions(${name}-exact PRIVATE AXISCERT_FORMULAE_EXACT)
  target_include_directories(${name}-exact SYSTEM PRIVATE ${AXISCERT_GMP_INCLUDE})
  target_link_libraries(${name}-exact PRIVATE ${AXISCERT_GMP})
endfunction()
