// The campaign: runs a plan's units on all cores and tallies them.
#pragma once

#include <atomic>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "exact/judge/batch_oracle.h"
#include "fuzz/campaign/progress.h"
#include "fuzz/files/streams.h"
#include "fuzz/queries/source.h"
#include "fuzz/record/tally.h"
#include "kernel/kernel.h"

namespace axiscert {
// The queries of a campaign: their sources, precisions and numbers.
struct Questions {
  std::uint64_t seed = 1;
  std::vector<SourcePtr> sources;
  std::vector<Precision> precisions;
  std::vector<Precision> idle;  // others, in which no kernel exists: lines of files in them are not asked
  // How many queries a source has in a precision, where the plan cannot choose.
  std::function<std::optional<std::uint64_t>(const Source&, Precision)> fixed_size = &Source::fixed_size;
  // How many otherwise; not read under a time limit.
  std::function<std::uint64_t(const Source&, Precision)> trials;
  std::optional<double> seconds;  // time limit; units that were begun are finished

  // That of all sources; there is one.
  const Predicate& predicate() const { return sources.front()->predicate(); }
};

// Who answers: kernels of the questions' predicate.
struct Answerers {
  std::vector<const Kernel*> kernels;
  std::vector<FileInfo> plugins;  // the files of kernels that were given by path, as they were loaded
  // The answers of the one kernel, in place of running it; the questions are those that have one.
  std::shared_ptr<const StoredReplies> replies;
  ReplyClaim claim;  // of the replies
};

// How the answers are judged.
struct JudgingOptions {
  Tolerances tolerances;
  std::map<std::string, std::string> tolerance_texts;  // by comparison, as given
  // Everything by CGAL, arbitrary precision and MPFR: the record is the same.
  bool exact_only = false;
  FilterFault planted = FilterFault::none;  // for the tests of the cross-checks
};

// On what it runs; no result depends on it.
struct RunningOptions {
  std::string target;  // resolved
  int threads = 1;
};

struct Plan {
  Questions questions;
  Answerers answerers;
  JudgingOptions judging;
  RunningOptions running;
};

// How the queries of a cell were decided; no record holds it.
struct StepCounts {
  EnumArray<Step, std::uint64_t> queries{};
  std::vector<EnumArray<Step, std::uint64_t>> signs = {};  // by comparison; empty without filters
  std::uint64_t checked = 0;                               // decided by a filter, and by CGAL again
  std::uint64_t by_cgal = 0;                               // verdicts of filtered predicates that CGAL decided
  // Nanoseconds.
  double generation = 0, kernels = 0, errors = 0, judging = 0;
  EnumArray<Step, double> steps{};  // of the filters; `exact` is part of judging

  void merge(const StepCounts& other);
  AXISCERT_FIELDS(StepCounts, journalled(&Of::queries), journalled(&Of::signs), journalled(&Of::checked),
                  journalled(&Of::by_cgal), journalled(&Of::generation, by::added), journalled(&Of::kernels, by::added),
                  journalled(&Of::errors, by::added), journalled(&Of::judging, by::added),
                  journalled(&Of::steps, by::added))
};

// One source in one precision.
struct CellResult {
  std::size_t source;
  Precision precision;
  std::uint64_t units_done = 0, queries = 0;
  double core_seconds = 0;     // processor time of generating and judging
  std::vector<Tally> tallies;  // by kernel, in the plan's order
  StepCounts steps;
};

struct CampaignResult {
  bool complete = true;  // false: interrupted
  std::vector<CellResult> cells;
  std::uint64_t second_opinions = 0;  // queries decided a second time by MPFR
};

// Every 4096th query of a source is decided again by the second oracle; for every 256th of its first 2^24 the critical
// radius is found. Their errors are kept, for an exact median, and are all that a tally keeps of more than a few
// queries: the limit bounds it at 2^16 numbers, however long a run lasts.
inline constexpr std::uint64_t second_opinion_stride = 4096, critical_radius_stride = 256;
inline constexpr std::uint64_t critical_radius_queries = std::uint64_t{1} << 24;
constexpr bool has_critical_radius(std::uint64_t position) {
  return position < critical_radius_queries && position % critical_radius_stride == 0;
}

// The targets that have to pass the self-check: the scalar reference, the given one, and those on which a kernel is
// called.
std::set<std::string> targets_of(const std::vector<const Kernel*>& kernels, const std::string& target);

// `interrupted` is polled between units; `report` may be empty. The tallies depend on the plan alone, not on threads,
// target or order. Throws OracleDisagreement.
CampaignResult run_campaign(const Plan& plan, const std::atomic<bool>& interrupted, const ShowProgress& report);

// One unit: 2^16 queries of one source and precision, generated, answered by every kernel, judged and tallied.

// How many queries a kernel is asked at once: queries, sides and signs of a batch stay in the first-level cache, or the
// second. Odd, so that a vector kernel of any width is left with queries that fill no whole vector, in every batch and
// in the last of a unit, which has 25: what it does with those is judged too.
inline constexpr std::size_t batch_size = 251;
// Another process is asked seldom.
inline constexpr std::size_t batch_size_for_processes = 1024;

struct UnitResult {
  std::vector<Tally> tallies;  // by kernel
  double core_seconds = 0;
  std::uint64_t second_opinions = 0;
  StepCounts steps;
};

// Told the size of each batch that is done with; may be empty.
using BatchDone = std::function<void(std::uint64_t queries)>;

// The first `size` queries of unit `number`. What other units of the cell have found, by kernel, saves evaluating what
// can be no maximum; it may be empty. Merged with their tallies the result depends on the other arguments only, but for
// the times.
UnitResult run_unit(const Plan& plan, const Source& source, Precision precision, std::uint64_t number,
                    std::uint64_t size, const std::vector<StandingLeaders>& standing = {}, const BatchDone& asked = {});

// The cells of the questions, with nothing done, for so many kernels: binary64 first, whose units take longest, and the
// last ones decide how long the cores wait for each other.
std::vector<CellResult> cells_of(const Questions& questions, std::size_t kernels);

}  // namespace axiscert
