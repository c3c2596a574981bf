// A property of any bytes as a query file.
#pragma once

#include "fuzz/targets/target.h"

namespace axiscert::fuzzing {

// Checks that they are either refused by Error that names the file; or read, each query with the precision that it
// states, and that the lines written from the queries are read to the same bits (except a NaN's payload), ids and
// lines.
void check_round_trip(std::string_view bytes);

}  // namespace axiscert::fuzzing
