#include "fuzz/confirm/nearest_kernel.h"

#include <algorithm>
#include <set>

#include "exact/judge/oracles.h"

namespace axiscert {
namespace {

constexpr std::size_t most_at_once = 1024;

// Positions of wrong verdicts that a tally keeps beyond the first queries.
std::set<std::uint64_t> deep_positions(const Tally& tally, std::uint64_t from) {
  std::set<std::uint64_t> all;
  const auto add = [&](const Leaders<double>& leaders) {
    for (const auto& [rank, position] : leaders.candidates()) {
      if (position >= from) all.insert(position);
    }
  };
  add(tally.verdict.deepest_false_separation);
  add(tally.verdict.deepest_false_contact);
  for (const ClassCount& count : tally.classes.classes) add(count.deepest);
  return all;
}

// A built-in kernel, asked about the same queries.
template <class Real>
struct Other {
  const Kernel* kernel;
  Implementation<Real> implementation;
  std::uint64_t wrong = 0, both = 0;
};

template <class Real>
class NearestSearch {
 public:
  NearestSearch(const Kernel& kernel, const std::string& target)
      : kernel_(kernel),
        oracles_(oracles_of(kernel)),
        truths_(batches_of<Real>(oracles_, target)),
        batch_(most_at_once, kernel.predicate->entries[kernel.entry].columns.size()) {
    for (const Kernel& other : kernels()) {
      if (other.id == kernel.id || other.predicate != kernel.predicate || other.entry != kernel.entry ||
          !other.has(precision_of<Real>))
        continue;
      others_.push_back({&other, other.on<Real>(target)});
    }
  }

  void compare(const TalliedSource& of) {
    const std::uint64_t first = std::min(nearest_queries, of.queries);
    std::vector<std::uint64_t> wrong = of.tally->classes.first_wrong;
    std::sort(wrong.begin(), wrong.end());
    for (std::uint64_t position = 0; position < first; ++position) {
      add(of.asked, position, std::binary_search(wrong.begin(), wrong.end(), position));
    }
    for (const std::uint64_t position : deep_positions(*of.tally, first)) add(of.asked, position, true);
    compare_batch();
  }

  std::optional<NearestKernel> nearest() const {
    std::optional<NearestKernel> best;
    for (const Other<Real>& other : others_) {
      const NearestKernel found{other.kernel, queries_, wrong_, other.both, other.wrong + wrong_ - other.both};
      if (found.both == 0) continue;
      // Shares as fractions: both / either.
      if (!best || found.both * best->either > best->both * found.either) best = found;
    }
    return best;
  }

 private:
  void add(const SeededSource& of, std::uint64_t position, bool is_wrong) {
    const Numbers<Real> q = of.source.make<Real>(of.seed, position);
    if (!oracles_.is_valid(q) || !is_promised(kernel_, q)) return;
    batch_.push_back(q);
    is_wrong_.push_back(is_wrong);
    if (batch_.size() == batch_.capacity()) compare_batch();
  }

  void compare_batch() {
    if (batch_.size() == 0) return;
    const std::vector<Verdict> truth = truths();
    std::vector<Verdict> said(batch_.size());
    for (Other<Real>& other : others_) {
      other.implementation.verdicts(batch_.columns(), said.data());
      for (std::size_t i = 0; i < said.size(); ++i) {
        const bool decided = said[i] == Verdict::separated || said[i] == Verdict::contact;
        const bool is_wrong = decided && said[i] != truth[i];
        other.wrong += is_wrong;
        other.both += is_wrong && is_wrong_[i];
      }
    }
    queries_ += batch_.size();
    wrong_ += static_cast<std::uint64_t>(std::count(is_wrong_.begin(), is_wrong_.end(), true));
    batch_.clear();
    is_wrong_.clear();
  }

  std::vector<Verdict> truths() {
    truths_->decide(batch_);
    std::vector<Verdict> truth(batch_.size());
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const std::optional<Truth> known = truths_->known(i);
      truth[i] = known ? known->verdict : oracles_.about(batch_[i], Opinion::first)->truth().verdict;
    }
    return truth;
  }

  const Kernel& kernel_;
  const Oracles& oracles_;
  std::unique_ptr<BatchOracle<Real>> truths_;
  QueryBatch<Real> batch_;
  std::vector<bool> is_wrong_;  // by query of the batch: the given kernel
  std::vector<Other<Real>> others_;
  std::uint64_t queries_ = 0, wrong_ = 0;
};

template <class Real>
std::optional<NearestKernel> nearest_in(const Kernel& kernel, const std::vector<TalliedSource>& sources,
                                        const std::string& target) {
  NearestSearch<Real> search(kernel, target);
  for (const TalliedSource& source : sources) search.compare(source);
  return search.nearest();
}

bool is_ever_wrong(const TalliedSource& of) {
  return of.tally->verdict.false_separation + of.tally->verdict.false_contact != 0;
}

}  // namespace

std::optional<NearestKernel> nearest_kernel(const Kernel& kernel, const std::vector<TalliedSource>& sources,
                                            const std::string& target) {
  if (!has_input_classes(kernel) || std::none_of(sources.begin(), sources.end(), is_ever_wrong)) return std::nullopt;
  return sources.front().asked.precision == Precision::binary32 ? nearest_in<float>(kernel, sources, target)
                                                                : nearest_in<double>(kernel, sources, target);
}

}  // namespace axiscert
