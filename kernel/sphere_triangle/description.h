// The description of the predicate sphere against triangle.
#pragma once

namespace axiscert {

struct Predicate;  // kernel/predicate.h

const Predicate& sphere_triangle_predicate();

}  // namespace axiscert
