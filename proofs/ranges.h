// Ranges of exact quantities that Gappa cannot find alone, for two domains. Each is a theorem of
// proofs/coq/Ranges.v; the scripts take them as hypotheses.
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "proofs/program.h"

namespace axiscert::proofs {

// scaled    every exact coordinate of A - P, B - P, C - P in [-1, 1], r in [0, 1]; times 2^k it is every other size.
//           That of `axiscert search`.
// absolute  every coordinate of A, B, C, P in [-1, 1], r in [0, 1]
enum class Domain : unsigned char { scaled, absolute };
inline constexpr std::array<std::string_view, 2> domain_names = {"scaled", "absolute"};
constexpr std::string_view name(Domain d) { return domain_names[static_cast<std::size_t>(d)]; }

// Of a quantity of the program, or of each component of a vector (`V` for V_x, V_y, V_z).
struct Range {
  Domain domain;
  std::string_view quantity;
  bool is_vector;
  std::string_view low, high;  // dyadic
  // By how much it changes at most where every translated coordinate changes by h: this times h. Empty: Gappa's own.
  std::string_view change;
  // For a vector: at most so many hundredths is |x| + |y| + |z|; 0: not used.
  int sum_in_hundredths;
  // The lemmas of Ranges.v: NAME_range, NAME_change, NAME_sum; and their arguments for the first component and the
  // first edge, "y1" being B's y where 0, 1, 2 are the edge's two ends and the vertex opposite. Empty: open.
  std::string_view lemma, arguments;
};
std::span<const Range> ranges();

}  // namespace axiscert::proofs
