// The search: islands that climb toward the worst queries for a kernel, on all cores, and their results, confirmed
// exactly.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "exact/numbers/rational.h"
#include "exact/judge/judge.h"
#include "fuzz/record/looked_at.h"
#include "fuzz/search/method.h"
#include "fuzz/files/query_file.h"
#include "fuzz/queries/source.h"
#include "kernel/kernel.h"

namespace axiscert {

inline constexpr std::string_view verdict_word = "verdict";

struct SearchPlan {
  const Kernel* kernel;
  Precision precision = Precision::binary32;
  std::vector<std::size_t> comparisons;  // of the kernel's predicate; empty: all, and the verdict and the numbers
  std::vector<std::string> what =
      {};  // `verdict_word`, with what a method has beside it, and words of measures' faults; empty: all
  std::vector<SourcePtr> sources;  // families that islands start from
  std::uint64_t seed = 1;
  // A search without an island so far begins with a run of so many queries of each of these sources, which are not
  // counted as evaluations, and reports nothing less severe than that run found; 0: with none.
  std::vector<SourcePtr> first_sources;
  std::uint64_t first_queries = 0;
  // Stops at the first island that reaches this total, including earlier runs, or after this time, counting this run
  // only, of which one island is always done: however short the time, a run gets further.
  std::optional<std::uint64_t> evaluations;
  std::optional<double> seconds;
  std::string target;  // resolved
  int threads = 1;
};

// The result for one aim. Its query shows it when asked again: for a goal of range, the scene is already scaled.
struct Find {
  Aim aim;
  Decimal6 value;  // not used for a goal of range
  StoredQuery witness;
  LinkSet links = {};      // for a wrong verdict
  int range_exponent = 0;  // for a goal of range: m
  bool operator==(const Find& other) const {
    return aim == other.aim && value == other.value && query_line(witness) == query_line(other.witness) &&
           links == other.links && range_exponent == other.range_exponent;
  }
};

struct SearchResult {
  bool complete = true;  // false: interrupted
  std::uint64_t evaluations = 0;
  std::vector<Aim> aims;
  std::vector<Find> finds;  // in the order of the aims; an aim without a result is left out
  // By aim, the queries that were evaluated for it; they may be a few less than its islands' shares.
  std::vector<LookedAt> looked_at;
  // By aim, those with what it is about, where is_about_a_part(); of a number those of `begun` too.
  std::vector<std::uint64_t> judged;
  LookedAt begun;     // the queries of the run from which the search began
  std::string state;  // from which a later run continues

  // The queries that could have shown aim i.
  std::uint64_t seen(std::size_t i) const { return is_about_a_part(aims[i].goal) ? judged[i] : looked_at[i].decided; }
  LookedAt evaluated() const {  // for any aim
    LookedAt all;
    for (const LookedAt& of_aim : looked_at) merge_fields(all, of_aim);
    return all;
  }
};

struct SearchProgress {
  std::uint64_t islands, evaluations;
  double seconds;
};

// Continues from `state`, whose plan has to be the same except for its length, or begins anew. The result depends on
// the plan and on the number of evaluations reached, not on threads, target, or where a run was stopped and resumed.
// `interrupted` is polled between islands; `report` is called from one thread at a time. Throws Error if the state is
// of another plan, and OracleDisagreement.
SearchResult search(const SearchPlan& plan, const std::optional<std::string>& state,
                    const std::atomic<bool>& interrupted, const std::function<void(const SearchProgress&)>& report);

}  // namespace axiscert
