// The filter that is proved never to answer wrongly (docs/proofs.md, proofs/coq/formulae/Filter.v), over any set of
// formulae with a table of thresholds and any number type: the program of the theorem, operation by operation.
//
// It has three answers. lhs > rhs is certain where lhs - rhs, as computed, exceeds n u m^degree, as computed; lhs < rhs
// where it is below the negative of that. `separated`: all comparisons of some axis are certain. `contact`: on each
// axis the opposite of some comparison is certain. Otherwise, and wherever m is outside its window, r < 0 or a number
// is not finite: `undecided`.
//
// A number type T has magnitude(x), negated(x), greater_of(x, y), constant_as(x, c), and the relations less(x, y) and
// at_most(x, y), false if either is NaN, whose results are combined by both(p, q) and either(p, q). There is no include
// guard for AXISCERT_PER_TARGET; kernel/base/geometry.h says why.
#if defined(AXISCERT_PER_TARGET) || !defined(AXISCERT_KERNEL_FILTER_FILTER_H)
#define AXISCERT_KERNEL_FILTER_FILTER_H

#include "kernel/sphere_triangle/forms/filter_thresholds.h"
#include "kernel/sphere_triangle/forms/reduced.h"

AXISCERT_BEFORE_NAMESPACE();
namespace axiscert {
namespace AXISCERT_TARGET {

struct PublishedFilter {
  using Formulae = PublishedFormulae;
  static constexpr auto thresholds = filter::published_thresholds;
};
struct ReducedFilter {
  using Formulae = ReducedFormulae;
  static constexpr auto thresholds = filter::reduced_thresholds;
};

// Certain answers to a query, or to each lane's query. If both are false, the query is undecided.
template <class Mask>
struct Certain {
  Mask separated, contact;
};

// m, the greatest magnitude of a translated coordinate and the radius; and whether the query is inside the window.
template <class T, class Mask>
struct Magnitude {
  T m;
  Mask inside;
};
template <class Real, class T>
AXISCERT_INLINE auto greatest_magnitude_of(const Problem<T>& query) {
  const CentredProblem<T> vertices = centred(query);
  const T least = constant_as(query.r, filter::least_magnitude<Real>);
  const T greatest = constant_as(query.r, filter::greatest_magnitude<Real>);
  Magnitude<T, decltype(less(query.r, query.r))> found{query.r,
                                                       both(at_most(query.zero, query.r), at_most(query.r, greatest))};
  for (const Vec3<T>& v : std::array{vertices.a, vertices.b, vertices.c}) {
    for (const T& x : std::array{v.x, v.y, v.z}) {
      const T size = magnitude(x);
      found.m = greater_of(found.m, size);
      found.inside = both(found.inside, at_most(size, greatest));
    }
  }
  found.inside = both(found.inside, at_most(least, found.m));
  return found;
}

// Takes the sixteen comparisons in their order; those of an axis come one after the other.
template <class Filter, class Real, class T, class Mask>
struct FilterSink {
  T m2, m4, m6;
  Mask separated{}, contact{};     // over the axes so far: some separates; none can
  Mask all_greater{}, any_less{};  // on the present axis

  AXISCERT_INLINE explicit FilterSink(const T& m) : m2(m * m), m4(m2 * m2), m6(m4 * m2) {}

  AXISCERT_INLINE void operator()(Comparison which, const T& lhs, const T& rhs) {
    const auto k = index_of(which);
    constexpr auto thresholds = Filter::thresholds;  // a copy, which code for a GPU can index
    const auto [n, degree] = thresholds[k];
    constexpr Real u = sizeof(Real) == 4 ? static_cast<Real>(0x1p-24) : static_cast<Real>(0x1p-53);
    const T limit = constant_as(m2, static_cast<Real>(n) * u) * (degree == 2 ? m2 : degree == 4 ? m4 : m6);
    const T margin = lhs - rhs;
    const Mask greater = less(limit, margin), lesser = less(margin, negated(limit));
    const bool first = is_radius(which);
    all_greater = first ? greater : both(all_greater, greater);
    any_less = first ? lesser : either(any_less, lesser);
    if (k + 1 < comparison_count && !is_radius(static_cast<Comparison>(k + 1))) return;
    separated = which == Comparison::plane_radius ? all_greater : either(separated, all_greater);
    contact = which == Comparison::plane_radius ? any_less : both(contact, any_less);
  }
};

template <class Filter, class Real, class T>
AXISCERT_INLINE auto filter_answer(const Problem<T>& query) {
  const auto [m, inside] = greatest_magnitude_of<Real>(query);
  using Mask = decltype(less(m, m));
  FilterSink<Filter, Real, T, Mask> sink(m);
  Filter::Formulae::comparisons(query, sink);
  // `separated` has precedence over `contact`, as in the theorem; no query has both.
  return Certain<Mask>{both(inside, sink.separated), both(inside, sink.contact)};
}

}  // namespace AXISCERT_TARGET
}  // namespace axiscert
AXISCERT_AFTER_NAMESPACE();
#endif
