// The area of a query's triangle, exactly.
#pragma once

#include "exact/numbers/surd.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {

// (B - A) x (C - A), whose length is twice the area. The coordinates must be finite.
template <class Real>
Vec3<BinaryNumber> exact_normal(const Query<Real>& q) {
  const auto vec = [](const Vec3<Real>& v) {
    return Vec3<BinaryNumber>{BinaryNumber(double(v.x)), BinaryNumber(double(v.y)), BinaryNumber(double(v.z))};
  };
  const Vec3<BinaryNumber> a = vec(q.a);
  return portable::cross(vec(q.b) - a, vec(q.c) - a);
}

}  // namespace axiscert
