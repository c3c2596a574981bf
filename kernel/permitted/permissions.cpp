#include "kernel/permitted/permissions.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace axiscert::permitted {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float least_normal = std::numeric_limits<float>::min();
constexpr Reach indeterminate{-infinity, infinity};
constexpr double quotient_ulps = 2.5;  // WGSL, section 15.7.4.1

bool is_indeterminate(Reach r) { return r == indeterminate; }

// `nearest` is the float nearest to the exact value; `rest`, by its sign, what is missing.
Reach around(const Permissions& permissions, float nearest, double rest) {
  Reach r{nearest, nearest};
  if (permissions.faithful && rest > 0) r.greatest = std::nextafter(nearest, infinity);
  if (permissions.faithful && rest < 0) r.least = std::nextafter(nearest, -infinity);
  return flushed(permissions, checked(r));
}

// The float at a double or above it, and at or below it, however the processor rounds.
float above(double x) {
  const auto near = static_cast<float>(x);
  return near < x ? std::nextafter(near, infinity) : near;
}
float below(double x) { return -above(-x); }

// The distance of the two floats around an exact value; of a float, to the nearer of its neighbours.
double ulp(double exact) {
  const double least = below(exact), greatest = above(exact);
  if (least != greatest) return greatest - least;
  return std::min(exact - std::nextafter(below(exact), -infinity), std::nextafter(above(exact), infinity) - exact);
}

// Joins what `operation` gives of each pair of ends.
template <class Operation>
Reach of_ends(Reach a, Reach b, Operation&& operation) {
  if (is_indeterminate(a) || is_indeterminate(b)) return indeterminate;
  Reach all{infinity, -infinity};
  for (const float x : {a.least, a.greatest}) {
    for (const float y : {b.least, b.greatest}) all = joined(all, operation(x, y));
  }
  return checked(all);
}

}  // namespace

Reach negative(Reach r) { return {-r.greatest, -r.least}; }
Reach joined(Reach a, Reach b) { return {std::min(a.least, b.least), std::max(a.greatest, b.greatest)}; }
Reach checked(Reach r) {
  return std::isfinite(r.least) && std::isfinite(r.greatest) ? r : indeterminate;  // NaN is not finite
}
Reach flushed(const Permissions& permissions, Reach r) {
  if (!permissions.flushed) return r;
  if (r.least > 0 && r.least < least_normal) r.least = 0;
  if (r.greatest < 0 && r.greatest > -least_normal) r.greatest = 0;
  return r;
}

Reach sum_of(const Permissions& permissions, Reach a, Reach b) {
  if (is_indeterminate(a) || is_indeterminate(b)) return indeterminate;
  return checked(
      {rounded_sum(permissions, a.least, b.least).least, rounded_sum(permissions, a.greatest, b.greatest).greatest});
}
Reach product_of(const Permissions& permissions, Reach a, Reach b) {
  return of_ends(a, b, [&](float x, float y) { return rounded_product(permissions, x, y); });
}
Reach fused_of(const Permissions& permissions, Reach a, Reach b, Reach z) {
  if (is_indeterminate(z)) return indeterminate;
  const Reach all = of_ends(a, b, [&](float x, float y) {
    return Reach{std::fma(x, y, z.least), std::fma(x, y, z.greatest)};
  });
  return flushed(permissions, all);
}
Reach quotient_of(const Permissions& permissions, Reach a, Reach b) {
  return of_ends(a, b, [&](float x, float y) { return rounded_quotient(permissions, x, y); });
}

Reach rounded_sum(const Permissions& permissions, float a, float b) {
  const float sum = a + b;
  if (!std::isfinite(sum)) return indeterminate;
  const float of_b = sum - a;
  return around(permissions, sum, (a - (sum - of_b)) + (b - of_b));  // two-sum: the error, exactly
}
Reach rounded_product(const Permissions& permissions, float a, float b) {
  const double exact = static_cast<double>(a) * b;  // 48 bits
  const auto nearest = static_cast<float>(exact);
  if (!std::isfinite(nearest)) return indeterminate;
  return around(permissions, nearest, exact - nearest);
}
// The quotient of two floats is a number of 25 bits, or by more than 2^-50 of its size beside each of these: so the
// double, and the double that is 2.5 ulp away, are on the right side of every float, however the processor rounds.
Reach rounded_quotient(const Permissions& permissions, float a, float b) {
  const double exact = static_cast<double>(a) / b;
  if (!permissions.divided) {
    const auto nearest = static_cast<float>(exact);
    return std::isfinite(nearest) ? around(permissions, nearest, exact - nearest) : indeterminate;
  }
  if (std::fabs(b) < least_normal || std::fabs(b) > 0x1p126F) return indeterminate;
  if (!(std::fabs(exact) <= std::numeric_limits<float>::max())) return indeterminate;
  if (exact == 0) return {0, 0};
  const double most = quotient_ulps * ulp(exact);
  return flushed(permissions, {above(exact - most), below(exact + most)});
}

}  // namespace axiscert::permitted
