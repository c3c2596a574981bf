// The quantities from which all sixteen comparisons and the distance are computed: the dot products of the vertices
// relative to the centre, and the cofactors and the determinant of their matrix. Over any integer type.
//
// A, B, C are relative to the centre, N1 = A x B, N2 = B x C, N3 = C x A, and V = N1 + N2 + N3. By Binet and Cauchy, (a
// x b).(c x d) = (a.c)(b.d) - (a.d)(b.c): the dot products of N1, N2, N3 are cofactors of the matrix of the six dot
// products of A, B, C, and d^2 = (A.V)^2 = det(A, B, C)^2 is its determinant.
//
// Let |x| <= M = 2^n for the nine coordinates of A, B, C and for r. Then |A|, |B|, |C| <= sqrt(3) M, |N| <= 3 M^2, and
// with all partial sums
// - degree 2: |a.b| <= 3 M^2, e = (aa + bb) - 2 ab <= 12 M^2, so with a sign 2n + 5 bits;
// - degree 4: N.N <= 9 M^4, N.V <= 27 M^4, |V|^2 <= 81 M^4, rr e <= 12 M^4, |N|^2 - rr e <= 12 M^4: 4n + 8 bits;
// - degree 6: d^2 <= 27 M^6 by partial sums <= 81 M^6, rr |V|^2 <= 81 M^6, and so their difference: 6n + 8 bits.
// A product of two numbers is always exact in the sum of their words.
#pragma once

#include <array>
#include <cstddef>

#include "exact/numbers/limb_integer.h"
#include "exact/numbers/wide_integer.h"

namespace axiscert {

// Whether numbers of n bits plus sign need at most `words` words at degree 2, and at most twice and three times as many
// at degrees 4 and 6.
constexpr bool fits_in_words(int n, int words) {
  return 2 * n + 5 <= 64 * words && 4 * n + 8 <= 128 * words && 6 * n + 8 <= 192 * words;
}

// The number types, of a fixed number of words at degree 2 ...
template <std::size_t words>
struct FixedWords {
  using GivenInteger = std::conditional_t<(words <= 2), std::int64_t, Int128>;
  using Degree2 = WideInteger<words>;
  using Degree4 = WideInteger<2 * words>;
  using Degree6 = WideInteger<3 * words>;
  AXISCERT_WORDS_INLINE static Degree2 product(GivenInteger x, GivenInteger y) {
    // A coordinate has n bits and a sign, and half as many words hold 32 (words + words % 2) >= n + 1.
    using Coordinate = WideInteger<(words + 1) / 2>;
    if constexpr (words % 2 == 0) return Coordinate(x) * Coordinate(y);
    else return Degree2(Coordinate(x) * Coordinate(y));
  }
};
// ... and of as many as needed, at most `words` for a coordinate.
template <std::size_t words>
struct UpToWords {
  using GivenInteger = LimbInteger<words>;
  using Degree2 = LimbInteger<2 * words>;
  using Degree4 = LimbInteger<4 * words>;
  using Degree6 = LimbInteger<6 * words>;
  static Degree2 product(const GivenInteger& x, const GivenInteger& y) { return x * y; }
};

// A, B, C relative to the centre, then r.
template <class Integer>
using CentredNumbers = std::array<Integer, 10>;

template <class Numbers>
struct Gram {
  using Degree2 = typename Numbers::Degree2;
  using Degree4 = typename Numbers::Degree4;
  using Degree6 = typename Numbers::Degree6;

  Degree2 aa, ab, ac, bb, bc, cc, rr;
  Degree4 n11, n22, n33, n12, n23, n31;
  Degree4 n1v, n2v, n3v, vv;
  Degree6 dd;

  AXISCERT_WORDS_INLINE explicit Gram(const CentredNumbers<typename Numbers::GivenInteger>& q)
      : aa(dot(q, 0, 0)),
        ab(dot(q, 0, 3)),
        ac(dot(q, 0, 6)),
        bb(dot(q, 3, 3)),
        bc(dot(q, 3, 6)),
        cc(dot(q, 6, 6)),
        rr(Numbers::product(q[9], q[9])),
        n11(aa * bb - ab * ab),
        n22(bb * cc - bc * bc),
        n33(cc * aa - ac * ac),
        n12(ab * bc - ac * bb),
        n23(bc * ac - ab * cc),
        n31(ac * ab - bc * aa),
        n1v(n11 + n12 + n31),
        n2v(n12 + n22 + n23),
        n3v(n31 + n23 + n33),
        vv(n1v + n2v + n3v),
        dd(cc * n11 + ac * n12 + bc * n31) {}

  // |AB|^2 of two vertices, from their dot products.
  AXISCERT_WORDS_INLINE static Degree2 edge2(const Degree2& xx, const Degree2& xy, const Degree2& yy) {
    return xx + yy - (xy + xy);
  }

 private:
  AXISCERT_WORDS_INLINE static Degree2 dot(const CentredNumbers<typename Numbers::GivenInteger>& q, std::size_t u,
                                           std::size_t v) {
    return (Numbers::product(q[u], q[v]) + Numbers::product(q[u + 1], q[v + 1])) + Numbers::product(q[u + 2], q[v + 2]);
  }
};

}  // namespace axiscert
