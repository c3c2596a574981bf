// What a compiler of shaders may do to an expression, as sets of permissions by name (docs/gpu.md), and the ends of
// what one operation may then give, of operands that reach from one float to another.
#pragma once

#include <array>
#include <string_view>

namespace axiscert::permitted {

struct Permissions {
  bool faithful = false;      // a result is either float around the exact one; else the nearest
  bool reassociated = false;  // sums and products of several terms, in any order and grouping, across statements
  bool fused = false;         // a product and a sum may be rounded once
  bool factored = false;      // a b + a c may be a (b + c)
  bool flushed = false;       // what is below 2^-126 in size may be 0, operands and results
  bool divided = false;       // a quotient is within 2.5 ulp, where its divisor is from 2^-126 to 2^126; else anything
  bool kept = false;          // translated vertices and quotients are behind barriers: one value each, at every use
};

struct Part {
  std::string_view name;
  Permissions permissions;
  std::string_view summary;
};

// Source of `wgsl`: WebGPU Shading Language, sections 15.7.2 to 15.7.5, and `factored`, which compilers do beyond it.
inline constexpr auto parts = std::to_array<Part>({
    {"faithful", {.faithful = true}, "either float around each result"},
    {"reassociated", {.reassociated = true}, "sums and products in any order and grouping"},
    {"fused", {.fused = true}, "any product and sum rounded once"},
    {"factored", {.reassociated = true, .factored = true}, "any order and grouping, and common factors taken out"},
    {"flushed", {.flushed = true}, "any subnormal operand or result 0"},
    {"divided", {.divided = true}, "a quotient within 2.5 ulp"},
    {"wgsl",
     {.faithful = true, .reassociated = true, .fused = true, .factored = true, .flushed = true, .divided = true},
     "all that WGSL permits, and common factors taken out"},
    {"wgsl-kept",
     {.faithful = true,
      .reassociated = true,
      .fused = true,
      .factored = true,
      .flushed = true,
      .divided = true,
      .kept = true},
     "the same, with the translated vertices and quotients behind barriers"},
});

// Both ends are attained. Beyond the greatest float a value is indeterminate: from -infinity to infinity.
struct Reach {
  float least, greatest;
  bool operator==(const Reach&) const = default;
};

Reach negative(Reach r);
Reach joined(Reach a, Reach b);
// Indeterminate where an end is not finite.
Reach checked(Reach r);
// With 0, where r has a subnormal number and flushing is permitted.
Reach flushed(const Permissions& permissions, Reach r);

Reach sum_of(const Permissions& permissions, Reach a, Reach b);
Reach product_of(const Permissions& permissions, Reach a, Reach b);
// x y + z, rounded once, to nearest: faithful roundings of product and sum reach at least as far.
Reach fused_of(const Permissions& permissions, Reach a, Reach b, Reach z);
// The ends of the divisor are tried. What is divided by 0 is indeterminate; by WGSL too where the divisor is beyond
// 2^-126 or 2^126 in size.
Reach quotient_of(const Permissions& permissions, Reach a, Reach b);

// For operands that are floats.
Reach rounded_sum(const Permissions& permissions, float a, float b);
Reach rounded_product(const Permissions& permissions, float a, float b);
Reach rounded_quotient(const Permissions& permissions, float a, float b);

}  // namespace axiscert::permitted
