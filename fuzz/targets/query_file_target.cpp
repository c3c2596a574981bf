// Query files: either accepted, and the same queries when written and read again; or refused by Error.
#include <bit>

#include "fuzz/files/query_file.h"
#include "fuzz/targets/json_mutator.h"
#include "fuzz/targets/query_round_trip.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  axiscert::fuzzing::check_round_trip(axiscert::fuzzing::text_of(data, size));
  return 0;
}

// Changes JSON by its structure, a line at a time; every other time by its bytes.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t room, unsigned seed) {
  return axiscert::fuzzing::mutate_json_line(data, size, room, seed);
}
