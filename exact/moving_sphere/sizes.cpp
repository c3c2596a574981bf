#include "exact/moving_sphere/sizes.h"

#include <mpfr.h>

#include <algorithm>

namespace axiscert::moving_sphere {

Rational root_below(const Rational& q) {
  constexpr long bits = 256;
  const mpz_class product = q.get_num() * q.get_den();
  const long length = static_cast<long>(mpz_sizeinbase(product.get_mpz_t(), 2));
  const auto shift = static_cast<mp_bitcnt_t>(std::max(0L, bits - length / 2));
  mpz_class shifted = product << 2 * shift;
  mpz_sqrt(shifted.get_mpz_t(), shifted.get_mpz_t());
  return quotient(shifted, q.get_den() << shift);
}

Rational apart(const RootTime& t, const Rational& s) {
  // rest - sqrt(square) - s, as a sum of numbers of one sign.
  const Rational rest = t.rest - s, root = root_below(t.square);
  if (rest <= 0) return root - rest;
  return abs(Rational(rest * rest - t.square)) / (rest + root);
}

Tunnel tunnel_of(const Rational& r, const Rational& least_squared) {
  if (least_squared == 0) return {round_up(Rational(1)), true};
  const Rational rr = r * r, size = (rr - least_squared) / (r * (r + root_below(least_squared)));
  if (sgn(size) <= 0) return {{}, false};
  // The tunnel is at least F exactly where least <= (1 - F) r.
  const auto reaches = [&](const Decimal6& depth) {
    const Rational rest = 1 - exact(depth);
    return sgn(rest) >= 0 && least_squared <= rest * rest * rr;
  };
  Decimal6 depth = round_up(size);
  while (!reaches(depth)) depth = previous(depth);
  while (reaches(next(depth))) depth = next(depth);
  return {depth, false};
}

double angle_between(const portable::Vec3<Rational>& a, const portable::Vec3<Rational>& b) {
  const Rational squares = portable::dot(a, a) * portable::dot(b, b), along = portable::dot(a, b);
  Rational half_chord_squared = 1;
  if (sgn(squares) != 0) {
    const Rational lengths = root_below(squares);
    // sin^2 of half the angle, (1 - cos) / 2, without a difference where that would cancel.
    if (sgn(along) > 0) half_chord_squared = (squares - along * along) / (2 * lengths * (lengths + along));
    else half_chord_squared = std::min(Rational(1), Rational((1 - along / lengths) / 2));
  }
  MPFR_DECL_INIT(angle, 53);
  mpfr_set_d(angle, nearest_sqrt<double>(half_chord_squared), MPFR_RNDN);
  mpfr_asin(angle, angle, MPFR_RNDN);
  return 2 * mpfr_get_d(angle, MPFR_RNDN);
}

Rational squared_scene(const GivenMotion& q) {
  const Rational r(q.r);
  Rational scene = r * r;
  const auto rational = [](double x) { return Rational(x); };
  const portable::Vec3<Rational> d = q.displacement<Rational>(rational),
                                 p{Rational(q.p.x), Rational(q.p.y), Rational(q.p.z)};
  for (const auto& v : {q.a, q.b, q.c}) {
    const portable::Vec3<Rational> start = portable::Vec3<Rational>{Rational(v.x), Rational(v.y), Rational(v.z)} - p,
                                   end = start - d;
    scene = std::max({scene, portable::dot(start, start), portable::dot(end, end)});
  }
  return scene;
}

}  // namespace axiscert::moving_sphere
