#include "fuzz/confirm/invariance.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "exact/trait/oracles.h"

namespace axiscert {
namespace {

template <class Real>
int image_size(ImageKind kind, const AnsweredGroup<Real>& answered, std::size_t image) {
  const ImageGroup& group = answered.group;
  if (kind == ImageKind::scale) return group.exponent(precision_of<Real>, answered.position / group.size, image);
  if (kind != ImageKind::translation) return 0;
  const Numbers<Real>&base = answered.queries[0], &moved = answered.queries[image];
  const std::vector<PredicateColumn>& columns = group.predicate().entries[0].columns;
  Real greatest = 0;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (columns[k].role == Role::coordinate) greatest = std::max(greatest, std::abs(moved[k] - base[k]));
  }
  return greatest == 0 ? 0 : std::ilogb(greatest);
}

struct ScaledAnswer {
  int exponent;
  bool is_right;
};

// The first change on the way from the base to one end, whose answers are in this order.
void keep_flip(UnitFaults& faults, std::uint64_t position, Verdict right, std::span<const ScaledAnswer> outwards) {
  for (std::size_t i = 1; i < outwards.size(); ++i) {
    const ScaledAnswer &near = outwards[i - 1], &far = outwards[i];
    if (near.is_right == far.is_right) continue;
    const int wrong = near.is_right ? far.exponent : near.exponent,
              other = near.is_right ? near.exponent : far.exponent;
    std::vector<UnitFlip>& flips = wrong < other ? faults.small : faults.large;
    if (flips.size() < most_unit_flips) flips.push_back({position, right, other, wrong});
    return;
  }
}

template <class Real>
void count_units(UnitFaults& faults, const AnsweredGroup<Real>& answered) {
  const std::optional<Verdict> right =
      oracles_of(answered.group.predicate()).verdict_beyond(std::ldexp(1.0, clear_depth_exponent), answered.queries[0]);
  if (!right) return;
  std::vector<ScaledAnswer> answers;
  const bool base_is_right = *answered.verdicts[0] == *right;
  for (std::size_t i = 0; i < answered.verdicts.size(); ++i) {
    if (i != 0 && answered.group.kind(i) != ImageKind::scale) continue;
    const auto said = answered.verdicts[i];
    const int exponent = i == 0 ? 0 : image_size(ImageKind::scale, answered, i);
    if (!said || *said == Verdict::undecided) continue;
    answers.push_back({exponent, *said == *right});
    if (i != 0)
      faults.wrong.add(exponent, {answered.position, answered.position + i}, base_is_right && *said != *right);
  }
  std::sort(answers.begin(), answers.end(), [](const auto& x, const auto& y) { return x.exponent < y.exponent; });
  const auto base = std::find_if(answers.begin(), answers.end(), [](const auto& x) { return x.exponent == 0; });
  if (base == answers.end()) return;
  keep_flip(faults, answered.position, *right, {base, answers.end()});
  std::reverse(answers.begin(), base + 1);
  keep_flip(faults, answered.position, *right, {answers.begin(), base + 1});
}

void append(std::vector<UnitFlip>& into, const std::vector<UnitFlip>& later) {
  const std::size_t room = most_unit_flips - into.size();
  into.insert(into.end(), later.begin(), later.begin() + static_cast<std::ptrdiff_t>(std::min(room, later.size())));
}

}  // namespace

void ImageChanges::add(int size, const ImagePair& pair, bool is_changed) {
  ++images;
  if (!is_changed) return;
  ++changed;
  ++by_size[size];
  if (first && std::abs(size) >= std::abs(first_size)) return;
  first = pair;
  first_size = size;
}

void ImageChanges::merge(const ImageChanges& later) {
  images += later.images;
  changed += later.changed;
  undecided += later.undecided;
  for (const auto& [size, count] : later.by_size) by_size[size] += count;
  if (!later.first || (first && std::abs(later.first_size) >= std::abs(first_size))) return;
  first = later.first;
  first_size = later.first_size;
}

void Invariance::merge(const Invariance& later) {
  for (const ImageKind kind : enumerators<ImageKind>) kinds[kind].merge(later.kinds[kind]);
  units.wrong.merge(later.units.wrong);
  append(units.small, later.units.small);
  append(units.large, later.units.large);
}

template <class Real>
void count_invariance(Invariance& into, const AnsweredGroup<Real>& answered) {
  const ImageGroup& group = answered.group;
  const auto base = answered.verdicts[0];
  if (!base) return;
  bool any_unit = false;
  for (std::size_t i = 1; i < group.size; ++i) {
    const auto said = answered.verdicts[i];
    if (!said) continue;
    const ImageKind kind = group.kind(i);
    if (!decides_image(kind, *base)) continue;
    const bool are_no_verdicts = *said == Verdict::invalid && *base == Verdict::invalid;  // the same, and show nothing
    if (*said == Verdict::undecided || *base == Verdict::undecided || are_no_verdicts) {
      ++into.kinds[kind].undecided;
      continue;
    }
    const int size = image_size(kind, answered, i);
    const bool is_changed = *said != *base;
    into.kinds[kind].add(size, {answered.position, answered.position + i}, is_changed);
    any_unit |= is_changed && kind == ImageKind::scale;
  }
  if (any_unit && group.range) count_units(into.units, answered);
}
template void count_invariance(Invariance&, const AnsweredGroup<float>&);
template void count_invariance(Invariance&, const AnsweredGroup<double>&);

}  // namespace axiscert
