// The header of the pipe's streams (pipe_format.h), for the pipe and for the batches of a program.
#pragma once

#include <string>

#include "kernel/program/pipe_format.h"

namespace axiscert {

namespace pipe {

// The header's bytes: the head and the plan, which is filled with spaces up to a multiple of header_multiple.
std::string stream_header(std::string plan, const Predicate& predicate, std::size_t columns, Precision precision,
                          std::uint64_t count);

}  // namespace pipe

namespace plugin {

// The header that a program reads before the queries of each batch, with a count of 0. The plan names the predicate,
// its entry and the precision, and how many measures follow each reply where there are any; nothing can be made again
// from it.
std::string program_header(const Predicate& predicate, std::size_t entry, Precision precision,
                           std::size_t measures = 0);

}  // namespace plugin

}  // namespace axiscert
