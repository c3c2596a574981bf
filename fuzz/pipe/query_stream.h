// Queries made in order and written as they are made: the work of `axiscert generate`.
#pragma once

#include <functional>
#include <string_view>

#include "fuzz/pipe/pipe_header.h"

namespace axiscert {

enum class QueryEncoding : std::uint8_t {
  binary,     // the query stream of kernel/program/pipe_format.h, header included
  json_lines  // the query file of fuzz/files/query_file.h; each id is the address
};

// Calls `write` from one thread at a time, in order. Keeps a few blocks of 4096 queries per thread in memory, whatever
// the plan's size. An exception from `write` ends the stream and is passed on.
void write_queries(const PipePlan& plan, QueryEncoding encoding, int threads,
                   const std::function<void(std::string_view)>& write);

}  // namespace axiscert
