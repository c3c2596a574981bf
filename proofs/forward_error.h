// A bound on the rounding error of a recorded program in a format of any number of digits.
#pragma once

#include "proofs/program.h"

namespace axiscert::proofs {

// At most so much is |(computed lhs - computed rhs) - (lhs - rhs)| of each comparison, where P = 0, every coordinate is
// in
// [-1, 1], r in [0, 1], and every operation is rounded to nearest with so many digits and least exponent. The standard
// model, step by step: looser than what Gappa proves for 24 and 53 digits, and valid for any.
std::array<double, comparison_count> forward_error(const Recording& recording, int digits, int least_exponent);

}  // namespace axiscert::proofs
