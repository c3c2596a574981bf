#include "fuzz/sphere_triangle/search_evaluator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "exact/sphere_triangle/measures/critical_radius.h"
#include "exact/numbers/double_double.h"
#include "exact/sphere_triangle/oracles/second_oracle.h"
#include "exact/numbers/floating.h"
#include "fuzz/search/moves.h"
#include "fuzz/sphere_triangle/search_ranges.h"
#include "kernel/formulae_list.h"
#include "kernel/sphere_triangle/forms/scalar.h"
#include "kernel/sphere_triangle/forms/simd.h"
#include "kernel/sphere_triangle/forms/formulae_types.h"

namespace axiscert {
namespace {

// l - r as an unevaluated sum, and |l| + |r|.
struct WideMargin {
  double high, low, size;
};

WideMargin wide_margin(const Floating& l, const Floating& r) {
  const Floating margin = l - r;
  const double high = mpfr_get_d(margin.get(), MPFR_RNDN);
  return {high, mpfr_get_d((margin - Floating(high)).get(), MPFR_RNDN),
          std::fabs(mpfr_get_d(l.get(), MPFR_RNDN)) + std::fabs(mpfr_get_d(r.get(), MPFR_RNDN))};
}

// Numbers of several queries side by side, in the compiler's own vector type. Lane by lane the operations of double.
constexpr std::size_t lane_count = 2;
struct Lanes {
  using Vector [[gnu::vector_size(lane_count * sizeof(double))]] = double;
  Vector v;
  Lanes() = default;
  AXISCERT_INLINE explicit Lanes(const Vector& lanes) : v(lanes) {}
  AXISCERT_INLINE explicit Lanes(double x) : v(Vector{} + x) {}
  AXISCERT_INLINE Lanes operator-() const { return Lanes(-v); }
  AXISCERT_INLINE friend Lanes operator+(const Lanes& a, const Lanes& b) { return Lanes(a.v + b.v); }
  AXISCERT_INLINE friend Lanes operator-(const Lanes& a, const Lanes& b) { return Lanes(a.v - b.v); }
  AXISCERT_INLINE friend Lanes operator*(const Lanes& a, const Lanes& b) { return Lanes(a.v * b.v); }
};

// Margins of the queries in a vector's lanes, those from `first` on, in twice binary64. The last vector may have fewer.
template <Formulae formulae>
void evaluate_margins_in_lanes(std::size_t which, const QueryColumns<double>& columns, std::size_t first,
                               WideMargin* margins) {
  using T = DoubleDouble<Lanes>;
  const std::size_t lanes = std::min(lane_count, columns.size - first);
  const auto number = [&](std::size_t k) {
    T x{};
    for (std::size_t i = 0; i < lanes; ++i) x.high.v[i] = columns.column[k][first + i];
    return x;
  };
  const auto vec = [&](std::size_t k) { return Vec3<T>{number(k), number(k + 1), number(k + 2)}; };
  const auto sides =
      sides_of<FormulaeType<formulae>>(portable::Problem<T>{vec(0), vec(3), vec(6), vec(9), number(12), T{}});
  const T &l = sides.lhs[which], &r = sides.rhs[which], margin = l - r;
  for (std::size_t i = 0; i < lanes; ++i) {
    margins[first + i] = {margin.high.v[i], margin.low.v[i], std::fabs(l.high.v[i]) + std::fabs(r.high.v[i])};
  }
}

// Margins of a batch of binary64 queries: rings in twice binary64, forms with roots or divisions by MPFR.
template <Formulae formulae>
void evaluate_twice_wide(std::size_t which, const QueryBatch<double>& batch, std::vector<WideMargin>& margins) {
  using F = FormulaeType<formulae>;
  margins.assign(batch.size(), {0, 0, 0});
  if constexpr (!has_comparisons(formulae)) {
    return;
  } else if constexpr (F::is_ring) {
    const auto columns = batch.columns();
    for (std::size_t first = 0; first < batch.size(); first += lane_count)
      evaluate_margins_in_lanes<formulae>(which, columns, first, margins.data());
  } else {
    const FloatingScope scope({128, Rounding::nearest, std::nullopt});
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const auto sides = sides_of<F>(problem_as<Floating>(query_from(batch[i]), [](double x) { return Floating(x); }));
      margins[i] = wide_margin(sides.lhs[which], sides.rhs[which]);
    }
  }
}

using WideFunction = void (*)(std::size_t, const QueryBatch<double>&, std::vector<WideMargin>&);
constexpr EnumArray<Formulae, WideFunction> twice_wide_of = {
#define AXISCERT_WIDE(name, type, kind) evaluate_twice_wide<Formulae::name>,
    AXISCERT_FORMULAE(AXISCERT_WIDE)
#undef AXISCERT_WIDE
};

// |(l^ - r^) - margin|.
double difference(double l, double r, const WideMargin& margin) {
  const auto computed = arithmetic::two_sum(l, -r);
  return std::fabs((computed.value - margin.high) + (computed.error - margin.low));
}

// Estimates of relative errors are accurate up to this ratio. With T the greatest of the numbers that cancelled, an
// error is about u T, and the estimate of the sides errs by u^2 T or slightly more: sides of 2^-40 u T are still known
// to many digits.
constexpr double greatest_ratio = 0x1p40;

double score_of(const Aim& aim, double difference, double size, int digits) {
  if (!std::isfinite(difference)) return 0;
  const double in_u = std::ldexp(difference, digits);
  if (aim.goal == Goal::error) return in_u;
  return size > 0 && in_u < greatest_ratio * size ? in_u / size : 0;
}

using Twice = DoubleDouble<double>;

template <class T>
T number_as(double x) {
  if constexpr (std::is_same_v<T, double>) return x;
  else return T{x, 0};
}
double leading(double x) { return x; }
double leading(const Twice& x) { return x.high; }

// The distance from p to the triangle, and the greatest distance from p to a vertex.
struct Distances {
  double nearest, farthest;
};
template <class T, class Real>
Distances distances(const Query<Real>& q) {
  auto t = centred_as<T>(q, [](Real x) { return number_as<T>(static_cast<double>(x)); });
  const auto order = [](const T& x, const T& y) {
    const double d = leading(x - y);
    return (d > 0) - (d < 0);
  };
  const auto squared = walked_squared_distance(t, number_as<T>(0), number_as<T>(1), order);
  const auto length = [](const Vec3<T>& v) { return std::sqrt(leading(dot(v, v))); };
  return {std::sqrt(std::max(leading(squared.numerator), 0.0) / leading(squared.denominator)),
          std::max({length(t.a), length(t.b), length(t.c)})};
}

}  // namespace

template <class Real>
Evaluator<Real>::Evaluator(const Kernel& kernel, std::string_view target)
    : Guide<Real>(shape_of(kernel.predicate->entries[kernel.entry])),
      kernel_(kernel),
      implementation_(kernel.on<Real>(target)) {
  if constexpr (sizeof(Real) == 4) {
    if (const SimdForms* forms = formulae_of(kernel) == Formulae::none ? nullptr : simd_forms(formulae_of(kernel));
        forms && !simd_targets().empty()) {
      wide_ = forms->on<double>(simd_targets().front(), Strictness::strict);
    }
  }
}

template <class Real>
void Evaluator<Real>::evaluate(const Aim& aim, QueryBatch<Real>& batch, std::vector<double>& scores,
                               std::vector<Verdict>& said) {
  scores.assign(batch.size(), 0);
  if (is_about_range(aim.goal)) evaluate_range(aim, batch, scores);
  else if (is_about_a_comparison(aim.goal)) evaluate_error(aim, batch, scores);
  else evaluate_radius(aim.goal, batch, scores);
  said.assign(batch.size(), Verdict::unanswered);
  implementation_.verdicts(batch.columns(), said.data());
}

template <class Real>
void Evaluator<Real>::evaluate_error(const Aim& aim, const QueryBatch<Real>& batch, std::vector<double>& scores) {
  const std::size_t k = aim.which;
  if (implementation_.explain) {
    reply_.answers.resize(batch.size(), comparison_count);
    implementation_.explain(batch.columns(), reply_.answers);
  } else {
    ask(implementation_, batch.columns(), reply_);
    if (!reply_.has_bits) return;
  }
  constexpr int digits = std::numeric_limits<Real>::digits;
  if constexpr (sizeof(Real) == 4) {
    if (wide_.explain) {
      if (widened_.capacity() < batch.size()) widened_ = QueryBatch<double>(batch.capacity(), coordinate_count);
      widened_.resize(batch.size());
      const auto from = batch.columns();
      const auto to = widened_.mutable_columns();
      for (std::size_t c = 0; c < coordinate_count; ++c) {
        std::copy_n(from.column[c], batch.size(), to.column[c]);
      }
      wide_answers_.resize(batch.size(), comparison_count);
      wide_.explain(widened_.columns(), wide_answers_);
    }
  }
  std::vector<WideMargin> margins;
  if constexpr (sizeof(Real) == 8) twice_wide_of[formulae_of(kernel_)](aim.which, batch, margins);
  for (std::size_t i = 0; i < batch.size(); ++i) {
    WideMargin margin;
    if constexpr (sizeof(Real) == 4) {
      double l, r;
      if (wide_.explain) {
        l = wide_answers_.lhs[k][i];
        r = wide_answers_.rhs[k][i];
      } else {
        Sides<double> sides;
        reference(formulae_of(kernel_), Arithmetic::plain, Strictness::strict, widened(batch[i]), &sides);
        l = sides.lhs[k];
        r = sides.rhs[k];
      }
      margin = {l - r, 0, std::fabs(l) + std::fabs(r)};
    } else {
      margin = margins[i];
    }
    const double error = difference(reply_.answers.lhs[k][i], reply_.answers.rhs[k][i], margin);
    judged_ += std::isfinite(error);
    scores[i] = score_of(aim, error, margin.size, digits);
  }
}

template <class Real>
void Evaluator<Real>::evaluate_radius(Goal goal, QueryBatch<Real>& batch, std::vector<double>& scores) {
  std::vector<Query<Real>> queries;
  for (std::size_t i = 0; i < batch.size(); ++i) queries.push_back(batch[i]);
  const RadiusRange<Real> range{0, 4};  // the scene is of size 1
  const auto found = critical_radii(implementation_, queries, range);
  const auto out = batch.mutable_columns();
  for (std::size_t i = 0; i < queries.size(); ++i) {
    if (!found[i].answered || (goal == Goal::critical_radius && found[i].not_decided)) continue;
    const bool bounded = found[i].radius.has_value();
    const Real contact = bounded ? *found[i].radius : range.greatest;
    const auto [d, farthest] = goal == Goal::critical_radius || sizeof(Real) == 8 ? distances<Twice>(queries[i])
                                                                                  : distances<double>(queries[i]);
    const auto depth = [&](double r) { return std::fabs(d - r) / std::max(farthest, r); };
    double score = 0;
    Real r = contact;
    if (goal == Goal::missed_contact) {
      r = bounded ? std::nextafter(contact, Real(0)) : contact;
      if (contact > 0 && r > d) score = depth(r);
    } else if (goal == Goal::phantom_contact) {
      if (bounded && contact < d) score = depth(contact);
    } else {
      const Real near = static_cast<Real>(d);
      const double ulp = double(std::nextafter(near, Real(8))) - double(near);
      score = std::fabs(contact - d) / ulp;
    }
    out.column[coordinate_count - 1][i] = r;
    scores[i] = std::isfinite(score) ? score : 0;
  }
}

template <class Real>
void Evaluator<Real>::evaluate_range(const Aim& aim, const QueryBatch<Real>& batch, std::vector<double>& scores) {
  const auto left = range_left(implementation_, aim, batch);
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (left[i]) scores[i] = range_score(aim.goal, precision_of<Real>, *left[i]);
  }
}

template <class Real>
double Evaluator<Real>::vanishing(std::size_t which, const Query<Real>& q) const {
  Sides<double> sides;
  reference(formulae_of(kernel_), Arithmetic::plain, Strictness::strict, widened(q), &sides);
  return comparisons[which].is_radius ? sides.lhs[which] : sides.lhs[which] - sides.rhs[which];
}

template <class Real>
void Evaluator<Real>::settle(Numbers<Real>& q) const {
  Query<Real> settled = q;
  axiscert::settle(settled);
  q = settled;
}

// Moves one number to where the comparison's scale vanishes, by one Newton step, which is exact if the margin is affine
// in the number; then by a few ulps.
template <class Real>
bool Evaluator<Real>::step(const Aim& aim, Dice& random, Numbers<Real>& q) const {
  if (aim.goal != Goal::relative_error || random.below(8) != 0) return false;
  Real& x = q[random.below(q.size())];
  const Real start = x;
  const double here = vanishing(aim.which, query_from(q));
  const double by = start == 0 ? 0x1p-12 : double(start) * 0x1p-12;
  x = static_cast<Real>(start + by);
  const double slope = (vanishing(aim.which, query_from(q)) - here) / (double(x) - double(start));
  const double root = start - here / slope;
  x = std::fabs(root) <= 4 ? moved_by_ulps(static_cast<Real>(root), random.integer(-3, 3)) : start;
  return true;
}

template <class Real>
std::vector<Numbers<Real>> Evaluator<Real>::images(const Numbers<Real>& numbers) const {
  const Query<Real> q = numbers;
  std::vector<Numbers<Real>> all;
  for (const auto& [a, b, c] : {std::tuple(q.a, q.b, q.c), std::tuple(q.a, q.c, q.b), std::tuple(q.b, q.a, q.c),
                                std::tuple(q.b, q.c, q.a), std::tuple(q.c, q.a, q.b), std::tuple(q.c, q.b, q.a)}) {
    all.push_back(Query<Real>{a, b, c, q.p, q.r});
  }
  return all;
}

template class Evaluator<float>;
template class Evaluator<double>;

}  // namespace axiscert
