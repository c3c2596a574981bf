// What holds of any bytes as a query file.
#pragma once

#include "fuzz/targets/target.h"

namespace axiscert::fuzzing {

// Refused by Error that names the file; or read, each query with the precision it says, and the lines written of them
// read to the same bits (a NaN's payload is none), ids and lines.
void check_round_trip(std::string_view bytes);

}  // namespace axiscert::fuzzing
