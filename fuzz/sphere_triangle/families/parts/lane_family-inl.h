// A family in lanes: F::make(random, first) makes the queries of one vector, and F::finish solves, one query at a time,
// whatever needs exact arithmetic.
#include "fuzz/sphere_triangle/families/parts/lane_shapes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert {
namespace HWY_NAMESPACE {

// Stores lanes to the entries from `i` on of the columns and the wishes. Nothing is written beyond the columns' size.
template <class Real, class T>
AXISCERT_INLINE void store(const LaneQuery<T>& q, const MutableColumns<Real>& out, std::size_t i) {
  const hn::ScalableTag<Real> d;
  constexpr std::size_t lanes = hn::MaxLanes(hn::ScalableTag<Real>());
  const T numbers[coordinate_count] = {q.v[0].x, q.v[0].y, q.v[0].z, q.v[1].x, q.v[1].y, q.v[1].z, q.v[2].x,
                                       q.v[2].y, q.v[2].z, q.p.x,    q.p.y,    q.p.z,    q.r};
  if (i + lanes <= out.size) {
    for (std::size_t k = 0; k < coordinate_count; ++k) hn::StoreU(numbers[k].v, d, out.column[k] + i);
    return;
  }
  for (std::size_t k = 0; k < coordinate_count; ++k) {
    HWY_ALIGN Real whole[lanes];
    hn::Store(numbers[k].v, d, whole);
    std::memcpy(out.column[k] + i, whole, (out.size - i) * sizeof(Real));
  }
}

template <class F, class Real>
void fill_lanes(const StreamName& name, std::uint64_t first, const MutableColumns<Real>& out) {
  using Random = LaneStream<Real>;
  for (std::size_t begin = 0; begin < out.size; begin += shapes::block_size) {
    const auto block = out.part(begin, std::min(shapes::block_size, out.size - begin));
    HWY_ALIGN shapes::Wishes<Real> wishes;
    for (std::size_t i = 0; i < block.size; i += Random::lanes) {
      Random random(name, first + begin + i);
      const auto q = F::make(random, first + begin + i);
      store(q, block, i);
      if constexpr (F::solves) {
        for (std::size_t k = 0; k < wishes.size(); ++k) hn::Store(q.wishes[k].v, typename Random::D(), &wishes[k][i]);
      }
    }
    if constexpr (F::solves) F::finish(first + begin, block, wishes);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace axiscert
HWY_AFTER_NAMESPACE();

// Defines NAME_queries<Real>, which Family takes, in HWY_NAMESPACE and, under HWY_ONCE, in axiscert.
#undef AXISCERT_FILL
#define AXISCERT_FILL(NAME, F)                                                                    \
  void NAME##32(const StreamName& name, std::uint64_t first, const MutableColumns<float>& out) {  \
    fill_lanes<F>(name, first, out);                                                              \
  }                                                                                               \
  void NAME##64(const StreamName& name, std::uint64_t first, const MutableColumns<double>& out) { \
    fill_lanes<F>(name, first, out);                                                              \
  }
#undef AXISCERT_DISPATCH_FILL
#define AXISCERT_DISPATCH_FILL(NAME)                                                                         \
  HWY_EXPORT(NAME##32);                                                                                      \
  HWY_EXPORT(NAME##64);                                                                                      \
  template <class Real>                                                                                      \
  static void NAME##_queries(const StreamName& name, std::uint64_t first, const MutableColumns<Real>& out) { \
    if constexpr (sizeof(Real) == 4) HWY_DYNAMIC_DISPATCH(NAME##32)(name, first, out);                       \
    else HWY_DYNAMIC_DISPATCH(NAME##64)(name, first, out);                                                   \
  }
