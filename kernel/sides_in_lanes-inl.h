// The comparisons of a predicate's formulae in the lanes of Highway's vectors, for the instruction set that
// foreach_target is compiling: what holds, the sides, and the bits of each query. The including file has defined
// AXISCERT_PER_TARGET.
#include "kernel/lanes-inl.h"
#include "kernel/formulae_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert {
namespace HWY_NAMESPACE {

// i is a constant to the compiler wherever a sink is called.
template <class F, class T>
AXISCERT_INLINE auto comparison_holds(std::size_t i, const T& lhs, const T& rhs) {
  return has_bit(nonstrict_comparisons<F>(), i) ? lhs >= rhs : lhs > rhs;
}

// Writes the sides, and collects the comparison bits of each lane in words of its width: two of them for binary32.
template <class D, class F>
struct SidesInLanes {
  using Real = hn::TFromD<D>;
  using Words = hn::RebindToUnsigned<D>;
  using Word = hn::TFromD<Words>;
  static constexpr std::size_t lanes = hn::MaxLanes(D()), width = 8 * sizeof(Real);
  Answers<Real>& out;
  std::size_t first, count;  // the first query, and the number of lanes that are queries
  hn::Vec<Words> low, high;

  template <class T>
  AXISCERT_INLINE void operator()(std::size_t i, const T& lhs, const T& rhs) {
    store_lanes(D(), lhs.v, count, out.lhs[i].data() + first);
    store_lanes(D(), rhs.v, count, out.rhs[i].data() + first);
    const auto bit = hn::BitCast(D(), hn::Set(Words(), one_bit<Word>(i % width)));
    const auto held = hn::BitCast(Words(), hn::IfThenElseZero(comparison_holds<F>(i, lhs, rhs).m, bit));
    if (i < width) low = hn::Or(low, held);
    else high = hn::Or(high, held);
  }
  AXISCERT_INLINE void store_bits() const {
    Word least[lanes], greatest[lanes];
    hn::StoreU(low, Words(), least);
    hn::StoreU(high, Words(), greatest);
    for (std::size_t j = 0; j < count; ++j) {
      ComparisonBits bits = least[j];
      if constexpr (width < 64) bits |= static_cast<ComparisonBits>(greatest[j]) << width;
      out.bits[first + j] = bits;
    }
  }
};

// Sides and bits of a batch. Load::problem(d, batch, i) is the predicate's problem of the queries from i on, in lanes.
template <class F, class Load, class Real>
void explain_in_lanes(const QueryColumns<Real>& batch, Answers<Real>& out) {
  using D = hn::ScalableTag<Real>;
  for_each_vector(batch,
                  [&](const QueryColumns<Real>& from, std::size_t at, std::size_t i, std::size_t count) HWY_ATTR {
                    const auto zero = hn::Zero(hn::RebindToUnsigned<D>());
                    SidesInLanes<D, F> sink{out, i, count, zero, zero};
                    F::template comparisons<LanesOf<D>>(Load::problem(D(), from, at), sink);
                    sink.store_bits();
                  });
}

}  // namespace HWY_NAMESPACE
}  // namespace axiscert
HWY_AFTER_NAMESPACE();
