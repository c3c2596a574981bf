#pragma once

namespace axiscert {

// Prints, for each precision and shape, the rate at which one sphere is tested against a mesh larger than the
// last-level cache, beside that of a read alone of the same bytes.
void print_certified_streams();

}  // namespace axiscert
