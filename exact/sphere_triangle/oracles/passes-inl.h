// The two passes over a batch: signs, and errors of computed sides. No guard: included once for each of Highway's
// instruction sets.
#include <cstring>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace axiscert {
namespace HWY_NAMESPACE {

template <class Real>
using FilterNumber = std::conditional_t<sizeof(Real) == 4, DoubleLanes, PairLanes>;

inline constexpr std::size_t lane_count = hn::MaxLanes(D());

AXISCERT_INLINE V load_double(const float* from) {
  const hn::Rebind<float, D> half;
  return hn::PromoteTo(D(), hn::LoadU(half, from));
}
AXISCERT_INLINE V load_double(const double* from) { return hn::LoadU(D(), from); }

template <class Real>
AXISCERT_INLINE RawQuery load_query(const QueryColumns<Real>& batch, std::size_t i) {
  const auto lanes = [&](std::size_t k) HWY_ATTR { return load_double(batch.column[k] + i); };
  return {{lanes(0), lanes(1), lanes(2)},
          {lanes(3), lanes(4), lanes(5)},
          {lanes(6), lanes(7), lanes(8)},
          {lanes(9), lanes(10), lanes(11)},
          lanes(12)};
}

// Finite, r >= 0: x * 0 is not 0 if x is not finite.
AXISCERT_INLINE M is_valid(const RawQuery& q) {
  const V zero = hn::Zero(D());
  V sum = hn::Mul(q.r, zero);
  for (const Vec3<V>* v : {&q.a, &q.b, &q.c, &q.p}) {
    sum = hn::Add(sum, hn::Add(hn::Add(hn::Mul(v->x, zero), hn::Mul(v->y, zero)), hn::Mul(v->z, zero)));
  }
  return hn::And(hn::Eq(sum, zero), hn::Ge(q.r, zero));
}

// One 64-bit word per lane: strict in bits 0 to 15, ties from 16, certain from 32, valid 48, close 56: the layout of
// FilteredSigns.
inline constexpr int ties_at = 16, certain_at = 32, valid_at = 48, close_at = 56;

AXISCERT_INLINE V word(M mask, std::uint64_t bits) {
  return hn::IfThenElseZero(mask, hn::BitCast(D(), hn::Set(hn::RebindToUnsigned<D>(), bits)));
}

// Records which of all sixteen signs are certain, and their values.
template <class T>
struct SignSink {
  FilterFault fault;
  V words, nearest;  // nearest: the least |margin| - 2^10 bound of certain signs that are not ties

  AXISCERT_INLINE explicit SignSink(FilterFault planted) : fault(planted), words(hn::Zero(D())), nearest(constant(1)) {}
  AXISCERT_INLINE void operator()(Comparison which, const Margin<T>& margin) {
    const V zero = hn::Zero(D()), value = margin.value.leading();
    const V bound = times(margin.bound, constant(fault == FilterFault::small_bound ? 0x1p-12 : 1));
    const V size = hn::Abs(value);
    const M decided = hn::Gt(size, bound);
    const bool swapped = fault == FilterFault::swapped_sign && which == Comparison::edge_bc_side_a;
    const M strict = hn::And(decided, hn::Gt(swapped ? hn::Neg(value) : value, zero));
    const M tie = hn::Eq(plus(size, bound), zero);
    const std::uint64_t bit = one_bit<std::uint64_t>(which);
    words = hn::Or(words, hn::Or(word(strict, bit), word(hn::Or(decided, tie), bit << certain_at)));
    words = hn::Or(words, word(tie, bit << ties_at));
    const V beyond = hn::Sub(size, times(bound, constant(0x1p10)));
    nearest = hn::Min(nearest, hn::IfThenElse(tie, nearest, beyond));
  }
};

template <class Real>
HWY_NOINLINE void signs_of_vector(const QueryColumns<Real>& batch, std::size_t at, bool wants_close, FilterFault fault,
                                  std::uint64_t* out) {
  using T = FilterNumber<Real>;
  const RawQuery q = load_query(batch, at);
  const Margins<EdgeForm::reduced, T> margins(q);
  SignSink<T> sink(fault);
  margins.emit_all(sink);
  V words = sink.words;
  if (sizeof(Real) == 8 && fault != FilterFault::no_underflow_guard) {
    words = hn::IfThenElseZero(margins.in_range(), words);
  }
  words = hn::Or(words, word(is_valid(q), std::uint64_t{1} << valid_at));
  const std::uint64_t close = wants_close ? std::uint64_t{1} << close_at : 0;
  words = hn::Or(words, word(hn::Lt(sink.nearest, hn::Zero(D())), close));
  hn::StoreU(hn::BitCast(hn::RebindToUnsigned<D>(), words), hn::RebindToUnsigned<D>(), out);
}

// The same for a vector whose signs are all certain in doubles and not ties, as in most vectors.
template <bool planted>
struct SettledSignSink {
  FilterFault fault;
  V words, slack;  // slack: the least |margin| - bound

  AXISCERT_INLINE explicit SettledSignSink(FilterFault of) : fault(of), words(hn::Zero(D())), slack(constant(1)) {}
  AXISCERT_INLINE void operator()(Comparison which, const Margin<DoubleLanes>& margin) {
    V value = margin.value.leading(), bound = margin.bound;
    if constexpr (planted) {
      if (fault == FilterFault::small_bound) bound = times(bound, constant(0x1p-12));
      if (fault == FilterFault::swapped_sign && which == Comparison::edge_bc_side_a) value = hn::Neg(value);
    }
    words = hn::Or(words, word(hn::Gt(value, hn::Zero(D())), one_bit<std::uint64_t>(which)));
    slack = hn::Min(slack, hn::Sub(hn::Abs(value), bound));
  }
};

// Returns whether the vector is such a one; if not, `out` is unspecified.
template <bool planted, class Real>
AXISCERT_INLINE bool settled_signs_of_vector(const QueryColumns<Real>& batch, std::size_t at, FilterFault fault,
                                             std::uint64_t* out) {
  const Margins<EdgeForm::reduced, DoubleLanes> margins(load_query(batch, at));
  SettledSignSink<planted> sink(fault);
  margins.emit_all(sink);
  M good = hn::And(hn::Gt(sink.slack, hn::Zero(D())), margins.is_valid());
  const bool has_guard = sizeof(Real) == 8 && !(planted && fault == FilterFault::no_underflow_guard);
  if (has_guard) good = hn::And(good, margins.in_range());
  constexpr std::uint64_t all = 0xffffull << certain_at | 1ull << valid_at;
  const hn::RebindToUnsigned<D> du;
  hn::StoreU(hn::Or(hn::BitCast(du, sink.words), hn::Set(du, all)), du, out);
  return hn::AllTrue(D(), good);
}

// Each word has the bytes of a FilteredSigns.
static_assert(sizeof(FilteredSigns) == sizeof(std::uint64_t) && std::endian::native == std::endian::little);

template <class Real>
void filter_signs(const QueryColumns<Real>& batch, FilterFault fault, FilteredSigns* out) {
  std::uint64_t words[lane_count];
  std::size_t i = 0;
  for (; i + lane_count <= batch.size; i += lane_count) {
    // Not the first block: every 4096th query begins a batch, and has to check the first pass too.
    const bool wants_close = i / close_call_block % close_call_stride == close_call_stride - 1;
    const bool is_settled =
        !wants_close && (fault == FilterFault::none ? settled_signs_of_vector<false>(batch, i, fault, words)
                                                    : settled_signs_of_vector<true>(batch, i, fault, words));
    if (!is_settled) signs_of_vector(batch, i, wants_close, fault, words);
    std::memcpy(out + i, words, sizeof words);
  }
  if (i == batch.size) return;
  with_padded_tail<Real, lane_count>(batch, i, [&](const QueryColumns<Real>& tail) HWY_ATTR {
    signs_of_vector(tail, 0, true, fault, words);
    std::memcpy(out + i, words, tail.size * sizeof *words);
  });
}

// The interval of |(l^ - r^) - margin| / (u scale), compared with a threshold.
template <class Real, class T>
struct ErrorSink {
  static constexpr double u = std::numeric_limits<Real>::epsilon() / 2;
  const Answers<Real>& computed;
  std::size_t at, first, count;  // in `computed`; index of the first lane in the batch; number of lanes in use
  const ErrorThresholds& thresholds;
  std::vector<SuspectError>& suspects;
  M in_range;

  AXISCERT_INLINE void operator()(Comparison which, const Margin<T>& margin) {
    const auto k = index_of(which);
    const V lhs = load_double(computed.lhs[k].data() + at), rhs = load_double(computed.rhs[k].data() + at);
    const T difference = T::difference(lhs, rhs);
    const V distance = hn::Abs((difference - margin.value).leading());
    // Two roundings: the difference of the sides, and the distance.
    const V bound =
        plus(margin.bound, plus(times(units<T>(1), hn::Abs(difference.leading())), times(constant(0x1p-52), distance)));
    const V least_scale = hn::Sub(margin.scale, margin.scale_bound);
    const V allowed = times(constant(thresholds[k] * u), least_scale);
    // The allowed error may overflow, and an infinite side must not pass because of that.
    const M finite = hn::Lt(distance, constant(std::numeric_limits<double>::infinity()));
    const M fine = hn::And(hn::And(hn::Le(plus(distance, bound), allowed), finite), in_range);
    if (hn::AllTrue(D(), fine)) [[likely]]
      return;
    report(k, fine, distance, bound, margin.scale, margin.scale_bound);
  }

  HWY_NOINLINE void report(std::size_t k, M fine, V distance, V bound, V scale, V scale_bound) {
    double distances[lane_count], bounds[lane_count], scales[lane_count], scale_bounds[lane_count];
    const D d;
    hn::StoreU(distance, d, distances);
    hn::StoreU(bound, d, bounds);
    hn::StoreU(scale, d, scales);
    hn::StoreU(scale_bound, d, scale_bounds);
    std::uint8_t passed[8] = {}, ranged[8] = {};
    hn::StoreMaskBits(d, fine, passed);
    hn::StoreMaskBits(d, in_range, ranged);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (std::size_t lane = 0; lane < count; ++lane) {
      if (has_bit(passed[0], lane)) continue;
      SuspectError suspect{first + lane, k, 0, infinity};
      // About ten roundings, which a relative 2^-40 covers.
      const double least = scales[lane] - scale_bounds[lane];
      if (has_bit(ranged[0], lane) && least > 0) {
        suspect.upper = (distances[lane] + bounds[lane]) / least / u * (1 + 0x1p-40);
        const double low = (distances[lane] - bounds[lane]) / (scales[lane] + scale_bounds[lane]) / u * (1 - 0x1p-40);
        suspect.lower = low > 0 ? low : 0;
      }
      if (!(suspect.upper <= infinity)) suspect.upper = infinity;
      suspects.push_back(suspect);
    }
  }
};

// Whether all errors of a vector are certainly within their thresholds. With distance^ the computed one, t = u
// threshold:
//   |(l^ - r^) - margin| <= distance^ (1 + 2^-51) + bound + U |l^ - r^|,  |l^ - r^| <= distance^ + bound + scale
//   t scale >= t (scale^ - scale_bound), and where t <= 1, t scale_bound <= bound + (10 U + 2^-46) t scale^
//   (margins-inl.h)
// so that distance^ + 2 bound <= (t (1 - 2^-40) - 2^6 U) scale^ is enough: 2^-40 and 2^6 cover the products of small
// terms and the roundings of this very comparison. A side that is not finite makes distance^ infinite or NaN; a scale
// of zero requires a distance of zero.
template <class Real, class T>
struct WithinSink {
  const Answers<Real>& computed;
  const std::array<double, comparison_count>& allowed;
  std::size_t at;
  M fine;

  AXISCERT_INLINE void operator()(Comparison which, const Margin<T>& margin) {
    const auto k = index_of(which);
    const V lhs = load_double(computed.lhs[k].data() + at), rhs = load_double(computed.rhs[k].data() + at);
    const V distance = hn::Abs((T::difference(lhs, rhs) - margin.value).leading());
    const V found = times_plus(margin.bound, constant(2), distance);
    fine = hn::And(fine, hn::Le(found, times(constant(allowed[k]), margin.scale)));
  }
};

// The multiples of the scale that WithinSink compares with.
template <class Real, class T>
std::array<double, comparison_count> allowed_by(const ErrorThresholds& thresholds) {
  constexpr double u = std::numeric_limits<Real>::epsilon() / 2;
  std::array<double, comparison_count> allowed;
  for (std::size_t k = 0; k < comparison_count; ++k) {
    allowed[k] = std::min(thresholds[k] * u, 1.0) * (1 - 0x1p-40) - 0x1p6 * T::unit;
  }
  return allowed;
}

template <EdgeForm form, class Real>
AXISCERT_INLINE bool are_errors_within(const QueryColumns<Real>& batch, std::size_t at, const Answers<Real>& computed,
                                       const std::array<double, comparison_count>& allowed) {
  using T = FilterNumber<Real>;
  const Margins<form, T> margins(load_query(batch, at));
  WithinSink<Real, T> sink{computed, allowed, at, hn::Eq(hn::Zero(D()), hn::Zero(D()))};
  margins.emit_all(sink);
  if constexpr (sizeof(Real) == 8) sink.fine = hn::And(sink.fine, margins.in_range());
  return hn::AllTrue(D(), sink.fine);
}

template <EdgeForm form, class Real>
HWY_NOINLINE void errors_of_vector(const QueryColumns<Real>& batch, std::size_t at, const Answers<Real>& computed,
                                   std::size_t computed_at, std::size_t first, std::size_t count,
                                   const ErrorThresholds& thresholds, std::vector<SuspectError>& suspects) {
  using T = FilterNumber<Real>;
  const Margins<form, T> margins(load_query(batch, at));
  M in_range = hn::Eq(hn::Zero(D()), hn::Zero(D()));
  if constexpr (sizeof(Real) == 8) in_range = margins.in_range();
  ErrorSink<Real, T> sink{computed, computed_at, first, count, thresholds, suspects, in_range};
  margins.emit_all(sink);
}

template <EdgeForm form, class Real>
void filter_errors(const QueryColumns<Real>& batch, const Answers<Real>& computed, const ErrorThresholds& thresholds,
                   std::vector<SuspectError>& suspects) {
  const auto allowed = allowed_by<Real, FilterNumber<Real>>(thresholds);
  std::size_t i = 0;
  for (; i + lane_count <= batch.size; i += lane_count) {
    if (are_errors_within<form>(batch, i, computed, allowed)) continue;
    errors_of_vector<form>(batch, i, computed, i, i, lane_count, thresholds, suspects);
  }
  if (i == batch.size) return;
  with_padded_tail<Real, lane_count>(batch, i, [&](const QueryColumns<Real>& tail) HWY_ATTR {
    Answers<Real> padded;
    padded.resize(lane_count, comparison_count);
    for (std::size_t k = 0; k < comparison_count; ++k) {
      std::copy_n(computed.lhs[k].begin() + static_cast<std::ptrdiff_t>(i), tail.size, padded.lhs[k].begin());
      std::copy_n(computed.rhs[k].begin() + static_cast<std::ptrdiff_t>(i), tail.size, padded.rhs[k].begin());
    }
    errors_of_vector<form>(tail, 0, padded, 0, i, tail.size, thresholds, suspects);
  });
}

template <class Real>
Filter<Real> filter_of() {
  const auto errors = [](const QueryColumns<Real>& batch, const Answers<Real>& computed, bool reduced,
                         const ErrorThresholds& thresholds, std::vector<SuspectError>& suspects) {
    if (reduced) filter_errors<EdgeForm::reduced>(batch, computed, thresholds, suspects);
    else filter_errors<EdgeForm::published>(batch, computed, thresholds, suspects);
  };
  return {filter_signs<Real>, errors};
}

}  // namespace HWY_NAMESPACE
}  // namespace axiscert
HWY_AFTER_NAMESPACE();
