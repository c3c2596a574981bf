#include "fuzz/confirm/asymmetry.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "exact/judge/oracles.h"
#include "fuzz/confirm/image_numbers.h"
#include "kernel/ask.h"
#include "kernel/query.h"

namespace axiscert {
namespace {

template <class Real>
int image_size(ImageKind kind, const AnsweredGroup<Real>& answered, std::size_t image) {
  const ImageGroup& group = answered.group;
  if (kind == ImageKind::scale) return group.exponent(precision_of<Real>, answered.position / group.size, image);
  if (kind != ImageKind::translation) return 0;
  const Numbers<Real>&base = answered.queries[0], &moved = answered.queries[image];
  const std::vector<PredicateColumn>& columns = group.predicate().entries[find_family(group.family).entry].columns;
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
  const std::optional<Verdict> right = oracles_of(answered.group.predicate(), find_family(answered.group.family).entry)
                                           .verdict_beyond(std::ldexp(1.0, clear_depth_exponent), answered.queries[0]);
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

void ImageNumbers::merge(const ImageNumbers& later) {
  images += later.images;
  compared += later.compared;
  lost += later.lost;
  if (!first_lost) first_lost = later.first_lost;
  compared_features += later.compared_features;
  features += later.features;
  if (!first_feature) first_feature = later.first_feature;
  separation.merge(later.separation);
  angle.merge(later.angle);
  point.merge(later.point);
}

void WorstImage::offer(const std::optional<double>& found, const ImagePair& of) {
  compared += found.has_value();
  if (!would_take(found)) return;
  size = *found;
  pair = of;
}

void WorstImage::merge(const WorstImage& later) {
  compared += later.compared;
  if (!would_take(later.size)) return;
  size = later.size;
  pair = later.pair;
}

namespace {

// Whether two answers show anything of each other: what was declined does not, nor what is `invalid` twice.
bool are_compared(Verdict x, Verdict y) {
  return x != Verdict::undecided && y != Verdict::undecided && (x != Verdict::invalid || y != Verdict::invalid);
}

}  // namespace

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
    if (!are_compared(*said, *base)) {
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

namespace {

constexpr std::uint64_t batch_bases = 16;  // bases that are asked about at once

template <class Real>
class AsymmetryBlock {
 public:
  AsymmetryBlock(const SeededSource& of, const Kernel& kernel, const StoredReplies* replies, const std::string& target,
                 const ImageGroup& group)
      : of_(of),
        kernel_(kernel),
        replies_(replies),
        group_(group),
        batch_(batch_bases * group.size, of.source.columns().size()) {
    for (std::size_t i = 0; i < group.size; ++i) {
      const bool are_others = i != 0 && has_own_comparisons(group.kind(i));
      of_base_.push_back(are_others ? std::nullopt
                                    : std::optional(ComparisonsOfBase(group.predicate(), group.order(i))));
    }
    if (!replies) implementation_ = kernel.on<Real>(target);
  }

  Asymmetry count(std::uint64_t first_base, std::uint64_t last_base) {
    for (std::uint64_t base = first_base; base < last_base; base += batch_bases) {
      const std::uint64_t bases = std::min(batch_bases, last_base - base);
      of_.source.fill(of_.seed, base * group_.size, static_cast<std::size_t>(bases * group_.size), batch_);
      if (!replies_) ask(implementation_, batch_.columns(), reply_);
      for (std::uint64_t i = 0; i < bases; ++i) count_group((base + i) * group_.size, i * group_.size);
    }
    return found_;
  }

 private:
  std::optional<Outcome> answer(std::uint64_t position, std::size_t in_batch) const {
    const Outcome said = replies_ ? replies_->at(of_.source, precision_of<Real>, position) : reply_.outcome(in_batch);
    if (said.verdict == Verdict::unanswered) return std::nullopt;
    const Numbers<Real> numbers = batch_[in_batch];
    // Numbers that are no query have no motion to promise anything of.
    if (kernel_.motion != MotionPolicy{} && oracles_of(kernel_).truth(numbers).verdict == Verdict::invalid)
      return std::nullopt;
    return is_promised(kernel_, numbers) ? std::optional(said) : std::nullopt;
  }

  void count_group(std::uint64_t position, std::size_t in_batch) {
    queries_.clear();
    verdicts_.clear();
    std::optional<Outcome> base;
    for (std::size_t i = 0; i < group_.size; i += i == 0 ? 1 : group_.parts) {
      const auto image = i == 0 ? answer(position, in_batch) : answer_of_parts(position, in_batch, i);
      if (i == 0) base = image;
      else if (base && image) count_image(*base, *image, {position, position + i}, i);
      const std::size_t parts = i == 0 ? 1 : group_.parts;
      for (std::size_t part = 0; part < parts; ++part) {
        queries_.push_back(batch_[in_batch + i + part]);
        verdicts_.push_back(image && part == 0 ? std::optional(image->verdict) : std::nullopt);
      }
    }
    count_invariance<Real>(found_.invariance, {group_, position, queries_, verdicts_});
    const bool is_decided = base && (base->verdict == Verdict::contact || base->verdict == Verdict::separated);
    const bool has_numbers = kernel_.measure_count != 0 && group_.parts == 1 && position < image_numbers_queries;
    if (has_numbers && is_decided) count_numbers_of(position, in_batch);
  }

  std::vector<double> measures(std::uint64_t position, std::size_t in_batch) const {
    return replies_ ? replies_->measures(of_.source, precision_of<Real>, position) : reply_.measures(in_batch);
  }

  static bool says_nothing(const std::vector<double>& measures) {
    return std::ranges::all_of(measures, [](double x) { return std::isnan(x); });
  }

  // For the answer to query i of the group at hand.
  OwnErrors own_errors_of(std::size_t i, const std::vector<double>& measures) const {
    const Numbers<Real>& q = queries_[i];
    const Oracles& oracles = oracles_of(kernel_);
    if (!oracles.is_valid(q) || !has_judged_contact(kernel_, *verdicts_[i], [&] { return oracles.truth(q); }))
      return {};
    const std::unique_ptr<ContactJudge> judge = oracles.contact_judge(q);
    if (!judge) return {};
    const double extent = image_extent(kernel_.predicate->entries[kernel_.entry], in_doubles(q));
    return own_errors(judge->judge(*verdicts_[i], measures), judge->scene(), extent);
  }

  // The numbers on the images of a base against those on the base, where the verdicts are one.
  void count_numbers_of(std::uint64_t position, std::size_t in_batch) {
    const Predicate& predicate = *kernel_.predicate;
    const PredicateEntry& entry = predicate.entries[kernel_.entry];
    const Numbers<double> base = in_doubles(queries_[0]);
    const std::vector<double> of_base = measures(position, in_batch);
    std::optional<OwnErrors> own_of_base;
    for (std::size_t i = 1; i < group_.size; ++i) {
      if (!verdicts_[i] || verdicts_[i] != verdicts_[0]) continue;
      const Numbers<double> image = in_doubles(queries_[i]);
      const bool is_scaled = group_.kind(i) == ImageKind::scale && group_.exponent != nullptr;
      const int exponent = is_scaled ? group_.exponent(precision_of<Real>, position / group_.size, i) : 0;
      const std::optional<ImageMap> map = image_map(entry, group_, i, exponent, base, image);
      if (!map) continue;
      const std::vector<double> of_image = measures(position + i, in_batch + i);
      ImageErrors errors = image_errors(predicate, entry, image, mapped_measures(predicate, *map, of_base), of_image);
      const ImagePair pair{position, position + i};
      ImageNumbers& numbers = found_.numbers;
      ++numbers.images;
      // Nothing beside `separated` is no fault: many kernels speak of contacts alone, or of those that are near.
      if (*verdicts_[0] == Verdict::separated && says_nothing(of_base) != says_nothing(of_image)) continue;
      numbers.compared += errors.any();
      // The exact numbers are asked for where they may take back what would be the worst so far.
      if (numbers.angle.would_take(errors.angle) || numbers.point.would_take(errors.point) ||
          errors.is_other_feature.value_or(false) || errors.has_lost_normal) {
        if (!own_of_base) own_of_base = own_errors_of(0, of_base);
        errors = at_most(errors, *own_of_base, own_errors_of(i, of_image));
      }
      numbers.separation.offer(errors.separation, pair);
      numbers.angle.offer(errors.angle, pair);
      numbers.point.offer(errors.point, pair);
      const bool is_other = errors.is_other_feature.value_or(false);
      numbers.compared_features += errors.is_other_feature.has_value();
      numbers.features += is_other;
      if (is_other && !numbers.first_feature) numbers.first_feature = pair;
      const bool is_lost = errors.is_lost || errors.has_lost_normal;
      numbers.lost += is_lost;
      if (is_lost && !numbers.first_lost) numbers.first_lost = pair;
    }
  }

  // The verdict of image i: separated where every part is, and in contact where any is.
  std::optional<Outcome> answer_of_parts(std::uint64_t position, std::size_t in_batch, std::size_t i) const {
    std::optional<Outcome> all;
    for (std::size_t part = i; part < i + group_.parts; ++part) {
      const std::optional<Outcome> one = answer(position + part, in_batch + part);
      if (!one) return std::nullopt;
      const bool decides = one->verdict == Verdict::contact ||
                           (one->verdict != Verdict::separated && all && all->verdict == Verdict::separated);
      if (!all || decides) all = one;
    }
    return all;
  }

  void count_image(const Outcome& base, const Outcome& image, const ImagePair& pair, std::size_t i) {
    if (!decides_image(group_.kind(i), base.verdict) || !are_compared(image.verdict, base.verdict)) return;
    ++found_.images;
    if (image.verdict != base.verdict) {
      ++found_.verdicts;
      if (!found_.first_verdict) found_.first_verdict = pair;
    }
    if (!image.bits || !base.bits || !of_base_[i]) return;
    ++found_.images_with_comparisons;
    if ((*of_base_[i])(*image.bits) != *base.bits) {
      ++found_.comparisons;
      if (!found_.first_comparison) found_.first_comparison = pair;
    }
  }

  const SeededSource& of_;
  const Kernel& kernel_;
  const StoredReplies* replies_;  // null: the kernel is asked
  const ImageGroup& group_;
  Implementation<Real> implementation_;
  QueryBatch<Real> batch_;
  Reply<Real> reply_;
  std::vector<std::optional<ComparisonsOfBase>> of_base_;  // by image; empty where comparisons are not compared
  std::vector<Numbers<Real>> queries_;                     // of the group at hand
  std::vector<std::optional<Verdict>> verdicts_;
  Asymmetry found_;
};

}  // namespace

std::optional<Asymmetry> asymmetry_of(const SeededSource& of, std::uint64_t queries, const Kernel& kernel,
                                      const StoredReplies* replies, const RunningOptions& running) {
  const ImageGroup* group = image_group(of.source.name());
  if (!group || !kernel.has(of.precision)) return std::nullopt;
  const std::uint64_t bases = std::min(queries, asymmetry_queries) / group->size;
  // Blocks as long as a unit of a run: foreign code is begun anew for each, and may hang in each.
  const std::uint64_t block_bases = unit_size / group->size;
  std::vector<Asymmetry> blocks((bases + block_bases - 1) / block_bases);
  const auto count = [&](std::size_t block) {
    const std::uint64_t first = block * block_bases, last = std::min(bases, first + block_bases);
    blocks[block] = of.precision == Precision::binary32
                        ? AsymmetryBlock<float>(of, kernel, replies, running.target, *group).count(first, last)
                        : AsymmetryBlock<double>(of, kernel, replies, running.target, *group).count(first, last);
  };
  tbb::task_arena arena(running.threads);
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, blocks.size(), count); });
  Asymmetry all;
  for (const Asymmetry& block : blocks) {
    all.images += block.images;
    all.verdicts += block.verdicts;
    all.images_with_comparisons += block.images_with_comparisons;
    all.comparisons += block.comparisons;
    if (!all.first_verdict) all.first_verdict = block.first_verdict;
    if (!all.first_comparison) all.first_comparison = block.first_comparison;
    all.invariance.merge(block.invariance);
    all.numbers.merge(block.numbers);
  }
  if (replies) return all;
  for (auto* flips : {&all.invariance.units.small, &all.invariance.units.large}) {
    narrow(of, kernel, running.target, *flips);
  }
  return all;
}

namespace {

std::optional<AddressPair> addresses_of(const std::optional<ImagePair>& pair, const AddressOf& address) {
  if (!pair) return std::nullopt;
  return AddressPair{address(pair->base), address(pair->image)};
}

AbsoluteSizeRecord size_record(const std::vector<UnitFlip>& flips, const std::vector<AbsoluteSize>& sizes) {
  AbsoluteSizeRecord record{flips.size(), {}};
  for (const AbsoluteSize& size : sizes)
    record.compared.push_back({size.quantity.text, size.quantity.degree, size.least, size.greatest, size.explains});
  return record;
}

}  // namespace

AsymmetryRecord asymmetry_record(const Asymmetry& asymmetry, const AddressOf& address, bool has_numbers) {
  AsymmetryRecord record{asymmetry.images,
                         asymmetry.verdicts,
                         asymmetry.images_with_comparisons,
                         asymmetry.comparisons,
                         addresses_of(asymmetry.first_verdict, address),
                         addresses_of(asymmetry.first_comparison, address),
                         {}};
  if (!has_numbers) return record;
  const ImageNumbers& numbers = asymmetry.numbers;
  const auto greatest = [](const WorstImage& worst) {
    return worst.compared == 0 ? std::nullopt : std::optional(worst.size);
  };
  record.numbers = {numbers.images,
                    numbers.compared,
                    numbers.separation.compared,
                    numbers.angle.compared,
                    numbers.point.compared,
                    numbers.compared_features,
                    numbers.lost,
                    numbers.compared_features == 0 ? std::nullopt : std::optional(numbers.features),
                    greatest(numbers.separation),
                    greatest(numbers.angle),
                    greatest(numbers.point),
                    addresses_of(numbers.separation.pair, address),
                    addresses_of(numbers.angle.pair, address),
                    addresses_of(numbers.point.pair, address),
                    addresses_of(numbers.first_feature, address),
                    addresses_of(numbers.first_lost, address)};
  return record;
}

std::map<ImageKind, ImageChangesRecord> invariance_record(
    const Invariance& invariance, const ImageGroup& group, Precision precision, const AddressOf& address,
    const std::function<std::vector<AbsoluteSize>(std::span<const UnitFlip>)>& sizes) {
  std::map<ImageKind, ImageChangesRecord> record;
  for (std::size_t i = 1; i < group.size; ++i) {
    const ImageKind kind = group.kind(i);
    const ImageChanges& changes = invariance.kinds[kind];
    record[kind] = {
        changes.images, changes.changed, changes.undecided, changes.by_size, addresses_of(changes.first, address),
        std::nullopt,   std::nullopt};
  }
  const auto scale = record.find(ImageKind::scale);
  if (scale == record.end()) return record;
  scale->second.range.emplace();
  if (group.range == nullptr) return record;
  const PowerRange range = group.range(precision);
  const UnitFaults& units = invariance.units;
  scale->second.range.emplace(PowerRangeRecord{range.least, range.greatest});
  scale->second.wrong = {units.wrong.changed, units.wrong.by_size, addresses_of(units.wrong.first, address),
                         size_record(units.small, sizes(units.small)), size_record(units.large, sizes(units.large))};
  return record;
}

}  // namespace axiscert
