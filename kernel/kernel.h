// What a kernel is to the harness: functions over a batch, per precision and instruction set, and what they claim to
// compute.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/arithmetic/arithmetic_list.h"
#include "kernel/finding.h"
#include "kernel/sphere_triangle/description.h"
#include "kernel/sphere_triangle/formulae_list.h"
#include "kernel/query.h"

namespace axiscert {

// Where a kernel writes the full story of a batch: the comparison bits and the sixteen pairs of computed sides.
template <class Real>
struct Answers {
  std::vector<ComparisonBits> bits;
  std::array<std::vector<Real>, comparison_count> lhs, rhs;

  void resize(std::size_t n) {
    bits.resize(n);
    for (auto& column : lhs) column.resize(n);
    for (auto& column : rhs) column.resize(n);
  }
};

// One kernel in one precision on one instruction set. Both functions are total: any bits in, no trap, no allocation.
template <class Real>
struct Implementation {
  // Verdict only; `out` holds batch.size entries. `separated` or `contact`, of a filter `undecided` too; only some
  // look for bad input, and say `invalid`.
  std::function<void(const QueryColumns<Real>& batch, Verdict* out)> verdicts;
  // Comparison bits and computed sides; `out` is sized to the batch. Empty for a kernel that shows only verdicts.
  std::function<void(const QueryColumns<Real>& batch, Answers<Real>& out)> explain = {};
  // For somebody else's code: both at once, run again in other arrangements and watched. Appends what it did wrong;
  // a query that got no answer is `unanswered`. Empty for a built-in kernel.
  std::function<void(const QueryColumns<Real>& batch, Verdict* out, Answers<Real>& answers,
                     std::vector<Finding>& findings)>
      supervised = {};
  // `verdicts`, and how long the kernel itself took, in nanoseconds, where it runs in another process. Empty for a
  // built-in kernel.
  std::function<double(const QueryColumns<Real>& batch, Verdict* out)> timed = {};
  // The bits of `explain` alone. Empty where nothing is gained.
  std::function<void(const QueryColumns<Real>& batch, ComparisonBits* out)> bits = {};
};

// Within what a kernel promises to be right, inclusive; 0: no limit. A wrong answer outside fails no requirement.
struct Limits {
  double least_coordinate = 0, greatest_coordinate = 0;  // of |x| of A, B, C, P; the least of those that are not zero
  double least_area = 0;                                 // of the triangle
  double least_radius = 0, greatest_radius = 0;
  bool operator==(const Limits&) const = default;
  bool any() const { return *this != Limits{}; }
};

// An instruction set that a kernel can be asked to run on. `scalar` is the reference itself; the rest are Highway's
// names. Best first.
std::vector<std::string> available_targets();
inline constexpr std::string_view scalar_target = "scalar";
// The name as `available_targets` spells it (any case is accepted; `auto` is the best). Throws Error with what exists.
std::string resolve_target(std::string_view name);
bool same_letters(std::string_view a, std::string_view b);  // in any case

// How a kernel is called where that is not as a plan says (kernel/called.h).
struct Call {
  std::string target = {};                // on this instruction set and no other; empty: the one that is asked for
  Rounding rounding = Rounding::nearest;  // the caller's modes
  bool flush = false;
  bool operator==(const Call&) const = default;
  bool has_modes() const { return rounding != Rounding::nearest || flush; }
};

// What a kernel shows beside its verdict. Each includes the one before.
enum class Exposure : std::uint8_t { verdict, comparisons, sides };
inline constexpr std::array<std::string_view, 3> exposure_names = {"verdict", "comparisons", "sides"};

struct Kernel {
  std::string id;
  std::string summary;  // one line
  const TestDescription* test = &sphere_triangle_test();
  std::size_t entry = 0;  // of the test's: how it takes its numbers
  // What it claims to compute: these formulae, with these side comparisons, in this arithmetic.
  Formulae formulae = Formulae::published;
  Strictness strictness = Strictness::strict;
  Arithmetic arithmetic = Arithmetic::plain;
  Exposure exposes = Exposure::sides;
  // Empty where it does not exist in that precision. A kernel that has one form runs it on every target.
  std::function<Implementation<float>(std::string_view target)> binary32;
  std::function<Implementation<double>(std::string_view target)> binary64;
  bool has_simd = false;     // other instructions on other targets
  bool is_reference = true;  // claims the scalar reference's bits and sides, bit for bit; else none is judged by it
  bool takes_arithmetic = false;  // is the rung of RUNG+ARITHMETIC
  Touching touching = Touching::contact;
  Limits limits = {};
  Call call = {};
  std::string file = {};               // of a plug-in: its path
  std::string source = {};             // of a plug-in: FILE:LINE in its author's sources; empty: it does not say
  std::vector<Finding> findings = {};  // of loading it, whatever is asked

  template <class Real>
  Implementation<Real> on(std::string_view target) const {
    if constexpr (sizeof(Real) == 4) return binary32 ? binary32(target) : Implementation<Real>{};
    else return binary64 ? binary64(target) : Implementation<Real>{};
  }
  bool has(Precision precision) const {
    return precision == Precision::binary32 ? binary32 != nullptr : binary64 != nullptr;
  }
};

// As ids spell them: "closest_point" is "closest-point". `none` is empty.
std::string name(Formulae formulae);
std::string name(Arithmetic arithmetic);

// What an arithmetic is called and does; see arithmetic_list.h.
struct ArithmeticInfo {
  std::string name, summary;
  Arithmetic arithmetic;
  bool in_binary32, in_binary64;
  Exposure exposes;
};
const std::vector<ArithmeticInfo>& arithmetics();

// The kernels that stand in the registry.
std::span<const Kernel> kernels();
// One of those; RUNG+ARITHMETIC, for the scalar form of a rung in one of arithmetics(); either with @CALL
// (kernel/called.h); plugin:PATH for a plug-in (kernel/include/axiscert/plugin.h), peer/NAME or fault/NAME for one that
// comes with axiscert. Throws Error naming what exists. The reference is good for the life of the program.
const Kernel& find_kernel(std::string_view id);

}  // namespace axiscert
