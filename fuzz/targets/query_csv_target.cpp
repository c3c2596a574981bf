// The query file target for CSV. It is changed only by bytes: commas and digits are all the structure that it has.
#include "fuzz/targets/query_round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  axiscert::fuzzing::check_round_trip(axiscert::fuzzing::text_of(data, size));
  return 0;
}
