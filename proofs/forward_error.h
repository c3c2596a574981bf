// A bound on the rounding error of a recorded program in a format of any number of digits.
#pragma once

#include "proofs/program.h"

namespace axiscert::proofs {

// A bound of |(computed lhs - computed rhs) - (lhs - rhs)| for each comparison, where P = 0, every coordinate is in
// [-1, 1], r is in [0, 1], and every operation is rounded to nearest in a format with this number of digits and this
// least exponent. It follows the standard model, step by step: looser than what Gappa proves for 24 and 53 digits, but
// valid for any format.
std::array<double, comparison_count> forward_error(const Recording& recording, int digits, int least_exponent);

}  // namespace axiscert::proofs
