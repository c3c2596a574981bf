// The oracles of one predicate, as code that serves every predicate sees them.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "exact/judge/depth.h"
#include "exact/judge/judge.h"
#include "exact/judge/contact_judgement.h"
#include "exact/numbers/rational.h"
#include "exact/judge/batch_oracle.h"
#include "exact/judge/exact_sides.h"
#include "kernel/kernel.h"

namespace axiscert {

// The signs of formulae in exact arithmetic, by comparison: those that hold, and those with lhs == rhs.
struct ExactSigns {
  ComparisonBits holds = 0, ties = 0;
};

// A fact about a query besides its truth: a number of the query's precision, a word, a list of names, or, where the
// query has none, nothing.
struct Detail {
  std::string_view name;
  std::variant<std::monostate, double, std::string_view, std::vector<std::string_view>> value;
};

// A length in each query that turns the answer: separated below its critical value, contact from that on. It is the
// radius of a sphere, or a half extent of a box.
struct CriticalLength {
  std::size_t column;
  // The square of the critical value, exact, of finite numbers; the length is not read. Empty for what is no query with
  // any length, or has contact at none.
  std::optional<Rational> (*squared)(const Numbers<double>& query);
  std::optional<std::size_t> centre = {};  // the first column of the centre of the sphere whose radius it is
};

// The distance that a predicate compares, squared, and the one up to which there is contact: two bodies, 0; a centre
// and the radius around it.
struct Distance {
  Rational squared, reach;
};
// Whether the two are apart, and by at most this length: a kernel with such a margin may say either.
bool is_within_margin(const Distance& distance, double margin);

// By what a query is decided.
enum class Opinion : std::uint8_t {
  first,
  second,      // another arithmetic repeats the decisions of the truth, where the predicate has one
  exact_only,  // that, and no filter or enclosure takes part in anything: the answers are the same
};

// One query of which more than one thing is asked: what two answers need is evaluated once. Each member throws
// OracleDisagreement where two ways of finding one answer differ. One thread asks, while the oracles exist.
class AskedQuery {
 public:
  virtual ~AskedQuery() = default;
  // This kernel's claim will be asked: what the truth evaluates of it is then kept.
  virtual void expect(const Kernel&) {}
  // By geometry and by the exact formulae, compared.
  virtual Truth truth() = 0;
  // The rest is asked of a valid query alone. What a kernel's claim comes to, level by level; empty for a kernel that
  // claims no formulae. Throws HarnessFault if it claims formulae that are not among Oracles::formulae().
  virtual std::optional<Reference> chain(const Kernel& kernel) = 0;
  // The exact sides of its formulae; null where it claims none, or some without comparisons. Good as long as this.
  virtual const ExactSides* sides(const Kernel& kernel) = 0;
  // (lhs - rhs) / (|lhs| + |rhs|) of these sides, for these comparisons in their order; if lhs is a root, the same with
  // the signed squares of the sides. 0 where both are 0, or undefined. Empty for a kernel that claims no comparisons.
  std::vector<Rational> relative_margins(const Kernel& kernel, ComparisonBits comparisons);
  virtual DepthOf& depth() = 0;

  // All that follow are empty where the predicate does not tell them.
  // The signs of the formulae that the predicate publishes, with strict relations, whatever a kernel claims.
  virtual std::optional<ExactSigns> published_signs() { return std::nullopt; }
  // The square of the distance that the predicate compares.
  virtual std::optional<Rational> squared_distance() { return std::nullopt; }
  // The depth before it is rounded.
  virtual std::optional<ExactDepth> exact_depth() { return std::nullopt; }
};

// Stateless: any thread may ask at any time. `numbers` are of one entry of the predicate, whose oracles these are. Each
// member throws OracleDisagreement where two ways of finding one answer differ.
class Oracles {
 public:
  virtual ~Oracles() = default;
  virtual const Predicate& predicate() const = 0;
  // Whether the numbers are a query: the truth of others is `invalid`.
  virtual bool is_valid(const Numbers<float>& numbers) const = 0;
  virtual bool is_valid(const Numbers<double>& numbers) const = 0;
  // The reason for which numbers whose truth is `invalid` are no query; empty where the predicate says none.
  virtual std::string why_invalid(const Numbers<float>&) const { return {}; }
  virtual std::string why_invalid(const Numbers<double>&) const { return {}; }
  // The names of the formulae that a kernel can claim.
  virtual std::vector<std::string_view> formulae() const = 0;
  // Whether batches() decides nearly all queries by filters, at a hundredth of the cost of exact arithmetic.
  virtual bool has_filters() const { return false; }

  // The truths of batches, by filters on this instruction set where the predicate has them.
  virtual std::unique_ptr<BatchOracle<float>> batches(std::string_view target, std::type_identity<float>) const;
  virtual std::unique_ptr<BatchOracle<double>> batches(std::string_view target, std::type_identity<double>) const;

  // The query, to be asked more than once. Another arithmetic repeats the decisions of the truth where the predicate
  // has a second oracle and `opinion` says so.
  virtual std::unique_ptr<AskedQuery> about(const Numbers<float>& numbers, Opinion opinion = Opinion::second) const = 0;
  virtual std::unique_ptr<AskedQuery> about(const Numbers<double>& numbers,
                                            Opinion opinion = Opinion::second) const = 0;
  // The same, asked once.
  Truth truth(const Numbers<float>& numbers) const { return about(numbers)->truth(); }
  Truth truth(const Numbers<double>& numbers) const { return about(numbers)->truth(); }
  // The verdict that no right method of the precision can miss (exact/judge/clear.h); empty where the numbers are no
  // clear query, and in a predicate that has no such notion. It asks no exact arithmetic.
  virtual std::optional<Verdict> clear_verdict(const Numbers<float>&) const { return std::nullopt; }
  virtual std::optional<Verdict> clear_verdict(const Numbers<double>&) const { return std::nullopt; }
  virtual bool has_depth() const = 0;
  // The distance of a valid query from touching, relative to its scene and rounded once; empty if the predicate has
  // none.
  virtual std::optional<double> depth(const Numbers<float>& numbers) const = 0;
  virtual std::optional<double> depth(const Numbers<double>& numbers) const = 0;
  // The verdict of numbers whose depth exceeds this; empty on any others. By the rounded depth, or exactly where the
  // predicate has quick bounds of it.
  virtual std::optional<Verdict> verdict_beyond(double depth, const Numbers<float>& numbers) const;
  virtual std::optional<Verdict> verdict_beyond(double depth, const Numbers<double>& numbers) const;
  // Whether the predicate compares a distance: then AskedQuery tells its square and the published signs.
  virtual bool has_squared_distance() const { return false; }

  // Empty where the answer depends on no length in this way.
  virtual std::optional<CriticalLength> critical_length() const { return std::nullopt; }
  // Whether the shape of finite numbers is so extreme that a kernel may be wrong there by its formulae alone, by as
  // much as the scene is large. `false` where the predicate has no such notion.
  virtual bool is_degenerate(const Numbers<float>&) const { return false; }
  virtual bool is_degenerate(const Numbers<double>&) const { return false; }

  // Facts about a valid query besides its truth, in the order in which `check` shows them; most predicates have none.
  virtual std::vector<Detail> details(const Numbers<float>&) const { return {}; }
  virtual std::vector<Detail> details(const Numbers<double>&) const { return {}; }
  // Their names, in the same order, whatever the query.
  virtual std::vector<std::string_view> detail_names() const { return {}; }

  // Whether kernels of the predicate can promise to be right within bounds of coordinates, area and radius; else every
  // query is within these. A margin, and the sides of a triangle, are limits of any predicate that has a distance, or a
  // front.
  virtual bool has_limits() const { return false; }
  // Whether a valid query lies within a kernel's limits, and whether a kernel with this policy promises to be right on
  // it. A predicate has one of the two, or neither.
  virtual bool is_within(const Limits&, const Numbers<float>&) const { return true; }
  virtual bool is_within(const Limits&, const Numbers<double>&) const { return true; }
  virtual bool is_promised(const MotionPolicy&, const Numbers<float>&) const { return true; }
  virtual bool is_promised(const MotionPolicy&, const Numbers<double>&) const { return true; }

  // The judge of kernels' measures on a valid query, of motions on one that has contact; null for a predicate without
  // measures that are judged.
  virtual std::unique_ptr<ContactJudge> contact_judge(const Numbers<float>&) const { return nullptr; }
  virtual std::unique_ptr<ContactJudge> contact_judge(const Numbers<double>&) const { return nullptr; }
};

template <class Real>
std::unique_ptr<BatchOracle<Real>> batches_of(const Oracles& oracles, std::string_view target) {
  return oracles.batches(target, std::type_identity<Real>());
}

// Those of an entry; where none is named, of the first. They throw HarnessFault if they are given numbers of another.
const Oracles& oracles_of(const Predicate& predicate, std::size_t entry = 0);
inline const Oracles& oracles_of(const Kernel& kernel) { return oracles_of(*kernel.predicate, kernel.entry); }

// Whether what a kernel says beside its verdicts is judged: its measures, and of motions its missed contacts.
inline bool says_contacts(const Kernel& kernel) {
  return kernel.measure_count != 0 || is_of_motions(*kernel.predicate);
}
// Whether the measures beside this verdict are judged, on a valid query: of motions, where the query has contact and
// touching is contact for the kernel. `truth` is asked of motions alone, which have no filters.
template <class TruthOf>
bool has_judged_contact(const Kernel& kernel, Verdict said, TruthOf&& truth) {
  if (said != Verdict::contact && said != Verdict::separated) return false;
  if (is_of_motions(*kernel.predicate)) return right_verdict(truth(), kernel.touching) == Verdict::contact;
  return kernel.measure_count != 0;
}

// Whether a kernel with these limits and this policy promises to be right on a valid query of the oracles' predicate.
template <class Real>
bool is_promised(const Oracles& oracles, const Limits& limits, const MotionPolicy& motion, const Numbers<Real>& q) {
  return (!limits.any() || oracles.is_within(limits, q)) &&
         (motion == MotionPolicy{} || oracles.is_promised(motion, q));
}
// Whether this kernel does.
template <class Real>
bool is_promised(const Kernel& kernel, const Numbers<Real>& q) {
  return is_promised(oracles_of(kernel), kernel.limits, kernel.motion, q);
}

}  // namespace axiscert
