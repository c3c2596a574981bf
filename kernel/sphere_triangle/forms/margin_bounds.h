// The constants of the bounds beside each margin, proved to suffice (docs/proofs.md). Written by
// proofs/write_thresholds.py out of the Coq theory: do not edit.
#pragma once

namespace axiscert::filter {

// `units` are multiples of the relative error of an operation times unit_factor; the others are factors of what was
// bounded before (exact/sphere_triangle/oracles/margins-inl.h).
struct MarginBounds {
  static constexpr double unit_factor = 1.0625;
  static constexpr double vertex_radius_units = 6;
  static constexpr double vertex_side_units = 15;
  static constexpr double normal_units = 8;
  static constexpr double offset_units = 4;
  static constexpr double plane_lhs_units = 2;
  static constexpr double plane_rhs_units = 6;
  static constexpr double edge_square_units = 4;
  static constexpr double edge_rhs_units = 8;
  static constexpr double edge_side_units = 3;
  static constexpr double edge_length_units = 6;
  static constexpr double once = 1.0625;
  static constexpr double once_offset = 1.125;
  static constexpr double twice = 2.125;
  static constexpr double thrice_in_side = 3.1;
  static constexpr double thrice = 3.2;
};

// Multiples of u: of S, S E and S E^2, where S as computed is from least_square to greatest_square
// (kernel/sphere_triangle/certified/thresholds.h).
struct CoarseBounds {
  static constexpr double degree_2 = 20.1875;
  static constexpr double degree_4 = 11.15625;
  static constexpr double degree_6 = 5.84375;
  static constexpr double least_square_binary32 = 0x1p-21;
  static constexpr double greatest_square_binary32 = 0x1p+38;
  static constexpr double least_square_binary64 = 0x1p-300;
  static constexpr double greatest_square_binary64 = 0x1p+300;
};

// Multiples of u W, W as computed no less than least_square and the scaled normal's square no less than least_normal
// (kernel/sphere_triangle/certified/conservative_step-inl.h).
struct ConservativeBounds {
  static constexpr double error = 10;
  static constexpr double square_error = 19.125;
  static constexpr double least_square_binary32 = 0x1p-42;
  static constexpr double least_normal_binary32 = 0x1p-60;
  static constexpr double least_square_binary64 = 0x1p-400;
  static constexpr double least_normal_binary64 = 0x1p-120;
};

}  // namespace axiscert::filter
