#include "fuzz/sphere_triangle/search_ranges.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "fuzz/queries/floats.h"
#include "fuzz/queries/image_groups.h"
#include "fuzz/sphere_triangle/formulae/axis_windows.h"
#include "kernel/ask.h"
#include "kernel/base/error_free.h"

namespace axiscert {
namespace {

// The greatest distance of a coordinate from the origin: beyond it adjacent numbers are more than 1 apart.
template <class Real>
constexpr Real farthest = static_cast<Real>(std::uint64_t{1} << std::numeric_limits<Real>::digits);
constexpr std::size_t radius_place = coordinate_count - 1;

// The place of a coordinate of a vertex or, with v = 3, of the centre: 3 v + axis.
constexpr std::size_t place_of(std::size_t vertex, std::size_t axis) { return 3 * vertex + axis; }

}  // namespace

template <class Real>
bool is_within_one(Real a, Real p) {
  const auto difference = arithmetic::two_sum(a, Real(-p));
  const Real size = std::fabs(difference.value);
  const Real beyond = difference.value > 0 ? difference.error : Real(-difference.error);
  return size < 1 || (size == 1 && beyond <= 0);
}

template <class Real>
bool is_in_box(const Query<Real>& q) {
  if (q.r > 1) return false;
  for (const Vec3<Real>& v : {q.a, q.b, q.c}) {
    if (!is_within_one(v.x, q.p.x) || !is_within_one(v.y, q.p.y) || !is_within_one(v.z, q.p.z)) return false;
  }
  return true;
}

template <class Real>
void settle(Query<Real>& q) {
  auto v = coordinates(q);
  for (Real& x : v) {
    if (!(std::fabs(x) <= farthest<Real>)) x = std::isnan(x) ? Real(0) : std::copysign(farthest<Real>, x);
  }
  v[radius_place] = std::min(std::fabs(v[radius_place]), Real(1));
  Real greatest = v[radius_place];
  for (std::size_t vertex = 0; vertex < 3; ++vertex) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      Real& x = v[place_of(vertex, axis)];
      const Real p = v[place_of(3, axis)];
      // Rounding is monotone: if the rounded difference is less than 1, so is the exact one.
      if (std::fabs(x - p) >= 1 && !is_within_one(x, p)) {
        x = p + (x > p ? Real(1) : Real(-1));
        while (!is_within_one(x, p)) x = std::nextafter(x, p);
      }
      greatest = std::max(greatest, std::fabs(x - p));
    }
  }
  if (greatest > 0 && greatest < Real(0.5)) {
    Real most = greatest;
    for (const Real x : v) most = std::max(most, std::fabs(x));
    const int up = std::min(-1 - std::ilogb(greatest), std::numeric_limits<Real>::digits - 1 - std::ilogb(most));
    if (up > 0) scale_by_power_of_two(v, up);
  }
  q = from_coordinates(v);
}

#define AXISCERT_INSTANTIATE(Real)             \
  template bool is_within_one(Real, Real);     \
  template bool is_in_box(const Query<Real>&); \
  template void settle(Query<Real>&);
AXISCERT_INSTANTIATE(float)
AXISCERT_INSTANTIATE(double)
#undef AXISCERT_INSTANTIATE

namespace {

template <class Real>
double greatest(const Vec3<Real>& u, const Vec3<Real>& v) {
  return std::max({std::fabs(double(u.x) - double(v.x)), std::fabs(double(u.y) - double(v.y)),
                   std::fabs(double(u.z) - double(v.z))});
}

// Whether the way back from 2^exponent q, which is `scaled`, gives q: that no bit was lost.
template <class Real>
bool scaled_exactly(const Query<Real>& q, const Query<Real>& scaled, int exponent) {
  return coordinates(times_power(scaled, -exponent)) == coordinates(q);
}

}  // namespace

template <class Real>
bool has_good_shape(const Query<Real>& q) {
  const double lengths[] = {greatest(q.a, q.p), greatest(q.b, q.p), greatest(q.c, q.p), greatest(q.a, q.b),
                            greatest(q.b, q.c), greatest(q.c, q.a), double(q.r)};
  const double size = std::max({lengths[0], lengths[1], lengths[2], lengths[6]});
  return size > 0 && *std::min_element(std::begin(lengths), std::end(lengths)) >= size / 8 &&
         is_far_from_every_change(q);
}
template bool has_good_shape(const Query<float>&);
template bool has_good_shape(const Query<double>&);

template <class Real>
std::vector<std::optional<int>> range_left(const Implementation<Real>& kernel, const Aim& aim,
                                           const QueryBatch<Real>& batch) {
  const std::size_t k = aim.which;
  const auto bit = one_bit<ComparisonBits>(k);
  struct Scan {
    std::size_t query;
    bool holds;  // at m = 0
  };
  std::vector<std::optional<int>> left(batch.size());
  std::vector<Scan> scans;
  QueryBatch<Real> scaled(batch.size(), coordinate_count);
  Reply<Real> reply;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    if (has_good_shape(query_from(batch[i]))) scans.push_back({i, false});
  }
  const int step = aim.goal == Goal::overflow ? 1 : -1;
  const ExponentWindow scanned = scanned_exponents(precision_of<Real>);
  for (int m = 0; m >= scanned.low && m <= scanned.high && !scans.empty(); m += step) {
    scaled.clear();
    std::erase_if(scans, [&](const Scan& scan) {
      const Query<Real> q = query_from(batch[scan.query]), there = times_power(q, m);
      const bool is_exact = scaled_exactly(q, there, m);
      if (is_exact) scaled.push_back(there);
      return !is_exact;
    });
    ask(kernel, scaled.columns(), reply);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < scans.size(); ++i) {
      Scan scan = scans[i];
      if (reply.verdicts[i] == Verdict::unanswered) continue;
      const bool holds = (reply.answers.bits[i] & bit) != 0;
      const bool finite = std::isfinite(reply.answers.lhs[k][i]) && std::isfinite(reply.answers.rhs[k][i]);
      if (m == 0) scan.holds = holds;
      if (!finite || holds != scan.holds) {
        if (m != 0) left[scan.query] = m;
      } else {
        scans[kept++] = scan;
      }
    }
    scans.resize(kept);
  }
  return left;
}
template std::vector<std::optional<int>> range_left(const Implementation<float>&, const Aim&, const QueryBatch<float>&);
template std::vector<std::optional<int>> range_left(const Implementation<double>&, const Aim&,
                                                    const QueryBatch<double>&);

double range_score(Goal goal, Precision precision, int exponent) {
  const ExponentWindow scanned = scanned_exponents(precision);
  return goal == Goal::overflow ? scanned.high + 1 - exponent : exponent - scanned.low + 1;
}
int range_exponent(Goal goal, Precision precision, double score) {
  const ExponentWindow scanned = scanned_exponents(precision);
  return goal == Goal::overflow ? scanned.high + 1 - static_cast<int>(score)
                                : scanned.low - 1 + static_cast<int>(score);
}

}  // namespace axiscert
