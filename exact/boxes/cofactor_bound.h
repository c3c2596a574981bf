// How deep a wrong verdict of box-box/cofactor can be, and the proof.
//
// Write t and R for the numbers that the kernel computes for A'T and A'B, r for a column R_j of R, and g_n = n u / (1 -
// n u) for n roundings.
// 1. What is evaluated. Take the boxes A° with the world's axes and half extents s, and B° with the axes R_k and half
//    extents h, at the place t. On the edge axis l = e_i x r the kernel's left side is |t.l|; A°'s extent along l is
//    s_i1 |r_i2| + s_i2 |r_i1|; and B°'s is h_j1 |R_j1.l| + h_j2 |R_j2.l| with R_j.l = 0, where R_j1.l is a cofactor of
//    R, C_i,j2, sign aside. So the comparison is the definition for A° and B°, on an axis that is exactly l. Each
//    product is of a component of l and a component of t, s e_k or h R_k, so the three sums round by at most (g_2 |t| +
//    g_3 |s| + g_5 sqrt(2) |h| |R_k|) |l|, and what is left after dividing by |l| does not depend on l. With an entry
//    of R for the cofactor, as the textbook has it, an error of u and d is left that is not small beside |l|: that is
//    the whole difference.
// 2. Facets. On e_i both sides are those of A° and B°, within g_1 |s| + g_4 |h|. On R_j the kernel has h_j where the
//    definition has h_j |R_j|^2 + the other two h_k |R_k.R_j|; R'R - I is at most 4 d + 6 sqrt(3) u.
// 3. The two frames. A' takes the boxes as given to within 3 d |s| of A°, g_3 3 |h| of B° and (sqrt(3) g_3 + u) |T| of
//    t, and changes lengths by a factor of sqrt(1 - 3 d) at least.
// 4. Missed. The penetration is at most (extents - |T.L|) / |L| for every L. For the axis on which the kernel says
//    separated that is at most the errors of 1 and 3: on an edge axis 12.1 u + 15.2 u + 3 d; on a_i 14.2 u + 1.8 d and
//    on b_j 24.6 u + 4.8 d, taken with L = a_i and b_j directly.
// 5. A lemma. Where A° is upright, the distance of A° and B° is at most sqrt(3) times the greatest gap on one of their
//    axes. For the nearest point of A° - B° to t has in its normal cone the direction n to t, which is a sum of at most
//    three normals of facets with factors f_k >= 0. All of these are in the normal cone of one corner of A°, an octant;
//    their products are not negative, so the sum of f_k^2 is at most |n|^2 = 1 and that of f_k at most sqrt(3); and the
//    gap on facet k is the distance times n.n_k, where the sum of f_k n.n_k is 1. (Extents of 0 are a limit of others.)
// 6. Invented. If no axis separates, the gaps on e_i and l are at most the errors of 1 and 2. On the normal n of B°'s
//    facets, R_j = c n + w with |w| at most sqrt(2) times R'R - I, so that |t.R_j| - extents at most the errors leaves
//    a gap of 48 u + 15.3 d. By 5 the distance of A° and B° is at most sqrt(3) times that, 82.8 u + 26.5 d; by 3 that
//    of the boxes 98 u + 29.5 d. QED
#pragma once

#include <algorithm>
#include <cmath>

namespace axiscert::boxes {

// Parts of the scene (squared_scene): the deepest missed contact by its penetration, the farthest phantom by its
// distance.
struct CofactorBound {
  double missed, phantom;
};

// 28 u + 5 d and 99 u + 30 d. u is half an ulp of 1 in the kernel's precision, 2^-24 or 2^-53; d the greatest defect of
// orthonormality of both boxes' axes (measures.h), at most 2^-10. Premises: round to nearest, no intermediate
// result overflows, and no product that is not 0 is below the normal numbers.
constexpr CofactorBound cofactor_bound(double u, double d) { return {28 * u + 5 * d, 99 * u + 30 * d}; }

// The same without rounding to whole numbers: the sums of the proof above, with its letters, term by term. Not above
// cofactor_bound. The scene is 1, so |T| <= 1 and |s|, |h| <= 1 / sqrt(1 - d).
inline CofactorBound cofactor_bound_in_full(double u, double d) {
  const auto g = [&](int n) { return n * u / (1 - n * u); };
  const double root3 = std::sqrt(3.0), root2 = std::sqrt(2.0);
  const double column = std::sqrt(1 + d), norm = std::sqrt(1 + 3 * d), least = std::sqrt(1 - 3 * d);
  const double half = 1 / std::sqrt(1 - d);
  // Errors of t = A'T and of a column of R = A'B, and their sizes.
  const double of_t = root3 * column * g(3) * (1 + u) + norm * u, of_r = root3 * g(3) * column * column;
  const double t = norm + of_t, r = norm * column + of_r, norm_r = norm * norm + root3 * of_r;
  // R'R - I.
  const double d_r = 3 * d * column * column + d + 2 * norm * column * of_r + of_r * of_r;
  // From the boxes of the kernel's frame to the boxes as given.
  const double frame = of_t + 3 * d * half + root3 * of_r * half;

  const double edge = g(2) * t + g(3) * half + g(5) * root2 * half * r;
  const double facet_a = g(1) * half + g(4) * half * norm_r;
  const double missed_edge = (edge + frame) / least;
  const double missed_a =
      (g(3) * column * (1 + u) + u * column + facet_a + root3 * d * half + of_r * half) / std::sqrt(1 - d);
  const double missed_b = (3 * d * column + of_t * norm * column + norm * of_r + of_t * of_r + g(3) * t * r +
                           half * (g(4) * r + of_r) + half * (g(1) + root3 * d)) /
                          std::sqrt(1 - d);

  const double w = root2 * d_r / std::sqrt(1 - 2 * d_r), cosine2 = 1 - d_r - w * w;
  const double facet_b =
      (g(3) * t * r + g(4) * half * r + g(1) * half + (t + half) * w + half * (1 - cosine2)) / std::sqrt(cosine2);
  const double phantom = (root3 * std::max({edge, facet_a, facet_b}) + frame) / least;
  return {std::max({missed_edge, missed_a, missed_b}), phantom};
}

}  // namespace axiscert::boxes
