// One pair at a time: the sixteen comparisons in four compares of four lanes, as the article's last section suggests.
#pragma once

#include "kernel/kernel.h"

namespace axiscert {

// Sides and bits of the published formulae, bit for bit. `strict`, or `not_less`: a compare instruction that has only
// `>` makes a >= b from !(b > a), which is true where a side is NaN (an overflowed inf - inf). An edge whose radius
// comparison overflowed to inf > finite is then a separating axis although nothing is known of it: a missed contact.
template <Strictness strictness, class Real>
Implementation<Real> packed_implementation();

}  // namespace axiscert
