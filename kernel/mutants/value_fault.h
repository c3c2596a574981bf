// Faults of a value, of a magnitude E: the epsilons, clamps, thresholds and early answers of kernels in use.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "kernel/base/enum_array.h"

namespace axiscert::mutants {

// X(name, what is done to a value x)
#define AXISCERT_VALUE_FAULTS(X)                       \
  X(plus, "x + E for x")                               \
  X(minus, "x - E for x")                              \
  X(clamp, "E for an x below E")                       \
  X(zero, "0 for an |x| below E")                      \
  X(early_contact, "the answer contact where |x| < E") \
  X(early_separated, "the answer separated where |x| < E")

// X(name, id in the name of a mutant, what it is, what the relative E of a bound is a fraction of)
#define AXISCERT_QUANTITIES(X)                                           \
  X(radius, "r", "the radius", "|A|")                                    \
  X(squared_radius, "rr", "r^2", "|A|^2")                                \
  X(squared_edge, "ab", "|AB|^2", "|A|^2")                               \
  X(squared_normal, "v", "|V|^2", "|AB|^2 |AC|^2")                       \
  X(side, "", "the left side of a comparison", "both sides' magnitudes") \
  X(verdict, "verdict", "the left side of every comparison; early: the largest coordinate of the scene", "both sides")

enum class ValueFault : std::uint8_t {
#define AXISCERT_NAME(name, what) name,
  AXISCERT_VALUE_FAULTS(AXISCERT_NAME)
#undef AXISCERT_NAME
      none
};
enum class Quantity : std::uint8_t {
#define AXISCERT_NAME(name, id, what, relative_to) name,
  AXISCERT_QUANTITIES(AXISCERT_NAME)
#undef AXISCERT_NAME
};

// The magnitudes of the mutants that are made unless others are asked for.
inline constexpr std::array<double, 7> default_magnitudes = {1e-1, 1e-2, 1e-4, 1e-6, 1e-8, 1e-12, 1e-20};

constexpr bool answers_early(ValueFault fault) {
  return fault == ValueFault::early_contact || fault == ValueFault::early_separated;
}

// Whether the fault adds E to the value: a relative E is then a fraction of the value itself, except for a side.
constexpr bool adds(ValueFault fault) { return fault == ValueFault::plus || fault == ValueFault::minus; }

// The value in place of x. An early answer leaves it as it is.
template <class Real>
Real faulty(ValueFault fault, Real x, Real e) {
  switch (fault) {
    case ValueFault::plus:
      return x + e;
    case ValueFault::minus:
      return x - e;
    case ValueFault::clamp:
      return x < e ? e : x;
    case ValueFault::zero:
      return std::fabs(x) < e ? Real{0} : x;
    case ValueFault::early_contact:
    case ValueFault::early_separated:
    case ValueFault::none:
      break;
  }
  return x;
}

}  // namespace axiscert::mutants
