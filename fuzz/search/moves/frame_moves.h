// The moves of a search that turn the axes of a box. Only sums and products: the same everywhere.
#pragma once

#include "fuzz/queries/query_shape.h"
#include "fuzz/search/moves/dice.h"

namespace axiscert {

// The axes of one box: those of another one of this query or of the other's; two of them exchanged, or one reversed; or
// turned about one of them by an angle of up to 1, down to 2^-digits. Precondition: the shape has a frame.
template <class Real>
void move_frame(Dice& random, const QueryShape& shape, Numbers<Real>& q, const Numbers<Real>& other);

}  // namespace axiscert
