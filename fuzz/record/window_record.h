// The units of length in which a kernel answers as in that of its queries.
#pragma once

#include <cstdint>
#include <string_view>

#include "fuzz/fields/json_form.h"

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
  static constexpr auto fields(auto&& visit) {
    using Of = WindowRecord;
    return visit(field(&Of::low, {"low", "From 2^low on, every answer is that of scale 1."}),
                 field(&Of::high, {"high", "Up to 2^high."}),
                 field(&Of::scanned_low, {"scanned_low", "The least power that was asked."}),
                 field(&Of::scanned_high, {"scanned_high", "The greatest."}),
                 field(&Of::queries, {"queries", "The clear queries, each asked at every power."}));
  }
};

}  // namespace axiscert
