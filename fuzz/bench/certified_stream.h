#pragma once

namespace axiscert {

// Prints, for each precision and shape, how fast one sphere is asked of a mesh larger than the last cache, beside a
// plain read of the same bytes.
void print_certified_streams();

}  // namespace axiscert
