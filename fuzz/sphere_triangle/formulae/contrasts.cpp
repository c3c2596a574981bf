#include "fuzz/sphere_triangle/formulae/contrasts.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace axiscert {
namespace {

// The formulae from which a set of formulae was rewritten, the nearest first.
std::vector<Formulae> origins(Formulae formulae) {
  using enum Formulae;
  if (formulae == none) return {};
  switch (formulae) {
    case ladder_1:
    case ladder_2:
    case ladder_3:
    case ladder_4:
    case ladder_5:
    case ladder_6:
    case ladder_7:
    case ladder_8:
    case ladder_9:
      return {static_cast<Formulae>(static_cast<int>(formulae) - 1)};
    case published:
    case ladder_0:
      return {};
    default:
      if (kind_of(formulae) != FormulaeKind::rung) return {};
      return {ladder_9, published};
  }
}

std::optional<std::size_t> find_form(const std::vector<const Kernel*>& kernels, Formulae formulae,
                                     Arithmetic arithmetic, Strictness strictness) {
  for (std::size_t i = 0; i < kernels.size(); ++i) {
    const Kernel& kernel = *kernels[i];
    if (formulae_of(kernel) == formulae && kernel.arithmetic == arithmetic && kernel.strictness == strictness) return i;
  }
  return std::nullopt;
}

constexpr EnumArray<Figure, std::optional<AxisKind>> kinds_of_figures = {std::nullopt, std::nullopt, AxisKind::plane,
                                                                         AxisKind::vertex, AxisKind::edge};

EnumArray<Figure, bool> figures_of(const Kernel& from, const Kernel& to) {
  const EnumArray<AxisKind, bool> rewritten = rewritten_kinds(from, to);
  EnumArray<Figure, bool> counts;
  for (const Figure figure : enumerators<Figure>) {
    const auto kind = kind_of(figure);
    counts[figure] = kind ? rewritten[*kind] : std::ranges::any_of(rewritten, [](bool is) { return is; });
  }
  return counts;
}

// Whether `to` is `from` but for the factor's second level.
bool differ_in(Factor factor, const Kernel& from, const Kernel& to) {
  const FactorialCell *a = factorial_cell(from), *b = factorial_cell(to);
  if (!a || !b || a->has(factor)) return false;
  const FactorialCell* const planes = factorial_cells().data() + edge_cell_count;
  return (a >= planes) == is_of_plane(factor) && (b >= planes) == is_of_plane(factor) &&
         b->levels == (a->levels | 1u << index_of(factor));
}

}  // namespace

std::vector<LadderStep> ladder_steps(const std::vector<const Kernel*>& kernels) {
  std::vector<LadderStep> steps;
  for (std::size_t to = 0; to < kernels.size(); ++to) {
    const Kernel& kernel = *kernels[to];
    std::optional<std::size_t> from;
    if (kernel.arithmetic != Arithmetic::plain) {
      from = find_form(kernels, formulae_of(kernel), Arithmetic::plain, kernel.strictness);
    } else {
      for (const Formulae origin : origins(formulae_of(kernel))) {
        if (!from) from = find_form(kernels, origin, kernel.arithmetic, kernel.strictness);
      }
    }
    if (from) steps.push_back({*from, to});
  }
  return steps;
}

std::optional<AxisKind> kind_of(Figure figure) { return kinds_of_figures[figure]; }

std::uint64_t trials_per_query(Figure figure) {
  const auto kind = kind_of(figure);
  return kind ? static_cast<std::uint64_t>(std::popcount(static_cast<unsigned>(comparisons_of_kind(*kind)))) : 1;
}

std::vector<Contrast> contrasts_of(const std::vector<const Kernel*>& kernels) {
  std::vector<Contrast> contrasts, effects;
  for (const LadderStep& step : ladder_steps(kernels)) {
    contrasts.push_back({ContrastKind::step, std::nullopt, {step}, figures_of(*kernels[step.from], *kernels[step.to])});
  }
  for (const Factor factor : enumerators<Factor>) {
    Contrast effect{ContrastKind::effect, factor, {}, {}};
    for (std::size_t from = 0; from < kernels.size(); ++from) {
      for (std::size_t to = 0; to < kernels.size(); ++to) {
        if (!differ_in(factor, *kernels[from], *kernels[to])) continue;
        effect.pairs.push_back({from, to});
        effect.counts = figures_of(*kernels[from], *kernels[to]);
        contrasts.push_back({ContrastKind::pair, factor, {{from, to}}, effect.counts});
      }
    }
    if (effect.pairs.size() == (is_of_plane(factor) ? 2 : edge_cell_count / 2)) effects.push_back(std::move(effect));
  }
  contrasts.insert(contrasts.end(), effects.begin(), effects.end());
  return contrasts;
}

void ClusterTally::merge(const ClusterTally& other) {
  closed_.merge(other.closed_);
  for (const auto& [cluster, sum] : other.open_) open_[cluster] += sum;
}

ClusterSums ClusterTally::sums() const {
  ClusterSums all = closed_;
  for (const auto& [cluster, sum] : open_) all.add(sum);
  return all;
}

void ContrastTally::merge(const ContrastTally& other) {
  only_from += other.only_from;
  only_to += other.only_to;
  sums.merge(other.sums);
}

ClusteredTrials SourceContrasts::trials(Figure figure, std::size_t pairs) const {
  return {queries_ * trials_per_query(figure) * pairs, clusters()};
}

PairedCounts SourceContrasts::paired(std::size_t contrast, std::size_t pairs, Figure figure) const {
  const ContrastTally& tally = contrasts_[contrast][figure];
  return {trials(figure, pairs), tally.only_from, tally.only_to, tally.sums.sums()};
}

void SourceContrasts::merge(const SourceContrasts& other) {
  queries_ += other.queries_;
  clusters_ += other.clusters_;
  recurring_.insert(other.recurring_.begin(), other.recurring_.end());
  for (const Figure figure : enumerators<Figure>) {
    for (std::size_t k = 0; k < forms_.size(); ++k) forms_[k][figure].merge(other.forms_[k][figure]);
    for (std::size_t c = 0; c < contrasts_.size(); ++c) contrasts_[c][figure].merge(other.contrasts_[c][figure]);
  }
}

ContrastCounter::ContrastCounter(std::span<const Contrast> contrasts, const Source& source, Precision precision,
                                 SourceContrasts& into)
    : contrasts_(contrasts),
      source_(source),
      precision_(precision),
      into_(into),
      forms_(into.forms_.size()),
      differences_(contrasts.size()) {}

void ContrastCounter::add(std::uint64_t position, std::span<const QueryErrors> errors) {
  const std::uint64_t cluster = source_.cluster(precision_, position);
  if (cluster_ != cluster) close();
  cluster_ = cluster;
  ++into_.queries_;
  static const EnumArray<AxisKind, ComparisonBits> of_kind = {
      comparisons_of_kind(AxisKind::plane), comparisons_of_kind(AxisKind::vertex), comparisons_of_kind(AxisKind::edge)};
  // One bit for each trial that fails.
  const auto failures = [&](std::size_t kernel, Figure figure) -> unsigned {
    const QueryErrors& of = errors[kernel];
    const auto kind = kind_of(figure);
    if (kind) return static_cast<unsigned>(of.signs & of_kind[*kind]);
    return figure == Figure::missed ? of.missed : of.phantom;
  };
  for (const Figure figure : enumerators<Figure>) {
    for (std::size_t k = 0; k < errors.size(); ++k) forms_[k][figure] += std::popcount(failures(k, figure));
    for (std::size_t c = 0; c < contrasts_.size(); ++c) {
      if (!contrasts_[c].counts[figure]) continue;
      ContrastTally& tally = into_.contrasts_[c][figure];
      for (const LadderStep& pair : contrasts_[c].pairs) {
        const unsigned from = failures(pair.from, figure), to = failures(pair.to, figure);
        const int only_from = std::popcount(from & ~to), only_to = std::popcount(to & ~from);
        tally.only_from += static_cast<std::uint64_t>(only_from);
        tally.only_to += static_cast<std::uint64_t>(only_to);
        differences_[c][figure] += only_to - only_from;
      }
    }
  }
}

void ContrastCounter::close() {
  if (!cluster_) return;
  const bool recurs = source_.cluster_run() == 0;
  if (recurs) into_.recurring_.insert(*cluster_);
  else ++into_.clusters_;
  const auto put = [&](ClusterTally& tally, std::int64_t& sum) {
    if (recurs) tally.add_open(*cluster_, sum);
    else tally.add(sum);
    sum = 0;
  };
  for (const Figure figure : enumerators<Figure>) {
    for (std::size_t k = 0; k < forms_.size(); ++k) put(into_.forms_[k][figure], forms_[k][figure]);
    for (std::size_t c = 0; c < differences_.size(); ++c)
      put(into_.contrasts_[c][figure].sums, differences_[c][figure]);
  }
  cluster_.reset();
}

std::uint64_t block_of_whole_clusters(const std::vector<SourcePtr>& sources, std::uint64_t least) {
  std::uint64_t run = 1;
  for (const SourcePtr& source : sources) run = std::lcm(run, std::max<std::uint64_t>(1, source->cluster_run()));
  return (least + run - 1) / run * run;
}

}  // namespace axiscert
