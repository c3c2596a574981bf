#include "fuzz/search/search.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <mutex>

#include "fuzz/queries/image_groups.h"
#include "fuzz/search/pools.h"
#include "fuzz/search/confirm.h"
#include "fuzz/search/island.h"
#include "fuzz/search/method.h"
#include "fuzz/search/numbers.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

// One island: the aim it serves, and how long it climbs.
struct Slot {
  std::size_t aim;
  std::uint64_t evaluations;
};
// The islands of an epoch, with the aims in turn.
std::vector<Slot> slots_of(const std::vector<Aim>& aims, const SearchMethod& method) {
  std::vector<Slot> slots;
  for (std::size_t round = 0; round < most_islands; ++round) {
    for (std::size_t i = 0; i < aims.size(); ++i) {
      const IslandShare share = aims[i].goal == Goal::number ? number_share : method.share(aims[i]);
      if (round < share.islands) slots.push_back({i, share.evaluations});
    }
  }
  return slots;
}

bool is_asked(const SearchPlan& plan, std::string_view what) {
  return plan.what.empty() || std::ranges::find(plan.what, what) != plan.what.end();
}

// With comparisons alone nothing beside them, unless it is named.
std::vector<Aim> aims_of(const SearchPlan& plan, const SearchMethod& method) {
  std::vector<Aim> aims;
  if (is_asked(plan, verdict_word) || !plan.comparisons.empty()) aims = method.aims(*plan.kernel, plan.comparisons);
  if (plan.what.empty() && !plan.comparisons.empty()) return aims;
  for (const Aim& aim : number_aims(*plan.kernel)) {
    if (is_asked(plan, word(fault_of(aim)))) aims.push_back(aim);
  }
  return aims;
}

std::string why_no_aims(const SearchPlan& plan, const SearchMethod& method) {
  if (is_asked(plan, verdict_word)) return method.why_no_aims(*plan.kernel);
  return fmt::format("--what {}: the kernel {} gives no such number", fmt::join(plan.what, " --what "),
                     plan.kernel->id);
}

// patience: the number of epochs without a gain of a thousandth after which a lineage is abandoned. blending: one in
// this many new lineages begins with the best of all so far, which blends them; the others begin with nothing.
constexpr std::uint64_t patience = 4, blending = 3;
constexpr double least_gain = 1.001;

// The number of queries drawn from families, of which an island that starts with them takes the best.
constexpr std::size_t drawn = walkers * children;

// The queries known for one aim.
template <class Real>
struct KnownQueries {
  Pool<Real> lineage;  // the lineage from which islands start; constant during an epoch
  Pool<Real> fresh;    // queries found by the islands of the current epoch
  Pool<Real> best;     // best of all lineages
  std::uint64_t stalled = 0, restarts = 0;

  void end_epoch() {
    const double before = lineage.empty() ? 0 : lineage.best().value.value();
    lineage.put(fresh);
    fresh = {};
    if (lineage.empty()) return;
    best.put(lineage);
    stalled = lineage.best().value.value() > before * least_gain ? 0 : stalled + 1;
    if (stalled < patience) return;
    stalled = 0;
    lineage = ++restarts % blending == 0 ? best : Pool<Real>();
  }
};

template <class Real>
class Search {
 public:
  using Entry = typename Pool<Real>::Entry;

  explicit Search(const SearchPlan& plan)
      : plan_(plan),
        method_(search_method_of(*plan.kernel->predicate)),
        aims_(aims_of(plan, method_)),
        slots_(slots_of(aims_, method_)) {
    if (aims_.empty()) throw Error(why_no_aims(plan, method_));
    known_.resize(aims_.size());
    looked_at_.resize(aims_.size());
    judged_.resize(aims_.size());
  }

  void resume(const std::string& text) {
    const SearchState state = parse_state(text, plan_, aims_);
    islands_ = resumed_from_ = state.islands;
    evaluations_ = state.evaluations;
    looked_at_ = state.looked_at;
    judged_ = state.judged;
    begun_ = state.begun;
    Confirmer<Real> confirmer(*plan_.kernel, plan_.target);
    for (std::size_t i = 0; i < aims_.size(); ++i) {
      const StoredPools& stored = state.pools[i];
      known_[i] = {read(aims_[i], stored.lineage, confirmer), read(aims_[i], stored.fresh, confirmer),
                   read(aims_[i], stored.best, confirmer), stored.stalled, stored.restarts};
    }
  }

  // The finds of the short run are the best so far, as they were found. Islands start from them in the box of
  // Goal::error, where they still show something there.
  void begin(const std::atomic<bool>& interrupted) {
    if (islands_ != 0) return;  // it was begun before
    const auto [found, looked_at, judged] = first_found<Real>(plan_, aims_, interrupted);
    if (interrupted) return;  // not all of it: a search that is resumed begins again
    begun_ = looked_at;
    judged_ = judged;
    Confirmer<Real> confirmer(*plan_.kernel, plan_.target);
    for (std::size_t i = 0; i < aims_.size(); ++i) {
      const auto guide = make_guide(aims_[i]);
      for (const Numbers<Real>& q : found[i]) {
        if (const auto value = confirmer.value(aims_[i], q)) known_[i].best.put({*value, q});
        Numbers<Real> start = q;
        guide->settle(start);
        const auto value = confirmer.value(aims_[i], start);
        if (!value) continue;
        known_[i].best.put({*value, start});
        known_[i].lineage.put({*value, start});
      }
    }
  }

  SearchResult run(const std::atomic<bool>& interrupted, const std::function<void(const SearchProgress&)>& report) {
    SearchResult result;
    tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(plan_.threads));
    tbb::task_arena arena(plan_.threads);
    while (!is_over(interrupted)) arena.execute([&] { run_epoch(interrupted, report); });
    result.complete = !interrupted;
    result.evaluations = evaluations_;
    result.aims = aims_;
    result.looked_at = looked_at_;
    result.judged = judged_;
    result.begun = begun_;
    result.state = state();
    finish(result);
    return result;
  }

 private:
  static Pool<Real> read(const Aim& aim, const std::vector<StoredQuery>& queries, Confirmer<Real>& confirmer) {
    Pool<Real> pool;
    for (const StoredQuery& stored : queries) {
      const auto& q = std::get<Numbers<Real>>(stored.numbers);
      const auto value = confirmer.value(aim, q);
      if (!value) throw Error(fmt::format("the state to resume from: '{}' cannot be confirmed", stored.id));
      pool.put({*value, q});
    }
    return pool;
  }

  StoredQuery stored_query(std::string id, const Numbers<Real>& q) const {
    return {std::move(id), plan_.precision, q, plan_.kernel->predicate, plan_.kernel->entry};
  }
  std::unique_ptr<Guide<Real>> make_guide(const Aim& aim) const {
    if (aim.goal == Goal::number) return std::make_unique<NumberGuide<Real>>(*plan_.kernel, plan_.target);
    return method_.guide(*plan_.kernel, plan_.target, std::type_identity<Real>());
  }

  double elapsed() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }
  bool is_over(const std::atomic<bool>& interrupted) const {
    return interrupted || (plan_.seconds && islands_ != resumed_from_ && elapsed() >= *plan_.seconds) ||
           (plan_.evaluations && evaluations_ >= *plan_.evaluations);
  }

  // Runs the rest of the current epoch. Islands are handed out in order, and each that was begun is finished: the
  // finished ones are always the first.
  void run_epoch(const std::atomic<bool>& interrupted, const std::function<void(const SearchProgress&)>& report) {
    std::mutex mutex;
    bool failed = false;
    const auto claim = [&]() -> std::optional<std::uint64_t> {
      const std::lock_guard lock(mutex);
      const bool ended = islands_ % slots_.size() == 0 && islands_ != epoch_begin_;
      if (failed || ended || is_over(interrupted)) return std::nullopt;
      evaluations_ += slots_[islands_ % slots_.size()].evaluations;
      return islands_++;
    };
    const auto work = [&](int) {
      while (const auto island = claim()) {
        Island found;
        try {
          found = run_island(*island);
        } catch (...) {
          const std::lock_guard lock(mutex);
          failed = true;
          throw;
        }
        const std::lock_guard lock(mutex);
        const std::size_t aim = slots_[*island % slots_.size()].aim;
        for (const Entry& entry : found.entries) known_[aim].fresh.put(entry);
        merge_fields(looked_at_[aim], found.looked_at);
        judged_[aim] += found.judged;
        report({islands_, evaluations_, elapsed()});
      }
    };
    epoch_begin_ = islands_;
    tbb::parallel_for(0, plan_.threads, work, tbb::simple_partitioner());
    if (islands_ == epoch_begin_ || islands_ % slots_.size() != 0) return;
    for (KnownQueries<Real>& known : known_) known.end_epoch();
    share(known_);
  }

  // The finds of an island, and how much it looked at.
  struct Island {
    std::vector<Entry> entries;
    LookedAt looked_at;
    std::uint64_t judged = 0;
  };

  // Reads only the lineages.
  Island run_island(std::uint64_t island) const {
    const Slot& slot = slots_[island % slots_.size()];
    const Aim& aim = aims_[slot.aim];
    Stream stream(plan_.seed, name_hash("search"), 1, plan_.precision, island);
    Dice random(stream);
    const auto guide = make_guide(aim);
    Confirmer<Real> confirmer(*plan_.kernel, plan_.target);
    const AnswerCounter<Real> counter(*plan_.kernel);
    Island found;
    const ShowAnswers<Real> count = [&](const QueryBatch<Real>& batch, const std::vector<Verdict>& said) {
      for (std::size_t i = 0; i < batch.size(); ++i) counter.add(found.looked_at, batch[i], said[i], island);
    };
    const auto candidates = climb(*guide, aim, random, starts(slot.aim, random), slot.evaluations, count);
    found.judged = guide->judged();
    for (const ScoredQuery<Real>& candidate : candidates) {
      if (candidate.score == 0 || found.entries.size() == 2) break;
      if (const auto value = confirmer.value(aim, candidate.query)) found.entries.push_back({*value, candidate.query});
    }
    return found;
  }

  // On average one island in four starts from families, the others from the lineage.
  std::vector<Numbers<Real>> starts(std::size_t aim, Dice& random) const {
    const auto& lineage = known_[aim].lineage.entries();
    const bool anew = lineage.empty() || random.below(4) == 0;
    std::vector<Numbers<Real>> all(anew ? drawn : walkers);
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (anew) {
        const auto& source = plan_.sources[random.below(plan_.sources.size())];
        all[i] = source->template make<Real>(plan_.seed, random.below(1u << 31));
      } else {
        const auto among = i == 0 || random.coin() ? lineage.size() : std::min<std::size_t>(lineage.size(), 3);
        all[i] = lineage[random.below(among)].query;
      }
    }
    return all;
  }

  // Tries the best queries of every comparison, and their images, on each other one.
  void share(std::vector<KnownQueries<Real>>& known) const {
    if (std::none_of(aims_.begin(), aims_.end(), [](const Aim& aim) { return is_about_a_comparison(aim.goal); }))
      return;
    const auto guide = make_guide({Goal::error});
    Confirmer<Real> confirmer(*plan_.kernel, plan_.target);
    for (const Goal goal : enumerators<Goal>) {
      if (!is_about_a_comparison(goal)) continue;
      std::vector<Numbers<Real>> all;
      for (std::size_t i = 0; i < aims_.size(); ++i) {
        if (aims_[i].goal != goal || known[i].best.empty()) continue;
        for (const Numbers<Real>& image : guide->images(known[i].best.best().query)) all.push_back(image);
      }
      if (all.empty()) continue;
      QueryBatch<Real> images(all.size(), guide->shape().numbers);
      for (const Numbers<Real>& image : all) images.push_back(image);
      std::vector<double> scores;
      std::vector<Verdict> said;  // not counted: these are no evaluations
      for (std::size_t i = 0; i < aims_.size(); ++i) {
        if (aims_[i].goal != goal) continue;
        guide->evaluate(aims_[i], images, scores, said);
        const auto best = std::max_element(scores.begin(), scores.end());
        if (*best <= (known[i].best.empty() ? 0 : known[i].best.best().value.value())) continue;
        const Numbers<Real> q = images[static_cast<std::size_t>(best - scores.begin())];
        if (const auto value = confirmer.value(aims_[i], q)) known[i].best.put({*value, q});
      }
    }
  }

  std::string state() const {
    SearchState state{islands_, evaluations_, std::vector<StoredPools>(aims_.size()), looked_at_, judged_, begun_};
    const auto stored = [&](const Pool<Real>& pool) {
      std::vector<StoredQuery> queries;
      for (const Entry& entry : pool.entries()) queries.push_back(stored_query("", entry.query));
      return queries;
    };
    for (std::size_t i = 0; i < aims_.size(); ++i) {
      const auto& [lineage, fresh, best, stalled, restarts] = known_[i];
      state.pools[i] = {stored(lineage), stored(fresh), stored(best), stalled, restarts};
    }
    return state_text(plan_, aims_, state);
  }

  void finish(SearchResult& result) const {
    std::vector<KnownQueries<Real>> known = known_;
    for (KnownQueries<Real>& of_aim : known) of_aim.best.put(of_aim.fresh);
    share(known);
    Confirmer<Real> confirmer(*plan_.kernel, plan_.target);
    for (std::size_t i = 0; i < aims_.size(); ++i) {
      if (known[i].best.empty()) continue;
      const Aim& aim = aims_[i];
      const auto& [value, query] = known[i].best.best();
      Find find{aim, value, stored_query(name(aim, *plan_.kernel->predicate), query)};
      if (is_about_range(aim.goal)) {
        find.range_exponent = method_.exponent(aim.goal, plan_.precision, value.value());
        find.witness.numbers = times_power(query, find.range_exponent);
      } else if (is_about_a_verdict(aim.goal)) {
        find.links = confirmer.examine(query).judgement.verdict_links;
      }
      result.finds.push_back(find);
    }
  }

  const SearchPlan& plan_;
  const SearchMethod& method_;
  std::vector<Aim> aims_;
  std::vector<Slot> slots_;
  std::uint64_t islands_ = 0, resumed_from_ = 0, epoch_begin_ = 0, evaluations_ = 0;
  std::vector<KnownQueries<Real>> known_;  // by aim
  std::vector<LookedAt> looked_at_;        // by aim
  std::vector<std::uint64_t> judged_;      // by aim
  LookedAt begun_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

template <class Real>
SearchResult search_in(const SearchPlan& plan, const std::optional<std::string>& state,
                       const std::atomic<bool>& interrupted, const std::function<void(const SearchProgress&)>& report) {
  Search<Real> search(plan);
  if (state) search.resume(*state);
  search.begin(interrupted);
  return search.run(interrupted, report);
}

}  // namespace

SearchResult search(const SearchPlan& plan, const std::optional<std::string>& state,
                    const std::atomic<bool>& interrupted, const std::function<void(const SearchProgress&)>& report) {
  return plan.precision == Precision::binary32 ? search_in<float>(plan, state, interrupted, report)
                                               : search_in<double>(plan, state, interrupted, report);
}

}  // namespace axiscert
