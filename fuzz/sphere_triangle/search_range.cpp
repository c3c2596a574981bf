#include "fuzz/sphere_triangle/search_range.h"

#include <algorithm>
#include <cmath>

#include "fuzz/sphere_triangle/formulae/axis_windows.h"
#include "fuzz/queries/image_groups.h"
#include "kernel/ask.h"

namespace axiscert {
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
