#include "fuzz/confirm/cause.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "exact/judge/oracles.h"
#include "fuzz/confirm/classes.h"
#include "fuzz/files/query_file.h"
#include "kernel/kernel.h"

namespace axiscert {
namespace causes {
namespace {

// A verdict is cheap to ask for and to judge by a clear query, but families of boxes and motions take longer to make
// one. The traits of a query, and its truth by exact arithmetic, are the dearest.
constexpr std::uint64_t most_asked = 32768, most_of_slow_families = 8192, most_judged_exactly = 4096;
constexpr std::size_t first_cases = 2048, most_wrong_cases = 768, later_cases = 1024;
constexpr std::size_t batch = 251;
// Each costs a process its life or a time limit.
constexpr std::size_t most_unanswered = 3;

// A query that the kernel decided and whose answer is known.
struct Asked {
  std::uint64_t position;
  std::size_t source;
  Verdict truth;
  bool is_wrong;
};

template <class Real>
class Probe {
 public:
  Probe(const Kernel& kernel, std::span<const CauseSource> sources, const Traits& traits, const std::string& target)
      : kernel_(kernel),
        sources_(sources),
        traits_(traits),
        target_(target),
        oracles_(oracles_of(kernel)),
        implementation_(kernel.on<Real>(target)) {}

  std::optional<CauseRecord> find() {
    gather(CauseBasis::clear);
    for (const CauseBasis further : {CauseBasis::exact, CauseBasis::deep}) {
      if (wrong_ == 0 && !has_reference(kernel_)) gather(further);
    }
    if (wrong_ == 0) return std::nullopt;
    return cause();
  }

 private:
  void gather(CauseBasis basis) {
    basis_ = basis;
    asked_.clear();
    wrong_ = 0;
    const std::uint64_t most = oracles_.has_filters()       ? most_asked
                               : basis == CauseBasis::clear ? most_of_slow_families
                                                            : most_judged_exactly;
    const auto is_asked = [&](const CauseSource& of) {
      return basis != CauseBasis::exact || of.asked.source.exact_arithmetic();
    };
    each_ = std::max<std::uint64_t>(
        32, most / std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::ranges::count_if(sources_, is_asked))));
    for (std::size_t s = 0; s < sources_.size(); ++s) {
      if (!is_asked(sources_[s])) continue;
      const CauseSource& of = sources_[s];
      const std::uint64_t size = std::min(of.queries, each_);
      QueryBatch<Real> queries(batch, of.asked.source.columns().size());
      for (std::uint64_t first = 0; first < size; first += queries.size()) {
        of.asked.source.fill(of.asked.seed, first,
                             static_cast<std::size_t>(std::min<std::uint64_t>(batch, size - first)), queries);
        std::vector<std::uint64_t> positions(queries.size());
        for (std::size_t i = 0; i < positions.size(); ++i) positions[i] = first + i;
        ask(s, positions, queries);
      }
      // Those that the run kept, beyond these.
      std::vector<std::uint64_t> kept;
      queries.clear();
      for (const std::uint64_t position : of.wrong) {
        if (position < size || kept.size() == batch) continue;
        kept.push_back(position);
        queries.push_back(of.asked.source.make<Real>(of.asked.seed, position));
      }
      if (!kept.empty()) ask(s, kept, queries);
    }
    // The first of each source before the second of each.
    std::ranges::stable_sort(asked_, {}, &Asked::position);
  }

  void ask(std::size_t source, const std::vector<std::uint64_t>& positions, const QueryBatch<Real>& queries) {
    if (unanswered_ >= most_unanswered) return;
    const std::vector<std::optional<Verdict>> truths = truths_of(queries);
    std::vector<Verdict> said(queries.size(), Verdict::unanswered);
    implementation_.verdicts(queries.columns(), said.data());
    unanswered_ += std::ranges::find(said, Verdict::unanswered) != said.end();
    for (std::size_t i = 0; i < said.size(); ++i) {
      if (!truths[i] || (said[i] != Verdict::contact && said[i] != Verdict::separated)) continue;
      const bool is_wrong = said[i] != *truths[i];
      if (is_wrong && basis_ == CauseBasis::deep && !is_deep(queries[i])) continue;
      asked_.push_back({positions[i], source, *truths[i], is_wrong});
      wrong_ += is_wrong;
    }
  }

  bool is_deep(const Numbers<Real>& q) const {
    constexpr double rounding = 64 * std::numeric_limits<Real>::epsilon() / 2;
    const std::optional<double> depth = oracles_.has_depth() ? oracles_.depth(q) : std::nullopt;
    return !depth || *depth > rounding;
  }

  // Empty for a query about which the kernel promises nothing, or that the basis leaves out.
  std::vector<std::optional<Verdict>> truths_of(const QueryBatch<Real>& queries) {
    std::vector<std::optional<Verdict>> truths(queries.size());
    std::unique_ptr<BatchOracle<Real>> filters;
    if (basis_ != CauseBasis::clear) {
      filters = batches_of<Real>(oracles_, target_);
      filters->decide(queries);
    }
    for (std::size_t i = 0; i < truths.size(); ++i) {
      const Numbers<Real> q = queries[i];
      if (!filters) {
        truths[i] = oracles_.clear_verdict(q);
      } else if (oracles_.is_valid(q)) {
        std::optional<Truth> truth = filters->known(i);
        if (!truth) truth = oracles_.about(q, Opinion::first)->truth();
        if (!truth->touching) truths[i] = truth->verdict;
      }
      if (truths[i] && !is_promised(kernel_, q)) truths[i].reset();
    }
    return truths;
  }

  Numbers<Real> query(const Asked& asked) const {
    const SeededSource& of = sources_[asked.source].asked;
    return of.source.make<Real>(of.seed, asked.position);
  }
  Case case_of(const Asked& asked) const {
    return {traits_.of(query(asked), kernel_.entry) | trait_of(asked.truth), asked.is_wrong};
  }

  // Cases with the queries that they are.
  struct Cases {
    std::vector<Case> cases;
    std::vector<const Asked*> asked;
    std::size_t size() const { return cases.size(); }
  };
  void put(Cases& to, const Asked& asked) const {
    to.cases.push_back(case_of(asked));
    to.asked.push_back(&asked);
  }

  CauseRecord cause() {
    // The first queries of each source, whatever the kernel said of them, and more on which it is wrong.
    const std::uint64_t first = std::max<std::uint64_t>(16, first_cases / sources_.size());
    Cases sample, further;
    std::uint64_t asked_in_all = 0;
    for (const Asked& asked : asked_) {
      asked_in_all += asked.position < each_;
      if (asked.position < first) put(sample, asked);
      else if (asked.is_wrong && further.size() < most_wrong_cases) put(further, asked);
    }
    const auto wrong_in = [](const Cases& cases) {
      return static_cast<double>(std::ranges::count(cases.cases, true, &Case::is_wrong));
    };
    std::vector<Case> all = sample.cases;
    all.insert(all.end(), further.cases.begin(), further.cases.end());
    const double wrong_cases = wrong_in(sample) + wrong_in(further);
    const double right_cases = static_cast<double>(all.size()) - wrong_cases;
    const auto wrong_asked = static_cast<double>(wrong_);
    const double right_asked = std::max(right_cases, static_cast<double>(asked_in_all) - wrong_asked);
    const Weights weights{wrong_asked / wrong_cases, right_cases == 0 ? 1 : right_asked / right_cases};
    const TraitKinds kinds = kinds_of(traits_);
    const CauseRecord best = record_of(best_class(all, weights, kinds), sample, further, first);
    if (best.is_known) return best;
    const FoundClass sharp = sharp_class(all, weights, kinds);
    if (sharp.traits == 0) return best;
    const CauseRecord other = record_of(sharp, sample, further, first);
    return other.is_known ? other : best;
  }

  CauseRecord record_of(const FoundClass& found, const Cases& sample, const Cases& further, std::uint64_t first) const {
    const auto is_in = [&](const Case& one) { return (one.traits & found.traits) == found.traits; };

    CauseRecord record;
    record.basis = basis_;
    record.phrase = phrase_of(traits_, found.traits);
    for (const std::string& name : trait_names(traits_, found.traits)) record.traits.push_back(Name(name));
    bool has_missed = false, has_phantom = false;
    for (const Cases* cases : {&sample, &further}) {
      for (const Case& one : cases->cases) {
        if (!one.is_wrong) continue;
        ++record.looked_at;
        if (!is_in(one)) continue;
        ++record.explained;
        has_missed |= (one.traits & contact_trait) != 0;
        has_phantom |= (one.traits & separated_trait) != 0;
      }
    }
    record.direction = !has_phantom  ? CauseDirection::missed
                       : !has_missed ? CauseDirection::phantom
                                     : CauseDirection::both;
    count(record, is_in, sample, further, first);
    record.is_known = is_known(record);
    record.witness = witness(is_in, {&sample, &further});
    return record;
  }

  // Wrong verdicts and queries, in the class and elsewhere, of queries that were not chosen by what the kernel said of
  // them: those of the sample, and later ones of the sources that have the class.
  template <class IsIn>
  void count(CauseRecord& record, const IsIn& is_in, const Cases& sample, const Cases& further,
             std::uint64_t first) const {
    const auto add = [&](const Case& one) {
      ++(is_in(one) ? record.of : record.elsewhere_of);
      if (one.is_wrong) ++(is_in(one) ? record.wrong : record.elsewhere_wrong);
    };
    std::vector<bool> has_class(sources_.size());
    for (const Cases* cases : {&sample, &further}) {
      for (std::size_t i = 0; i < cases->size(); ++i) {
        if (cases->cases[i].is_wrong && is_in(cases->cases[i])) has_class[cases->asked[i]->source] = true;
      }
    }
    for (const Case& one : sample.cases) add(one);
    std::size_t later = 0;
    for (const Asked& asked : asked_) {
      if (asked.position < first || asked.position >= each_ || !has_class[asked.source]) continue;
      if (++later > later_cases) break;
      add(case_of(asked));
    }
    // So rare that none was met by chance: those that were looked for are what there is to show.
    if (record.wrong != 0) return;
    for (const Case& one : further.cases) add(one);
  }

  // Half of the wrong verdicts are in the class, or a quarter of a sharp one; and there they are no matter of chance.
  bool is_known(const CauseRecord& record) const {
    if (record.of == 0) return false;
    const auto share = [](std::uint64_t part, std::uint64_t of) {
      return of == 0 ? 0 : static_cast<double>(part) / static_cast<double>(of);
    };
    const double rate = share(record.wrong, record.of), elsewhere = share(record.elsewhere_wrong, record.elsewhere_of);
    const double overall = share(record.wrong + record.elsewhere_wrong, record.of + record.elsewhere_of);
    const double explained = share(record.explained, record.looked_at);
    if (explained < (rate >= sharp_rate ? least_of_sharp : 0.5)) return false;
    return rate >= 4 * elsewhere && (rate >= 0.9 || rate >= 2 * overall);
  }

  // The wrong verdict of the class whose numbers have the fewest digits; the first of these.
  template <class IsIn>
  std::optional<CauseWitness> witness(const IsIn& is_in, std::initializer_list<const Cases*> among) const {
    const Asked* best = nullptr;
    std::size_t least = 0;
    for (const Cases* cases : among) {
      for (std::size_t i = 0; i < cases->size(); ++i) {
        if (!cases->cases[i].is_wrong || !is_in(cases->cases[i])) continue;
        std::size_t digits = 0;
        for (const Real x : query(*cases->asked[i])) digits += fmt::formatted_size("{}", x);
        if (best != nullptr && digits >= least) continue;
        best = cases->asked[i];
        least = digits;
      }
    }
    if (best == nullptr) return std::nullopt;
    const Numbers<Real> q = query(*best);
    CauseWitness shown;
    shown.address = sources_[best->source].asked.address(best->position);
    shown.query = query_line({"cause", precision_of<Real>, q, kernel_.predicate, kernel_.entry});
    for (const Real x : q) shown.numbers.push_back(Digits(fmt::format("{}", x)));
    shown.truth = best->truth;
    shown.answered = best->truth == Verdict::contact ? Verdict::separated : Verdict::contact;
    return shown;
  }

  const Kernel& kernel_;
  std::span<const CauseSource> sources_;
  const Traits& traits_;
  const std::string& target_;
  const Oracles& oracles_;
  Implementation<Real> implementation_;
  CauseBasis basis_ = CauseBasis::clear;
  std::uint64_t each_ = 0;  // queries of a source that are asked
  std::vector<Asked> asked_;
  std::uint64_t wrong_ = 0;
  std::size_t unanswered_ = 0;
};

// The positions of wrong verdicts that a tally keeps.
std::vector<std::uint64_t> kept_wrong(const Tally& tally) {
  std::vector<std::uint64_t> all;
  const auto add = [&](const Leaders<double>& leaders) {
    for (const auto& [rank, position] : leaders.candidates()) all.push_back(position);
  };
  add(tally.verdict.deepest_false_separation);
  add(tally.verdict.deepest_false_contact);
  for (const Leaders<bool>* first : {&tally.verdict.clear->first_missed, &tally.verdict.clear->first_phantom}) {
    for (const auto& [rank, position] : first->candidates()) all.push_back(position);
  }
  for (const ClassCount& count : tally.classes.classes) add(count.deepest);
  std::ranges::sort(all);
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

// Whether rounding and the range, which the links of the chain tell of a kernel with a reference, leave something open.
bool has_unknown_cause(const Kernel& kernel, const Tally& tally) {
  const VerdictTally& verdict = tally.verdict;
  const LinkCounts& links = verdict.links;
  if (has_reference(kernel)) {
    return links[Link::specification] + links[Link::implementation] + links[Link::unattributed] != 0;
  }
  return verdict.false_separation + verdict.false_contact != 0;
}

}  // namespace
}  // namespace causes

std::optional<CauseRecord> cause_of(const Kernel& kernel, std::span<const CauseSource> sources,
                                    const std::string& target) {
  const Traits* const traits = capabilities_of(*kernel.predicate).traits;
  if (traits == nullptr || sources.empty()) return std::nullopt;
  return sources.front().asked.precision == Precision::binary32
             ? causes::Probe<float>(kernel, sources, *traits, target).find()
             : causes::Probe<double>(kernel, sources, *traits, target).find();
}

std::optional<CauseRecord> cause_in_run(const Plan& plan, const CampaignResult& result, std::size_t kernel,
                                        Precision precision) {
  const Kernel& of = *plan.answerers.kernels[kernel];
  std::vector<CauseSource> sources;
  bool is_looked_for = false;
  for (const CellResult& cell : result.cells) {
    const Tally& tally = cell.tallies[kernel];
    if (cell.precision != precision || tally.trials == 0) continue;
    is_looked_for |= causes::has_unknown_cause(of, tally);
    const Source& source = *plan.questions.sources[cell.source];
    sources.push_back({{source, plan.questions.seed, precision}, cell.queries, causes::kept_wrong(tally)});
  }
  return is_looked_for ? cause_of(of, sources, plan.running.target) : std::nullopt;
}

void put_causes(Record& record, const Plan& plan, const CampaignResult& result) {
  if (plan.answerers.replies || !result.complete) return;
  for (KernelRecord& entry : record.kernels) {
    const auto& kernels = plan.answerers.kernels;
    const auto at = std::ranges::find_if(kernels, [&](const Kernel* kernel) { return entry.id == kernel->id; });
    if (at == kernels.end()) continue;
    entry.cause = cause_in_run(plan, result, static_cast<std::size_t>(at - kernels.begin()), entry.precision);
  }
}

}  // namespace axiscert
