// The bounds that the scripts prove, in u = 2^-24 or 2^-53, the ranges that they rely on, and the errors that searches
// attained.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "proofs/program.h"

namespace axiscert::proofs {
// Ranges of exact quantities that Gappa cannot find by itself, for two domains. The scripts take them as hypotheses;
// those with a lemma are theorems of proofs/coq/formulae/Ranges.v.

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

// Comparisons that differ only by a renaming of the vertices have the same bound.
enum class Kind : unsigned char { plane_radius, vertex_radius, vertex_side, edge_radius, edge_side };
Kind kind_of(Comparison which);

struct Setting {
  Form form;
  Contraction contraction;
  Precision precision;
  Domain domain;
};

// A bound of |(computed lhs - computed rhs) - (lhs - rhs)|, in u/16. 0: none is known yet, and the script asks for one.
int bound(const Setting& setting, Comparison which);
// A bound of the error of every component of a vector, in u/16: a step of the proof.
int vector_bound(const Setting& setting, std::string_view vector);

// The two sets of formulae share the comparisons of the plane and the vertices; the scripts of these are published's.
bool is_shared(Comparison which);
std::string script_path(const Setting& setting, Comparison which);

// The greatest errors, in u, that searches attained on the scaled domain, rounded down; the bounds are compared with
// them. Each was found by `axiscert search --kernel K --precision binary32` with the options in the row; its query is
// in proofs/attained.jsonl, from which proofs/tests/attained_test.py computes it again.

struct AttainedBound {
  std::string_view kernel;
  Kind kind;
  double u;
  std::string_view search;
};
inline constexpr auto attained_errors = std::to_array<AttainedBound>({
    {"published", Kind::plane_radius, 367.59, "--evaluations 63438848 --seed 1"},
    {"published", Kind::vertex_radius, 7.98953, "--evaluations 63438848 --seed 1"},
    {"published", Kind::vertex_side, 14.813, "--evaluations 63438848 --seed 1"},
    {"published", Kind::edge_radius, 1129.19, "--evaluations 63438848 --seed 1"},
    {"published", Kind::edge_side, 1981.69, "--evaluations 63438848 --seed 1"},
    {"reduced", Kind::edge_radius, 65.302, "--comparison edge_ab.radius --evaluations 30051328 --seed 2"},
    {"reduced", Kind::edge_side, 91.323, "--comparison edge_ab.side_c --evaluations 30051328 --seed 2"},
});

}  // namespace axiscert::proofs
