// The safe margin of a kernel: by how much r has to grow so that it misses none of the contacts that it was seen to
// miss, and how many phantom contacts that makes.
#pragma once

#include <atomic>
#include <compare>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "exact/judge/oracles.h"
#include "exact/numbers/rational.h"
#include "fuzz/campaign/campaign.h"
#include "fuzz/files/query_file.h"
#include "fuzz/record/looked_at.h"
#include "kernel/predicate.h"
#include "kernel/query.h"

namespace axiscert {
// The scenes that margins of r are told apart by: their size, and whether the triangle is one to measure a kernel by.

// The queries of one margin: 10^decade <= size < 10^(decade + 1), where the size is the greatest of r and the
// coordinates of all points as seen from the sphere's centre. A size of 0 has the least decade.
struct MarginScene {
  bool is_degenerate = false;  // Oracles::is_degenerate: a kernel may miss there by its formulae alone
  int decade = 0;
  auto operator<=>(const MarginScene&) const = default;
};

// The columns of a predicate's first entry, as a scene is measured by them.
class SceneMeasure {
 public:
  explicit SceneMeasure(const Predicate& predicate);

  template <class Real>
  double size(const Numbers<Real>& query) const;
  // Precondition: every number is finite.
  template <class Real>
  MarginScene of(const Numbers<Real>& query) const;

 private:
  const Oracles& oracles_;
  const std::vector<PredicateColumn>& columns_;
  std::vector<std::optional<std::size_t>> centre_;  // the column of the centre from which a column's number is seen
};

struct SafeMarginPlan {
  const Questions* asked;  // of a run: its sources and seed; their predicate has a sphere's radius
  const RunningOptions* on;
  const Kernel* kernel;  // of that predicate, in the first entry
  Precision precision = Precision::binary32;
  // How many of the source's queries were run: those from the first on.
  std::function<std::uint64_t(const Source&)> queries;
  // For so many queries of each source the kernel is asked, besides, at the least radius that is a contact.
  std::uint64_t probes = 0;
  std::vector<StoredQuery> found;  // of a search, in this precision
};

// A contact that the kernel misses, and the growth that mends it. Its radius is that of the query file's line.
struct MissedContact {
  std::string query;             // a line of a query file, with the address as its id
  std::string family;            // "search" where a search found it
  std::string radius, critical;  // hexadecimal: r, and the least radius from r on for which the kernel says contact
  Decimal6 value;                // the factor critical / r, or the amount critical - r, rounded up

  void merge(const MissedContact& other) {
    if (other.value > value) *this = other;
  }
};

// Contacts that the kernel was asked about, by its answer: of one that it gave no verdict to nothing is known.
struct ContactAnswers {
  LookedAt looked_at = {};   // all of them promised
  std::uint64_t missed = 0;  // of the decided ones, those called separated

  std::uint64_t asked() const { return looked_at.promised(); }
  std::uint64_t without_verdict() const { return looked_at.promised() - looked_at.decided; }
  void add(Verdict said) {
    looked_at.add(said);
    missed += said == Verdict::separated;
  }
  static constexpr auto fields(auto&& visit) {
    return merged(visit, &ContactAnswers::looked_at, &ContactAnswers::missed);
  }
};

// The contacts of scenes of one size, with triangles of one kind.
struct MarginPart {
  std::uint64_t contacts = 0;         // asked about: of the run, probed and found
  std::uint64_t without_verdict = 0;  // of these, called neither contact nor separated
  std::uint64_t queries = 0;          // valid, and within what the kernel promises
  std::uint64_t missed = 0;           // contacts called separated: of the run, probed and found
  std::uint64_t hopeless = 0;         // of these, missed up to twice the scene's size: the sphere holds the triangle
  std::uint64_t tiny = 0;             // of the rest, those whose r is tiny, or 0: these have an amount, and no factor
  std::uint64_t unmeasured = 0;       // the kernel did not answer at some radius, or its radius is the query's own
  std::optional<MissedContact> factor = {}, amount = {};  // the greatest
  // The run's queries asked again, each grown by the factor, and by the amount, of its part.
  std::uint64_t phantoms_by_factor = 0, phantoms_by_amount = 0;          // new ones
  std::uint64_t still_missed_by_factor = 0, still_missed_by_amount = 0;  // all the same: the hopeless among them

  static constexpr auto fields(auto&& visit) {
    using Of = MarginPart;
    return merged(visit, &Of::contacts, &Of::without_verdict, &Of::queries, &Of::missed, &Of::hopeless, &Of::tiny,
                  &Of::unmeasured, &Of::factor, &Of::amount, &Of::phantoms_by_factor, &Of::phantoms_by_amount,
                  &Of::still_missed_by_factor, &Of::still_missed_by_amount);
  }
};

struct SafeMargin {
  Precision precision = Precision::binary32;
  std::uint64_t queries = 0, probed = 0, found = 0;  // asked: of the run, at the least radius, of a search
  ContactAnswers of_run = {}, of_others = {};        // others: at the least radius, and of a search
  std::map<MarginScene, MarginPart> parts = {};
  std::optional<MissedContact> factor = {}, amount = {}, hopeless = {};  // over all parts; of the hopeless the first
  std::uint64_t phantoms = 0;                                            // of the run's queries, before any growth
  bool complete = true;                                                  // false: interrupted

  MarginPart total() const;  // counts added, without the greatest
  // In the order of the queries.
  static constexpr auto fields(auto&& visit) {
    using Of = SafeMargin;
    return merged(visit, journalled(&Of::precision, by::same), &Of::queries, &Of::probed, &Of::found, &Of::of_run,
                  &Of::of_others, &Of::parts, &Of::factor, &Of::amount, journalled(&Of::hopeless, by::first),
                  &Of::phantoms, journalled(&Of::complete, by::same));
  }
};

// A radius below 2^-k of its scene's size is tiny. Its square is then below one rounding of a squared length of that
// scene, so the quotient of the radius that the kernel needs and of this one says how small r is, not what the kernel
// is like: 1e38 for an r of 1e-38 in a scene of size 1.
inline constexpr EnumArray<Precision, int> tiny_radius_exponent = {12, 26};

// Whether the answer depends on the radius of a sphere, which may grow; the half extent of a box, which has a critical
// value too, is none.
bool has_sphere_radius(const Predicate& predicate, std::size_t entry);

// The least number of the precision that is not below `value`; the greatest finite one where none is.
template <class Real>
Real rounded_up_to(const Rational& value);

// Depends on the plan alone, not on its threads. `interrupted` is polled between blocks. Throws OracleDisagreement, and
// HarnessFault for a predicate without a critical length.
SafeMargin safe_margin(const SafeMarginPlan& plan, const std::atomic<bool>& interrupted, const ShowProgress& report);

}  // namespace axiscert
