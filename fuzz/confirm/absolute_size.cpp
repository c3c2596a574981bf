#include "fuzz/confirm/absolute_size.h"

#include <algorithm>
#include <cmath>

#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "fuzz/queries/image_groups.h"
#include "kernel/ask.h"

namespace axiscert {
namespace {

using QuantityValues = std::array<double, quantities.size()>;

double length_of(const Vec3<double>& v) { return std::sqrt(dot(v, v)); }

double squared_distance_to(const Vec3<double>& u, const Vec3<double>& v) {
  const Vec3<double> w = v - u;
  const double along = -dot(u, w), whole = dot(w, w);
  const double t = along <= 0 ? 0 : along >= whole ? 1 : along / whole;
  const Vec3<double> nearest = u + w * t;
  return dot(nearest, nearest);
}

// The quantities of the base, in the order of `quantities`, in plain double: four digits would do.
template <class Real>
QuantityValues values_of(const Query<Real>& base) {
  const Query<double> q = widened(base);
  const Rational exact_square = squared_distance(base), radius = exact(q.r);
  const double dd = nearest<double>(exact_square), d = std::sqrt(dd);
  const double gap = std::abs(nearest<double>(Rational(exact_square - radius * radius)));
  const std::array<Vec3<double>, 3> v = {q.a - q.p, q.b - q.p, q.c - q.p};
  const Vec3<double> normal = cross(v[1] - v[0], v[2] - v[0]);
  std::array<double, 3> edges, vertices, sides;
  std::size_t next_to = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t to = (i + 1) % 3, last = next_to;
    edges[i] = length_of(v[to] - v[i]);
    vertices[i] = length_of(v[i]);
    sides[i] = dot(cross(v[i], v[to]), normal);
    if (squared_distance_to(v[i], v[to]) < squared_distance_to(v[last], v[(last + 1) % 3])) next_to = i;
  }
  double greatest = 0;
  for (const auto& point : {q.a, q.b, q.c, q.p}) {
    greatest = std::max({greatest, std::abs(point.x), std::abs(point.y), std::abs(point.z)});
  }
  const double offset = dot(v[0], normal), ee = dot(normal, normal);
  const auto [least_edge, greatest_edge] = std::minmax_element(edges.begin(), edges.end());
  const auto [least_vertex, greatest_vertex] = std::minmax_element(vertices.begin(), vertices.end());
  return {d,
          q.r,
          d + q.r > 0 ? gap / (d + q.r) : 0,
          gap,
          std::sqrt(ee),
          *least_edge,
          edges[next_to],
          *greatest_edge,
          *least_vertex,
          *greatest_vertex,
          greatest,
          *std::min_element(sides.begin(), sides.end()),
          std::abs(offset),
          std::abs(offset * offset - q.r * q.r * ee),
          ee > 0 ? std::abs(offset) / std::sqrt(ee) : 0,
          edges[0],
          edges[1],
          edges[2]};
}

struct Interval {
  double low, high;
};

// The first place where most of the closed intervals overlap.
AbsoluteSize overlap(std::size_t quantity, const std::vector<Interval>& intervals) {
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

template <class Real>
void narrow_in(const Plan& plan, const Kernel& kernel, const Source& source, std::vector<UnitFlip>& flips) {
  const auto is_narrow = [](const UnitFlip& flip) { return std::abs(flip.right - flip.wrong) <= 1; };
  const Implementation<Real> implementation = kernel.on<Real>(plan.target);
  Reply<Real> reply;
  for (;;) {
    QueryBatch<Real> batch(flips.size(), source.columns().size());
    std::vector<UnitFlip*> wide;
    for (UnitFlip& flip : flips) {
      if (is_narrow(flip)) continue;
      const Numbers<Real> base = source.make<Real>(plan.seed, flip.base);
      batch.push_back(times_power(base, (flip.right + flip.wrong) / 2));
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
std::vector<AbsoluteSize> sizes_in(const Plan& plan, const Source& source, std::span<const UnitFlip> flips) {
  std::array<std::vector<Interval>, quantities.size()> intervals;
  for (const UnitFlip& flip : flips) {
    const QuantityValues values = values_of<Real>(source.make<Real>(plan.seed, flip.base));
    const auto [low, high] = std::minmax(flip.right, flip.wrong);
    for (std::size_t k = 0; k < quantities.size(); ++k) {
      const int degree = quantities[k].degree;
      if (values[k] > 0) {
        intervals[k].push_back({std::ldexp(values[k], degree * low), std::ldexp(values[k], degree * high)});
      }
    }
  }
  std::vector<AbsoluteSize> sizes;
  for (std::size_t k = 0; k < quantities.size(); ++k) {
    const AbsoluteSize size = overlap(k, intervals[k]);
    if (size.explains * 4 >= flips.size() * 3 && size.explains > 0) sizes.push_back(size);
  }
  std::stable_sort(sizes.begin(), sizes.end(), [](const auto& x, const auto& y) { return x.explains > y.explains; });
  constexpr std::size_t most = 3;
  const auto worse = std::find_if(sizes.begin(), sizes.end(),
                                  [&](const AbsoluteSize& size) { return size.explains < sizes.front().explains; });
  sizes.erase(worse, sizes.end());
  if (sizes.size() > most) sizes.resize(most);
  return sizes;
}

}  // namespace

void narrow(const Plan& plan, const Kernel& kernel, const Source& source, Precision precision,
            std::vector<UnitFlip>& flips) {
  if (flips.empty() || plan.replies) return;
  if (precision == Precision::binary32) narrow_in<float>(plan, kernel, source, flips);
  else narrow_in<double>(plan, kernel, source, flips);
}

std::vector<AbsoluteSize> absolute_sizes(const Plan& plan, const Source& source, Precision precision,
                                         std::span<const UnitFlip> flips) {
  if (&source.test() != &first_test()) return {};
  return precision == Precision::binary32 ? sizes_in<float>(plan, source, flips)
                                          : sizes_in<double>(plan, source, flips);
}

}  // namespace axiscert
