// The bounds that the scripts prove, in u = 2^-24 or 2^-53.
#pragma once

#include <string>

#include "proofs/ranges.h"

namespace axiscert::proofs {

// The comparisons that differ by a renaming of the vertices have one bound.
enum class Kind : unsigned char { plane_radius, vertex_radius, vertex_side, edge_radius, edge_side };
Kind kind_of(Comparison which);

struct Setting {
  Form form;
  Contraction contraction;
  Precision precision;
  Domain domain;
};

// At most so many u/16 is |(computed lhs - computed rhs) - (lhs - rhs)|. 0: none is known yet, and the script asks.
int bound(const Setting& setting, Comparison which);
// At most so many u/16 is the error of every component of a vector: a step of the proof.
int vector_bound(const Setting& setting, std::string_view vector);

// The two sets of formulae share the plane's and the vertices' comparisons: those have one script, published's.
bool is_shared(Comparison which);
std::string script_path(const Setting& setting, Comparison which);

}  // namespace axiscert::proofs
