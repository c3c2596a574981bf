#include "fuzz/sphere_triangle/clean_count.h"

#include <bit>

namespace axiscert {

void CleanCount::add_ties(ComparisonBits ties) {
  for_each_bit(ties, [&](std::size_t i) { ++ties_[i]; });
}

void CleanCount::add_to(Tally& tally) const {
  for (std::size_t axes = 0; axes < by_axes_.size(); ++axes) {
    tally.trials += by_axes_[axes];
    (axes != 0 ? tally.truth.separated : tally.truth.contact) += by_axes_[axes];
    if (std::has_single_bit(axes)) tally.axes[first_bit(axes)].sole_separator += by_axes_[axes];
  }
  tally.trials += separated_ + contact_;
  tally.truth.separated += separated_;
  tally.truth.contact += contact_;
  tally.truth.touching += touching_;
  for (std::size_t i = 0; i < comparison_count; ++i) tally.comparisons[i].ties += ties_[i];
}

}  // namespace axiscert
