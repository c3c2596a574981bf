// The ends of what one operation may give, of operands that reach from one float to another.
#pragma once

#include "kernel/permitted/permissions.h"

namespace axiscert::permitted {

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
