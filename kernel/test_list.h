// The tests that exist, one name each, in the order of the reports; the first is the test of what names none.
//
// Each layer expands the list and calls one function of the test's room in it. A room that lacks its function is an
// error of the linker that names it:
//   kernel/registry/tests.cpp      const TestDescription& NAME_test();
//   kernel/registry/registry.cpp   std::vector<Kernel> NAME_kernels();
//   exact/trait/oracles.cpp        const Oracles& NAME_oracles(std::size_t entry);   of an entry of the test
//   fuzz/queries/family.cpp        std::span<const Family* const> NAME_families();
//   fuzz/queries/capabilities.cpp  const Capabilities& NAME_capabilities();
// NAME has '_' where the test's id has '-'.
#pragma once

// A build may add tests of its own, as the test suite does: -D'AXISCERT_MORE_TESTS(X)=X(point_box)'.
#ifndef AXISCERT_MORE_TESTS
#define AXISCERT_MORE_TESTS(X)
#endif

#define AXISCERT_TESTS(X) \
  X(sphere_triangle)      \
  X(moving_sphere)        \
  X(box_box)              \
  X(box_triangle)         \
  AXISCERT_MORE_TESTS(X)
