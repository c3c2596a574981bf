# Settings of a build of axiscert itself, which a project that includes it decides for its own.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_C_STANDARD 99)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})  # the command finds its host and plug-ins beside itself

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
