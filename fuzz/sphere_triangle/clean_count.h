// Queries on which a kernel's verdict, axes and comparisons are all as in exact arithmetic, and its verdict right.
#pragma once

#include <array>

#include "fuzz/campaign/counts/tally.h"
#include "kernel/sphere_triangle/decision.h"

namespace axiscert {

class CleanCount {
 public:
  // `axes` are the separating ones.
  void add(AxisBits axes, ComparisonBits ties, bool touching) {
    ++by_axes_[axes];
    touching_ += touching;
    if (ties != 0) add_ties(ties);
  }
  // The same for a kernel that claims no formulae.
  void add_verdict(Verdict verdict, bool touching) {
    ++(verdict == Verdict::separated ? separated_ : contact_);
    touching_ += touching;
  }
  void add_to(Tally& tally) const;

 private:
  void add_ties(ComparisonBits ties);
  std::array<std::uint64_t, std::size_t{1} << axis_count> by_axes_{};
  std::array<std::uint64_t, comparison_count> ties_{};
  std::uint64_t separated_ = 0, contact_ = 0, touching_ = 0;
};

}  // namespace axiscert
