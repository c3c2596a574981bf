// A kernel as the harness sees it: functions over a batch, per precision and instruction set, and what they claim to
// compute.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/base/arithmetic_list.h"
#include "kernel/base/enums.h"
#include "kernel/names.h"
#include "kernel/outcome.h"
#include "kernel/predicate.h"
#include "kernel/query.h"

namespace axiscert {
// The promises of a kernel of a predicate of motions, where engines differ. A query beyond a promise is not judged.

// Queries in which the two have a point in common before the motion.
enum class StartPolicy : std::uint8_t {
  reported,     // contact, at time 0
  approaching,  // contact, where the distance between them falls at first; else no promise
  ignored,      // no promise
};
template <>
inline constexpr std::size_t enum_count<StartPolicy> = 3;
inline constexpr EnumArray<StartPolicy, std::string_view> start_policy_names = {"reported", "approaching", "ignored"};
constexpr std::string_view name(StartPolicy which) { return start_policy_names[which]; }

// Queries with a displacement of zero.
enum class StillPolicy : std::uint8_t { reported, ignored };
template <>
inline constexpr std::size_t enum_count<StillPolicy> = 2;
inline constexpr EnumArray<StillPolicy, std::string_view> still_policy_names = {"reported", "ignored"};
constexpr std::string_view name(StillPolicy which) { return still_policy_names[which]; }

// Triangles that are met from behind, so also those without area: by a motion D with D.(AB x AC) >= 0; without one, by
// a centre P with (P - A).(AB x AC) <= 0.
enum class SidesPolicy : std::uint8_t { both, front };
template <>
inline constexpr std::size_t enum_count<SidesPolicy> = 2;
inline constexpr EnumArray<SidesPolicy, std::string_view> sides_policy_names = {"both", "front"};
constexpr std::string_view name(SidesPolicy which) { return sides_policy_names[which]; }

struct MotionPolicy {
  StartPolicy start = StartPolicy::reported;
  StillPolicy still = StillPolicy::reported;
  SidesPolicy sides = SidesPolicy::both;
  bool operator==(const MotionPolicy&) const = default;
};

// The full answer of a kernel to a batch: the comparison bits, for each comparison a column of each computed side, and
// a column of each measure that it gives.
template <class Real>
struct Answers {
  std::vector<ComparisonBits> bits;
  std::vector<std::vector<Real>> lhs, rhs;
  std::vector<std::vector<Real>> measures;

  void resize(std::size_t queries, std::size_t comparisons, std::size_t measure_count = 0) {
    bits.resize(queries);
    lhs.resize(comparisons);
    rhs.resize(comparisons);
    measures.resize(measure_count);
    for (auto* columns : {&lhs, &rhs, &measures}) {
      for (std::vector<Real>& column : *columns) column.resize(queries);
    }
  }
};

// One kernel in one precision on one instruction set. The functions are total: they take any bits, do not trap and do
// not allocate.
template <class Real>
struct Implementation {
  // Verdicts only; `out` has batch.size entries. A verdict is `separated` or `contact`, or from a filter `undecided`;
  // only some kernels check for invalid input and answer `invalid`.
  std::function<void(const QueryColumns<Real>& batch, Verdict* out)> verdicts;
  // Comparison bits and computed sides; `out` is sized to the batch. Empty for a kernel that shows only verdicts.
  std::function<void(const QueryColumns<Real>& batch, Answers<Real>& out)> explain = {};
  // For a kernel that is not built in: these and its measures at once, computed again in other arrangements and
  // supervised. Adds what is found; a query that got no answer is `unanswered`. Empty for a built-in kernel.
  std::function<void(const QueryColumns<Real>& batch, Verdict* out, Answers<Real>& answers, Watched& watched)>
      supervised = {};
  // Verdicts, for a kernel that runs in another process; returns the time that the kernel itself took, in nanoseconds.
  // Empty for a built-in kernel.
  std::function<double(const QueryColumns<Real>& batch, Verdict* out)> timed = {};
  // The bits of `explain` alone. Empty where computing them alone is not faster.
  std::function<void(const QueryColumns<Real>& batch, ComparisonBits* out)> bits = {};
  // The first of the predicate's measures; `out.measures` has a column for each and is sized to the batch. A measure
  // has no meaning where the verdict is not one that it is given with. Empty for a kernel that gives none.
  std::function<void(const QueryColumns<Real>& batch, Answers<Real>& out)> measure = {};
  std::size_t comparisons = 0;    // of the kernel's predicate; Kernel::on sets this and the next
  std::size_t measure_count = 0;  // that the kernel gives
};

// The range in which a kernel promises to be right, bounds included; a bound of 0 means no limit. A wrong answer to a
// query outside the range fails no requirement.
// The bounds down to the radius are of predicates whose oracles have limits (Oracles::has_limits).
struct Limits {
  double least_coordinate = 0, greatest_coordinate = 0;  // bounds of |x| over the coordinates of A, B, C, P that are
                                                         // not zero
  double least_area = 0;                                 // area of the triangle
  double least_radius = 0, greatest_radius = 0;
  // A length: contact may be reported where the two are apart by at most this. Such a query is outside the range; one
  // in contact is not, and touching is answered as Kernel::touching says.
  double margin = 0;
  SidesPolicy sides = SidesPolicy::both;  // of a predicate without motions that has a triangle
  bool operator==(const Limits&) const = default;
  bool any() const { return *this != Limits{}; }
};

// The instruction sets that a kernel can run on, best first. `scalar` is the reference itself; the others have
// Highway's names.
std::vector<std::string> available_targets();
inline constexpr std::string_view scalar_target = "scalar";
// The name as `available_targets` spells it (any case is accepted; `auto` is the best). Throws Error that lists the
// targets.
std::string resolve_target(std::string_view name);
bool same_letters(std::string_view a, std::string_view b);  // compares without regard to case

// How a kernel is called where the plan does not decide that (kernel/registry/called.h).
struct Call {
  std::string target = {};                // run on this instruction set only; empty: on the one that is asked for
  Rounding rounding = Rounding::nearest;  // the caller's modes
  bool flush = false;
  bool operator==(const Call&) const = default;
  bool has_modes() const { return rounding != Rounding::nearest || flush; }
};

// The parts of an answer that a kernel shows besides its verdict. Each value includes the one before.
enum class Exposure : std::uint8_t { verdict, comparisons, sides };
template <>
inline constexpr std::size_t enum_count<Exposure> = 3;
inline constexpr EnumArray<Exposure, std::string_view> exposure_names = {"verdict", "comparisons", "sides"};
constexpr std::string_view name(Exposure which) { return exposure_names[which]; }

// What the theory proves of a built-in kernel's verdicts.
enum class ProvedProperty : std::uint8_t { nothing, no_missed_contact, no_wrong_verdict };

struct Kernel {
  std::string id;
  std::string summary;                   // one line
  const Predicate* predicate = nullptr;  // never null in a kernel that is asked
  std::size_t entry = 0;  // index among the predicate's entries: the form in which the kernel takes the numbers
  // The kernel claims to compute these formulae, by their name among those of its predicate (Oracles::formulae of
  // exact/), with these side comparisons, in this arithmetic. Empty: none, and only its verdicts are judged.
  std::string formulae = {};
  Strictness strictness = Strictness::strict;
  Arithmetic arithmetic = Arithmetic::plain;
  Exposure exposes = Exposure::sides;
  std::size_t measure_count = 0;  // it gives so many of the predicate's measures, from the first on
  // Empty where the kernel does not exist in that precision. A kernel that has only one form runs it on every target.
  std::function<Implementation<float>(std::string_view target)> binary32;
  std::function<Implementation<double>(std::string_view target)> binary64;
  bool has_simd = false;     // uses different instructions on different targets
  bool is_reference = true;  // claims the scalar reference's bits and sides, bit for bit; a kernel that does not is not
                             // compared with the reference
  ProvedProperty proved = ProvedProperty::nothing;
  std::string_view proof = {};    // where that holds, by what, and what is argued besides; for a certificate
  bool takes_arithmetic = false;  // may be the rung in RUNG+ARITHMETIC
  TouchingPolicy touching = TouchingPolicy::contact;
  Limits limits = {};
  MotionPolicy motion = {};  // of a predicate of motions
  bool may_decline = false;  // `undecided` is an answer that it may give; else one more fault
  Call call = {};
  std::string file = {};           // path of a plug-in
  std::string declared_name = {};  // of a plug-in: its own name for its first kernel; empty: built in, or not loaded
  std::string source = {};         // of a plug-in: FILE:LINE among its author's sources; empty: unknown
  std::vector<Finding> findings = {};  // faults found when it was loaded, independent of any query

  template <class Real>
  Implementation<Real> on(std::string_view target) const {
    const auto begin = [&](const auto& implementation) {
      Implementation<Real> begun = implementation ? implementation(target) : Implementation<Real>{};
      begun.comparisons = predicate->comparisons.size();
      begun.measure_count = measure_count;
      return begun;
    };
    if constexpr (sizeof(Real) == 4) return begin(binary32);
    else return begin(binary64);
  }
  bool has(Precision precision) const {
    return precision == Precision::binary32 ? binary32 != nullptr : binary64 != nullptr;
  }
};

// Whether it claims the bits of a reference, by which the cause of a wrong verdict is told.
inline bool has_reference(const Kernel& kernel) { return kernel.is_reference && !kernel.formulae.empty(); }
// Whether the formulae that it claims have comparisons.
bool has_comparisons(const Kernel& kernel);

// The name as ids spell it: Arithmetic::dot_yz_x is "dot-yz-x".
std::string name(Arithmetic arithmetic);

// Name and description of an arithmetic; see arithmetic_list.h.
struct ArithmeticInfo {
  std::string name, summary;
  Arithmetic arithmetic;
  bool in_binary32, in_binary64;
  Exposure exposes;
};
const std::vector<ArithmeticInfo>& arithmetics();

// The kernels of the registry.
std::span<const Kernel> kernels();
// The kernel with this id: one of kernels(); RUNG+ARITHMETIC, the scalar form of a rung in one of arithmetics(); either
// of these with @CALL (kernel/registry/called.h); plugin:PATH for a plug-in (kernel/include/axiscert/plugin.h),
// peer/NAME or fault/NAME for one that comes with axiscert. Throws Error that lists the kernels. The reference stays
// valid for the life of the program.
const Kernel& find_kernel(std::string_view id);

// Kernels that the program itself has, as functions: find_kernel() finds them by their ids.

// From here on the kernel is found by its id, in place of one that was given before with the same. References to that
// one stay valid: all do for the life of the program. Throws Error where the id is that of a kernel of the registry.
const Kernel& give_kernel(Kernel kernel);
// Null where none was given.
const Kernel* given_kernel(std::string_view id);

}  // namespace axiscert
