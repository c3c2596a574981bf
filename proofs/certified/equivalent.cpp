#include "proofs/certified/equivalent.h"

#include <algorithm>
#include <array>

namespace axiscert::proofs::certified {
namespace {

constexpr std::string_view few_units =
    "a unit is at most 2^-60 of the greatest number, all are below 2^62 units, and the bound is at most 2^-98 "
    "of the terms' sizes: of degree 2 it is below 2^30 units, so the condition always holds";
constexpr std::string_view radius_nan =
    "a radius that is not a number is not in the range of the bounds, and the answer is not used";
constexpr std::string_view radius_in_range =
    "a radius in the range of the bounds is 0 or at least 2^-100, and a number has at least 2^-101 units: the "
    "product does not underflow";
constexpr std::string_view radius_in_units =
    "the margin is open only where r is |A| within 2^-40 of it, so r's last bit, 2^-53 of r, is a whole "
    "number of units, which are 2^-60 of the greatest or less; else the sign is known before";
constexpr std::string_view first_is_greater =
    "the second operand of this sum is less than 2^-40 of the first, which is a sum of squares: what is lost "
    "of the first is zero, with either sign";
constexpr std::string_view difference_is_exact =
    "where |A| and r differ by less than a half the difference of their squares is exact, and this error of "
    "it is zero either way; where they do not, the margin exceeds its bound by far more than a rounding error";
constexpr std::string_view sign_is_lost = "the sign of a component of N, which is squared or compared with zero";
constexpr std::string_view zero_is_beyond = "a side that is zero counts like one that is positive";
constexpr std::string_view powers_of_two =
    "powers of two: scaling is exact whichever of them it takes, and the greatest component is between 1 and "
    "2 afterwards";
constexpr std::string_view zeros_alone =
    "the greatest component is 0 or, after the scaling before, at least 2^-85 (binary64: 2^-946): only zeros, "
    "which stay zero, meet the limit";
constexpr std::string_view after_scaling =
    "after scaling the greatest component is between 1 and 2: W is between 1 and 12 and the sum of squares at "
    "most 40, or a number is not finite and neither limit decides";
constexpr std::string_view all_zero =
    "after scaling W is at least 1, or all numbers are 0 and nothing separates, a contact with and without "
    "the condition";

constexpr auto all = std::to_array<Equivalent>({
    {"conservative_scaled", 32, "0x1p-100 halved", powers_of_two},
    {"conservative_scaled", 32, "0x1p-100 doubled", powers_of_two},
    {"conservative_scaled", 32, "0x1p+64 halved", powers_of_two},
    {"conservative_scaled", 32, "0x1p+64 doubled", powers_of_two},
    {"conservative_scaled", 32, "0x1p-120 halved", zeros_alone},
    {"conservative_scaled", 32, "0x1p-120 doubled", zeros_alone},
    {"conservative_scaled", 32, "0x1p+60 halved", after_scaling},
    {"conservative_scaled", 32, "0x1p+60 doubled", after_scaling},
    {"conservative_scaled", 32, "0x1p-42 halved", after_scaling},
    {"conservative_scaled", 32, "0x1p-42 doubled", after_scaling},
    {"conservative_scaled", 32, "both 317: the first condition dropped", all_zero},
    {"conservative_scaled", 64, "0x1p-900 halved", powers_of_two},
    {"conservative_scaled", 64, "0x1p-900 doubled", powers_of_two},
    {"conservative_scaled", 64, "0x1p+128 halved", powers_of_two},
    {"conservative_scaled", 64, "0x1p+128 doubled", powers_of_two},
    {"conservative_scaled", 64, "0x1p-1000 halved", zeros_alone},
    {"conservative_scaled", 64, "0x1p-1000 doubled", zeros_alone},
    {"conservative_scaled", 64, "0x1p+400 halved", after_scaling},
    {"conservative_scaled", 64, "0x1p+400 doubled", after_scaling},
    {"conservative_scaled", 64, "0x1p-400 halved", after_scaling},
    {"conservative_scaled", 64, "0x1p-400 doubled", after_scaling},
    {"conservative_scaled", 64, "both 317: the first condition dropped", all_zero},
    {"deep_vertex_radius", 64, "0x1p+60 halved", few_units},
    {"deep_vertex_radius", 64, "0x1p+60 doubled", few_units},
    {"deep_vertex_radius", 64, "both 411: the second condition dropped", few_units},
    {"deep_vertex_radius", 64, "both 304: the first condition dropped", radius_in_units},
    {"deep_vertex_radius", 64, "both 304: the second condition dropped", radius_in_range},
    {"deep_vertex_radius", 64, "both 398: the second condition dropped", radius_in_units},
    {"deep_vertex_radius", 64, "both 316: the first condition dropped", radius_nan},
    {"deep_vertex_radius", 64, "subtract 249: operands exchanged", first_is_greater},
    {"deep_vertex_radius", 64, "subtract 253: operands exchanged", difference_is_exact},
    {"deep_vertex_radius", 64, "subtract 254: operands exchanged", difference_is_exact},
    {"deep_vertex_radius", 64, "subtract 256: operands exchanged", difference_is_exact},
    {"deep_vertex_sides", 64, "0x1p+60 halved", few_units},
    {"deep_vertex_sides", 64, "0x1p+60 doubled", few_units},
    {"deep_vertex_sides", 64, "both 650: the second condition dropped", few_units},
    {"deep_vertex_sides", 64, "both 684: the second condition dropped", few_units},
    {"deep_vertex_sides", 64, "either 653: the first condition dropped", zero_is_beyond},
    {"deep_edge_radius", 64, "both 579: the first condition dropped", radius_nan},
    {"deep_edge_radius", 64, "both 567: the second condition dropped", radius_in_range},
    {"deep_edge_radius", 64, "both 791: the second condition dropped", few_units},
    {"deep_edge_radius", 64, "word_subtract 742: operands exchanged", sign_is_lost},
    {"deep_edge_radius", 64, "word_subtract 745: operands exchanged", sign_is_lost},
    {"deep_edge_radius", 64, "word_subtract 748: operands exchanged", sign_is_lost},
    {"deep_edge_side", 64, "both 945: the second condition dropped", few_units},
    {"deep_edge_side", 64, "either 929: the first condition dropped", zero_is_beyond},
    {"deep_plane_radius", 64, "both 652: the first condition dropped", radius_nan},
    {"deep_plane_radius", 64, "both 640: the second condition dropped", radius_in_range},
    {"deep_plane_radius", 64, "both 948: the second condition dropped", few_units},
});

}  // namespace

std::span<const Equivalent> equivalent_faults() { return all; }

const Equivalent* reason_of_equivalence(const RecordedStep& step, std::string_view fault) {
  const auto found = std::ranges::find_if(
      all, [&](const Equivalent& e) { return e.step == step.name && e.bits == step.bits && e.fault == fault; });
  return found == all.end() ? nullptr : &*found;
}

}  // namespace axiscert::proofs::certified
