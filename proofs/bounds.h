// The bounds that the scripts prove, in u = 2^-24 or 2^-53.
#pragma once

#include <string>

#include "proofs/ranges.h"

namespace axiscert::proofs {

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

}  // namespace axiscert::proofs
