// The predicates that exist, one name each, in the order of the reports; the first is the predicate of what names none.
//
// Each layer expands the list and calls one function of the predicate's room in it. A room that lacks its function is
// an error of the linker that names it:
//   kernel/registry/predicates.cpp     const Predicate& NAME_predicate();
//   kernel/registry/registry.cpp       std::vector<Kernel> NAME_kernels();
//   exact/judge/oracles.cpp            const Oracles& NAME_oracles(std::size_t entry);   of an entry of the predicate
//   fuzz/queries/family.cpp            std::span<const Family* const> NAME_families();
//   fuzz/queries/family.cpp            const Capabilities& NAME_capabilities();
// NAME has '_' where the predicate's id has '-'.
#pragma once

// A build may add predicates of its own, as the test suite does: -D'AXISCERT_MORE_PREDICATES(X)=X(point_box)'.
#ifndef AXISCERT_MORE_PREDICATES
#define AXISCERT_MORE_PREDICATES(X)
#endif

#define AXISCERT_PREDICATES(X) \
  X(sphere_triangle)           \
  X(moving_sphere)             \
  X(box_box)                   \
  X(box_triangle)              \
  X(capsule_triangle)          \
  AXISCERT_MORE_PREDICATES(X)
