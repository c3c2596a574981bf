// Kernels with one fault each, made from the formulae. A harness that certifies kernels has to detect them.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/base/enums.h"
#include "kernel/kernel.h"
#include "kernel/mutants/number.h"

namespace axiscert::mutants {
// Faults of a value, of a magnitude E: the epsilons, clamps, thresholds and early answers of kernels in use.

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

// Faults other than those of single operations. X(name, description for the reader)
#define AXISCERT_COMPARISON_FAULTS(X)               \
  X(strictness, "> for >=, or >= for >")            \
  X(reverse, "the sides exchanged")                 \
  X(always, "not evaluated: it always holds")       \
  X(epsilon, "lhs > rhs + 1e-6, or >=: needs more") \
  X(slack, "lhs + 1e-6 > rhs, or >=: needs less")   \
  X(flush, "a side that is subnormal is zero")
#define AXISCERT_KERNEL_FAULTS(X)                                                \
  X(drop, "the axis never separates")                                            \
  X(small_area, "an early answer where |V|^2 < 1e-10")                           \
  X(lane, "in vectors of 8 queries, one lane has the answer of the lane before") \
  X(tail, "queries after the last whole vector have the answers of that vector") \
  X(ftz, "subnormal operands and results of every operation are zero")

enum class ComparisonFault : std::uint8_t {
#define AXISCERT_NAME(name, what) name,
  AXISCERT_COMPARISON_FAULTS(AXISCERT_NAME)
#undef AXISCERT_NAME
      none
};
enum class KernelFault : std::uint8_t {
#define AXISCERT_NAME(name, what) name,
  AXISCERT_KERNEL_FAULTS(AXISCERT_NAME)
#undef AXISCERT_NAME
      none
};

struct Mutant {
  std::string id;     // "nonstrict~swap:17"
  std::string fault;  // "swap"
  std::string where;  // "17: B.x - A.x", "edge_ab.radius"
  std::string what;   // description of the fault
  bool in_binary32 = true;

  OperationSite operation{};
  ComparisonFault comparison = ComparisonFault::none;
  KernelFault kernel = KernelFault::none;
  std::size_t place = 0;  // the comparison, the axis (a clause), the verdict, the lane or the width

  ValueFault value = ValueFault::none;
  Quantity quantity = Quantity::radius;  // of a side, `place` is the comparison
  double magnitude = 0;                  // E, or the factor that makes it
  bool is_relative = false;
};

// The kernels that mutants are made of. They are right for every query over the reals, so a wrong verdict due to
// specification or implementation comes from the fault. kernel/mutants/forms.h has the formulae of each, by its number
// here.
inline constexpr std::array<std::string_view, 3> bases = {"nonstrict", "reduced-nonstrict",
                                                          "moving-sphere/twenty-nonstrict"};
// The number of a base. Throws Error that names the bases.
std::size_t base_index(std::string_view base);
// That of a mutant; a mutant without a fault has its base's id.
std::size_t base_of(const Mutant& mutant);
const Predicate& predicate_of(std::size_t base);
// The first base of a predicate. Throws Error that names the bases.
std::string_view base_for(const Predicate& predicate);

// All mutants of a base, in a fixed order. Throws Error that names the bases.
std::span<const Mutant> mutants_of(std::string_view base);
// The mutants with a fault of a value: every fault of every quantity, absolute and relative, in each magnitude. They
// are not among mutants_of. Throws Error that names the bases, or for a magnitude that is not a positive number.
std::vector<const Mutant*> value_mutants_of(std::string_view base, std::span<const double> magnitudes);
// The mutant with this id, of either kind. Throws Error that says what exists.
const Mutant& find_mutant(std::string_view id);

// The bits that the mutant answers to a batch.
template <class Real>
void mutant_bits(const Mutant& mutant, const QueryColumns<Real>& batch, ComparisonBits* out);

// The mutant as a kernel: it claims the bits of its base, and exposes its comparisons.
Kernel kernel_of(const Mutant& mutant);
// The same answers from a kernel that shows its verdict alone and claims nothing.
Kernel black_box_of(const Mutant& mutant);

// The mutants with a fault of a value, by name.

// The names of the faults, "clamp" and "clamp-relative" and so on.
std::vector<std::string> value_fault_names();
// The mutant of an id as "nonstrict~clamp:r:0.01", which is made when it is first asked for and kept; null where the id
// is none of these.
const Mutant* find_value_mutant(std::string_view id);

}  // namespace axiscert::mutants
