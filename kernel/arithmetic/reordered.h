// The same operations in another order of association.
#pragma once

#include "kernel/arithmetic/number.h"

namespace axiscert::arithmetic {

// The two products of a dot product that are added first; the published order is x + y. Addition commutes, so these
// three are all the orders.
enum class FirstPair { y_and_z, x_and_z };

template <class Base, FirstPair first>
struct DotOrder : Number<DotOrder<Base, first>, Base> {
  using Number<DotOrder, Base>::Number;
  static DotOrder dot(const Vec3<DotOrder>& u, const Vec3<DotOrder>& v) {
    const DotOrder x = u.x * v.x, y = u.y * v.y, z = u.z * v.z;
    return first == FirstPair::y_and_z ? x + (y + z) : (x + z) + y;
  }
};

// rr (e e) in place of (rr e) e.
template <class Base>
struct SquareFirst : Number<SquareFirst<Base>, Base> {
  using Number<SquareFirst, Base>::Number;
  static SquareFirst times_square(const SquareFirst& rr, const SquareFirst& e) { return rr * (e * e); }
};

}  // namespace axiscert::arithmetic
