// The judge: compares a kernel's answer to one query with the truth and attributes each difference to a link of the
// chain.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/base/enums.h"
#include "kernel/base/error.h"
#include "kernel/outcome.h"
#include "kernel/predicate.h"
#include "kernel/query.h"

namespace axiscert {
// The truth about one query, as far as the judge needs it, and the error that ends a run when two oracles differ.

struct Truth {
  Verdict verdict;  // separated, contact (touching included) or invalid
  bool touching;    // distance exactly r
};

// Two oracles differ, or one contradicts the theorem. Carries the query so that it can be saved (a float widens
// exactly): the numbers of this entry of `of`.
struct OracleDisagreement : HarnessFault {
  template <class Real>
  OracleDisagreement(const std::string& what, const Numbers<Real>& q, const Predicate& of, std::size_t of_entry = 0)
      : HarnessFault("the oracles disagree: " + what),
        predicate(&of),
        entry(of_entry),
        precision(precision_of<Real>),
        query(q.begin(), q.end()) {}
  const Predicate* predicate;
  std::size_t entry;
  Precision precision;
  std::vector<double> query;
};

// The links of the chain G -> E -> R-infinity -> R -> K, and `unattributed` for a kernel without a reference.
enum class Link : std::uint8_t { specification, rounding, range, implementation, unattributed };
template <>
inline constexpr std::size_t enum_count<Link> = 5;
inline constexpr std::size_t link_count = enum_count<Link>;
inline constexpr EnumArray<Link, std::string_view> link_names = {"specification", "rounding", "range", "implementation",
                                                                 "unattributed"};
constexpr std::string_view name(Link which) { return link_names[which]; }
using LinkSet = EnumSet<Link, std::uint8_t>;
std::vector<std::string_view> names(LinkSet links);

// An axis is a clause, in the word of the predicates by separating axes.
enum class Level : std::uint8_t { verdict, axis, comparison };
template <>
inline constexpr std::size_t enum_count<Level> = 3;
inline constexpr EnumArray<Level, std::string_view> level_names = {"verdict", "axis", "comparison"};
constexpr std::string_view name(Level which) { return level_names[which]; }

// `false_separation` exists at every level: the kernel wrongly says yes. Its opposite is `false_contact` for a verdict
// and `missed_separation` for an axis or a comparison.
enum class FlipKind : std::uint8_t { false_separation, false_contact, missed_separation };
template <>
inline constexpr std::size_t enum_count<FlipKind> = 3;
inline constexpr EnumArray<FlipKind, std::string_view> flip_kind_names = {"false_separation", "false_contact",
                                                                          "missed_separation"};
constexpr std::string_view name(FlipKind which) { return flip_kind_names[which]; }

struct Flip {
  Level level;
  std::uint8_t index;  // index of the clause or comparison; 0 for the verdict
  FlipKind kind;
  bool decisive;
  LinkSet links;
};
std::string_view name(const Predicate& predicate, const Flip& flip);  // "verdict", "edge_ab", "edge_ab.radius"

// A kernel's answer: its verdict and, if it exposes them, its comparison bits.
using Answer = Outcome;

// The decisions of formulae as rounded: with an exponent without limits (R-infinity), and as the scalar reference
// computes them (R).
struct RoundedDecisions {
  Outcome range_free, reference;
};

// The decisions of the formulae that a kernel claims, along the chain E -> R-infinity -> R; verdicts alone for a
// method, which has no comparisons. Without `rounded` the kernel evaluates the formulae in its own way, and differences
// from E are `unattributed`.
struct Reference {
  Outcome exact;
  std::optional<RoundedDecisions> rounded;
  ComparisonBits ties = 0;  // ties of the exact formulae: lhs == rhs
};

struct Judgement {
  std::optional<Verdict> right_of_decided;  // right_verdict() of an answer that is one of the two
  std::optional<FlipKind> verdict_flip;     // against that; empty if the truth is `invalid`
  LinkSet verdict_links;                    // links broken on the way, whether the verdict is wrong or right
  ComparisonBits comparison_flips = 0, comparison_decisive = 0;  // decisive is a subset of flips
  ClauseBits axis_flips = 0, axis_decisive = 0;
  std::vector<Flip> flips() const;  // in the order verdict, axes, comparisons
  // Visits the same flips in the same order.
  template <class Visit>
  void for_each_flip(Visit&& visit) const;

  std::optional<ComparisonBits> exact;       // the kernel's own formulae in exact arithmetic
  ClauseBits exact_axes = 0;                 // the clauses that hold by them
  EnumArray<Link, ComparisonBits> broken{};  // for each link, the comparisons at which it is broken
  EnumArray<Link, ClauseBits> broken_axes{};
};

// The right verdict on a valid query for a kernel with this convention; empty if neither answer is wrong.
std::optional<Verdict> right_verdict(const Truth& truth, TouchingPolicy touching);

// `reference` is empty for a kernel that claims no formulae: then only its verdict is judged. If the truth is `invalid`
// or there is no answer, there is no flip.
//
// On a touching query a kernel is judged by its own convention, and so are formulae that it evaluates in its own way.
// The two touch where a comparison of PredicateComparison::ties_at_touching (sphere-triangle's: of a radius) is a tie,
// and a convention can only mean the relation, `>` or `>=`, that this comparison uses: with `separated`, such ties
// hold; with `either`, they are as the kernel has them, and no link is broken. Otherwise each right answer would break
// links, and each rounding at a tie would count as a fault of the specification. On any other query the formulae are
// taken as named: a `>=` that also separates a zero-area triangle by 0 >= 0 is a fault. A bit-for-bit reference has a
// fixed relation, so a convention other than `contact` contradicts the formulae of such a kernel: `specification`.
Judgement judge(const Predicate& predicate, const Truth& truth, const std::optional<Reference>& reference,
                const Answer& answer, TouchingPolicy touching = TouchingPolicy::contact);

template <class Visit>
void Judgement::for_each_flip(Visit&& visit) const {
  if (verdict_flip) visit(Flip{Level::verdict, 0, *verdict_flip, true, verdict_links});
  const auto each = [&](Level level, std::uint64_t flips, std::uint64_t decisive, std::uint64_t exact_bits,
                        const auto& broken_at) {
    for_each_bit(flips, [&](std::size_t i) {
      LinkSet links;
      for (const Link link : enumerators<Link>) {
        if (has_bit(broken_at[link], i)) links.insert(link);
      }
      const FlipKind kind = has_bit(exact_bits, i) ? FlipKind::missed_separation : FlipKind::false_separation;
      visit(Flip{level, static_cast<std::uint8_t>(i), kind, has_bit(decisive, i), links});
    });
  };
  each(Level::axis, axis_flips, axis_decisive, exact_axes, broken_axes);
  each(Level::comparison, comparison_flips, comparison_decisive, exact.value_or(0), broken);
}

}  // namespace axiscert
