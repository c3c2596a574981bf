// The units of length in which a kernel answers as in that of its queries.
#pragma once

#include <cstdint>
#include <string_view>

#include "fuzz/fields/values.h"

namespace axiscert {

// Exponents of powers of two, by which every length of a query is multiplied.
struct WindowRecord {
  int low = 0, high = 0, scanned_low = 0, scanned_high = 0;
  std::uint64_t queries = 0;

  bool is_whole() const { return low == scanned_low && high == scanned_high; }

  static constexpr std::string_view about =
      "The powers of two times which the kernel answers as at scale 1, on clear queries that this scales exactly. Null "
      "where it was not asked: answers of a program, an interrupted run, a predicate without such queries, a kernel "
      "that "
      "does not give both answers to them.";
  AXISCERT_FIELDS(WindowRecord, AXISCERT_FIELD(low, "From 2^low on, every answer is that of scale 1."),
                  AXISCERT_FIELD(high, "Up to 2^high."), AXISCERT_FIELD(scanned_low, "The least power that was asked."),
                  AXISCERT_FIELD(scanned_high, "The greatest."),
                  AXISCERT_FIELD(queries, "The clear queries, each asked at every power."))
};

}  // namespace axiscert
