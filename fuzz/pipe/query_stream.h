// Queries made in order and written as they are made: what `axiscert generate` does.
#pragma once

#include <functional>
#include <string_view>

#include "fuzz/pipe/pipe_header.h"

namespace axiscert {

enum class QueryEncoding : std::uint8_t {
  binary,     // the query stream of fuzz/pipe/pipe_format.h, header included
  json_lines  // the query file of fuzz/files/query_file.h; the id is the address
};

// Calls `write` from one thread at a time, in order. Holds some blocks of 4096 queries a thread, whatever the plan's
// size. What `write` throws ends it and comes out.
void write_queries(const PipePlan& plan, QueryEncoding encoding, int threads,
                   const std::function<void(std::string_view)>& write);

}  // namespace axiscert
