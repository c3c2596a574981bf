// How deep a wrong verdict of box-box/cofactor can be: proved in exact/boxes/README.md.
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

// The same without rounding to whole numbers: the sums of the proof, term by term. Not above cofactor_bound. The
// letters are those of the proof in exact/boxes/README.md. The scene is 1, so |T| <= 1 and |s|, |h| <= 1 / sqrt(1 - d).
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
