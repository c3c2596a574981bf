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
