// The feedback of the kernel target: how near a comparison is to its boundary, and how the kernel's answer is wrong.
#pragma once

#include <cstddef>

#include "exact/sphere_triangle/oracles/exact_truth.h"

namespace axiscert::fuzzing {

// A computed comparison in relation to the exact one.
enum class SignKind : std::uint8_t { right, false_yes, false_no, not_finite };
inline constexpr std::size_t sign_kind_count = 4;

// floor(log2(|l| + |r|)) - floor(log2|l - r|) of the exact sides: the exponent of the scale of a comparison's error
// minus that of its margin; so it is -log2 u (24 or 53) or a little more where one rounding may change the sign. It is
// at least 0; values from `most_bucket` on share a bucket, and 127 is a tie.
inline constexpr std::size_t margin_bucket_count = 128, tie_bucket = 127, most_bucket = 126;
std::size_t margin_bucket(const BinaryNumber& lhs, const BinaryNumber& rhs);

// Index of a comparison of a query in an array of `margin_counter_count` counters: one for each precision, comparison,
// bucket, exact sign and kind of answer.
inline constexpr std::size_t margin_counter_count = 2 * comparison_count * margin_bucket_count * 2 * sign_kind_count;
std::size_t margin_counter(Precision precision, Comparison which, const BinaryNumber& lhs, const BinaryNumber& rhs,
                           SignKind kind);

}  // namespace axiscert::fuzzing
