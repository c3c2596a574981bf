// Ranges of exact quantities that Gappa cannot find by itself, for two domains. The scripts take them as hypotheses;
// those with a lemma are theorems of proofs/coq/formulae/Ranges.v.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "proofs/program.h"

namespace axiscert::proofs {

// scaled    every exact coordinate of A - P, B - P, C - P in [-1, 1], r in [0, 1]; scaled by 2^k it covers every other
//           size. The domain of `axiscert search`.
// absolute  every coordinate of A, B, C, P in [-1, 1], r in [0, 1]
enum class Domain : unsigned char { scaled, absolute };
inline constexpr std::array<std::string_view, 2> domain_names = {"scaled", "absolute"};
constexpr std::string_view name(Domain d) { return domain_names[static_cast<std::size_t>(d)]; }

// The range of a quantity of the program, or of each component of a vector (`V` for V_x, V_y, V_z).
struct Range {
  Domain domain;
  std::string_view quantity;
  bool is_vector;
  std::string_view low, high;  // dyadic numbers
  // The quantity changes by at most this times h where every translated coordinate changes by h. Empty: Gappa finds it.
  std::string_view change;
  // For a vector: a bound of |x| + |y| + |z| in hundredths. 0: not used.
  int sum_in_hundredths;
  // The lemmas of Ranges.v: NAME_range, NAME_change, NAME_sum; and their arguments for the first component and the
  // first edge, where "y1" is B's y if 0, 1, 2 are the edge's two ends and the opposite vertex. Empty: not proved in
  // Coq.
  std::string_view lemma, arguments;
};
std::span<const Range> ranges();

}  // namespace axiscert::proofs
