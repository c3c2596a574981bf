#include "fuzz/confirm/absolute_size.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "fuzz/queries/capabilities.h"
#include "fuzz/queries/image_groups.h"
#include "kernel/ask.h"

namespace axiscert {
namespace {

struct Interval {
  double low, high;
};

// The first place where most of the closed intervals overlap.
AbsoluteSize overlap(const Quantity& quantity, const std::vector<Interval>& intervals) {
  struct End {
    double at;
    bool is_upper;
    bool operator<(const End& other) const { return at != other.at ? at < other.at : is_upper < other.is_upper; }
  };
  std::vector<End> ends;
  for (const Interval& interval : intervals) {
    ends.push_back({interval.low, false});
    ends.push_back({interval.high, true});
  }
  std::sort(ends.begin(), ends.end());
  AbsoluteSize best{quantity, 0, 0, 0};
  std::uint64_t open = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (ends[i].is_upper) {
      --open;
      continue;
    }
    if (++open <= best.explains) continue;
    // Between the last lower end and the next upper one.
    const auto upper = std::find_if(ends.begin() + static_cast<std::ptrdiff_t>(i), ends.end(),
                                    [](const End& end) { return end.is_upper; });
    best = {quantity, ends[i].at, upper->at, open};
  }
  return best;
}

// A base, and an image of it in another unit of length, which has the same axes and quaternions.
template <class Real>
struct InTwoUnits {
  Numbers<Real> base, image;

  Numbers<Real> times(int exponent) const {
    Numbers<Real> numbers = base;
    for (std::size_t k = 0; k < numbers.size(); ++k) {
      if (image[k] != base[k]) numbers[k] = std::ldexp(base[k], exponent);
    }
    return numbers;
  }
};
template <class Real>
InTwoUnits<Real> in_two_units(const SeededSource& of, std::uint64_t base) {
  const ImageGroup& group = *image_group(of.source.name());
  std::size_t i = 1;
  while (group.kind(i) != ImageKind::scale || group.exponent(of.precision, base / group.size, i) == 0) ++i;
  return {of.source.make<Real>(of.seed, base), of.source.make<Real>(of.seed, base + i)};
}

template <class Real>
void narrow_in(const SeededSource& of, const Kernel& kernel, const std::string& target, std::vector<UnitFlip>& flips) {
  const auto is_narrow = [](const UnitFlip& flip) { return std::abs(flip.right - flip.wrong) <= 1; };
  const Implementation<Real> implementation = kernel.on<Real>(target);
  Reply<Real> reply;
  std::vector<InTwoUnits<Real>> queries;
  for (const UnitFlip& flip : flips) queries.push_back(in_two_units<Real>(of, flip.base));
  for (;;) {
    QueryBatch<Real> batch(flips.size(), of.source.columns().size());
    std::vector<UnitFlip*> wide;
    for (std::size_t i = 0; i < flips.size(); ++i) {
      UnitFlip& flip = flips[i];
      if (is_narrow(flip)) continue;
      batch.push_back(queries[i].times((flip.right + flip.wrong) / 2));
      wide.push_back(&flip);
    }
    if (wide.empty()) return;
    ask(implementation, batch.columns(), reply);
    for (std::size_t i = 0; i < wide.size(); ++i) {
      const int middle = (wide[i]->right + wide[i]->wrong) / 2;
      (reply.verdicts[i] == wide[i]->truth ? wide[i]->right : wide[i]->wrong) = middle;
    }
  }
}

template <class Real>
std::vector<AbsoluteSize> sizes_in(const SeededSource& of, std::span<const UnitFlip> flips,
                                   const Quantities& quantities) {
  std::vector<MeasuredFlip> measured;
  const std::size_t entry = of.source.entry();
  for (const UnitFlip& flip : flips)
    measured.push_back({quantities.values(entry, of.source.make<Real>(of.seed, flip.base)), flip.right, flip.wrong});
  return absolute_sizes(quantities.all, measured);
}

}  // namespace

void narrow(const SeededSource& of, const Kernel& kernel, const std::string& target, std::vector<UnitFlip>& flips) {
  if (flips.empty() || capabilities_of(of.source.predicate()).quantities == nullptr) return;
  if (of.precision == Precision::binary32) narrow_in<float>(of, kernel, target, flips);
  else narrow_in<double>(of, kernel, target, flips);
}

std::vector<AbsoluteSize> absolute_sizes(std::span<const Quantity> quantities, std::span<const MeasuredFlip> flips) {
  std::vector<AbsoluteSize> sizes;
  for (std::size_t k = 0; k < quantities.size(); ++k) {
    const int degree = quantities[k].degree;
    std::vector<Interval> intervals;
    for (const MeasuredFlip& flip : flips) {
      const double value = flip.values[k];
      const auto [low, high] = std::minmax(flip.right, flip.wrong);
      if (value > 0 && std::isfinite(value))
        intervals.push_back({std::ldexp(value, degree * low), std::ldexp(value, degree * high)});
    }
    const AbsoluteSize size = overlap(quantities[k], intervals);
    if (size.explains * 4 >= flips.size() * 3 && size.explains > 0) sizes.push_back(size);
  }
  // A number that two quantities pass together is compared with one of them: the simpler is named first.
  std::stable_sort(sizes.begin(), sizes.end(), [](const AbsoluteSize& x, const AbsoluteSize& y) {
    const auto rank = [](const AbsoluteSize& size) {
      return std::tuple(-static_cast<double>(size.explains), size.quantity.is_of_scene, size.quantity.degree);
    };
    return rank(x) < rank(y);
  });
  constexpr std::size_t most = 3;
  const auto worse = std::find_if(sizes.begin(), sizes.end(),
                                  [&](const AbsoluteSize& size) { return size.explains < sizes.front().explains; });
  sizes.erase(worse, sizes.end());
  if (sizes.size() > most) sizes.resize(most);
  return sizes;
}

std::vector<AbsoluteSize> absolute_sizes(const SeededSource& of, std::span<const UnitFlip> flips) {
  const Quantities* const quantities = capabilities_of(of.source.predicate()).quantities;
  if (quantities == nullptr) return {};
  return of.precision == Precision::binary32 ? sizes_in<float>(of, flips, *quantities)
                                             : sizes_in<double>(of, flips, *quantities);
}

}  // namespace axiscert
