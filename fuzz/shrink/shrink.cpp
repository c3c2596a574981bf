#include "fuzz/shrink/shrink.h"

#include <fmt/format.h>

#include "fuzz/queries/random.h"
#include "exact/judge/oracles.h"
#include "fuzz/shrink/shrink_moves.h"
#include "kernel/base/error.h"

namespace axiscert {

namespace {

// When no single move helps, this many attempts are made with several moves and with small changes that may repair
// their effect. The attempts are determined by this seed and their number alone.
constexpr std::uint64_t seed = 1, most_moves = 6, most_nudges = 6;
// Without filters the truth takes as many times as long.
std::uint64_t attempts_of(const Oracles& oracles) { return oracles.has_filters() ? 400000 : 20000; }

template <class Real>
class Walk {
 public:
  Walk(const Predicate& predicate, const Numbers<Real>& q, const SeverityOn<Real>& severity, KeepingRule keeping,
       std::uint64_t limit, const CountEvaluations& evaluated, std::size_t entry)
      : predicate_(predicate), entry_(entry), severity_(severity), limit_(limit), evaluated_(evaluated) {
    const Severity given = *severity(q);
    const Keep keep = keeping == KeepingRule::symptom ? Keep() : Keep(predicate, q, given, entry);
    out_ = {q, given, given, keep, {size_of(q)}, 0, true};
  }

  ShrinkResult<Real> run() && {
    do apply_single_moves();
    while (out_.complete && try_combinations());
    // The second oracle, where the predicate has one, checks the result before it is returned.
    oracles_of(predicate_, entry_).truth(out_.query);
    return std::move(out_);
  }

 private:
  // Applies single moves until a round of all moves accepts none.
  void apply_single_moves() {
    for (std::size_t k = 0, in_vain = 0; in_vain < moves_.size() && out_.complete; k = (k + 1) % moves_.size()) {
      in_vain = try_accept(moved(shape_, out_.query, moves_[k])) ? 0 : in_vain + 1;
    }
  }

  // Returns whether a combination was accepted.
  bool try_combinations() {
    const std::uint64_t attempts = attempts_of(oracles_of(predicate_, entry_));
    for (std::uint64_t n = 0; n < attempts && out_.complete; ++n) {
      Stream random(seed, name_hash("shrink"), 1, precision_of<Real>, n);
      std::optional<Numbers<Real>> q = out_.query;
      const auto change = [&](const std::vector<Move>& moves, std::uint64_t times) {
        for (; times > 0 && q; --times) q = moved(shape_, *q, moves[random.below(moves.size())]);
      };
      change(moves_, 1 + random.below(most_moves));
      change(nudges_, random.below(most_nudges + 1));
      if (try_accept(q)) return true;
    }
    return false;
  }

  bool try_accept(const std::optional<Numbers<Real>>& q) {
    if (!q) return false;
    const QuerySize size = size_of(*q);
    if (!(size < out_.sizes.back())) return false;
    if (out_.evaluations == limit_ || (evaluated_ && !evaluated_(out_.evaluations))) {
      out_.complete = false;
      return false;
    }
    ++out_.evaluations;
    auto severity = severity_(*q);
    if (!severity || !is_no_less(*severity, out_.before) || !out_.kept.allows(*q, *severity)) return false;
    out_.query = *q;
    out_.after = std::move(*severity);
    out_.sizes.push_back(size);
    return true;
  }

  const Predicate& predicate_;
  const std::size_t entry_;
  const SeverityOn<Real>& severity_;
  std::uint64_t limit_;
  const CountEvaluations& evaluated_;
  const QueryShape shape_ = shape_of(predicate_.entries[entry_]);
  const std::vector<Move> moves_ = moves<Real>(shape_), nudges_ = nudges(shape_);
  ShrinkResult<Real> out_;
};

}  // namespace

template <class Real>
ShrinkResult<Real> shrink(const Predicate& predicate, const Numbers<Real>& q, const SeverityOn<Real>& severity,
                          KeepingRule keeping, std::uint64_t limit, const CountEvaluations& evaluated,
                          std::size_t entry) {
  return Walk<Real>(predicate, q, severity, keeping, limit, evaluated, entry).run();
}
template ShrinkResult<float> shrink(const Predicate&, const Numbers<float>&, const SeverityOn<float>&, KeepingRule,
                                    std::uint64_t, const CountEvaluations&, std::size_t);
template ShrinkResult<double> shrink(const Predicate&, const Numbers<double>&, const SeverityOn<double>&, KeepingRule,
                                     std::uint64_t, const CountEvaluations&, std::size_t);

template <class Real>
ShrinkResult<Real> shrink(const Numbers<Real>& q, const Symptom& symptom, const Kernel& kernel, std::string_view target,
                          std::uint64_t limit, KeepingRule keeping, const CountEvaluations& evaluated) {
  SymptomFinder<Real> finder(kernel, target);
  if (!finder.severity(q, symptom)) {
    throw Error(fmt::format("the query does not show {} of {}", text(symptom), kernel.id));
  }
  const SeverityOn<Real> severity = [&](const Numbers<Real>& at) { return finder.severity(at, symptom); };
  return shrink<Real>(*kernel.predicate, q, severity, keeping, limit, evaluated, kernel.entry);
}
template ShrinkResult<float> shrink<float>(const Numbers<float>&, const Symptom&, const Kernel&, std::string_view,
                                           std::uint64_t, KeepingRule, const CountEvaluations&);
template ShrinkResult<double> shrink<double>(const Numbers<double>&, const Symptom&, const Kernel&, std::string_view,
                                             std::uint64_t, KeepingRule, const CountEvaluations&);

}  // namespace axiscert
