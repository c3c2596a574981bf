// The header of the pipe's two streams, and the plan in it: enough to make the queries again.
#pragma once

#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "fuzz/pipe/pipe_format.h"
#include "fuzz/queries/source.h"

namespace axiscert {

struct PipePlan {
  struct Part {
    SourcePtr source;
    std::uint64_t queries;
  };
  std::uint64_t seed = 1;
  Precision precision = Precision::binary32;
  std::vector<Part> parts;  // in the stream's order

  // Of all parts. Throws Error where the stream cannot count them.
  std::uint64_t queries() const;
};

// The header's bytes. Throws Error where a source cannot be named in it: standard input, a path that is not UTF-8.
std::string header_of(const PipePlan& plan);

// Where files are now, by base name; a file that is not named here is where the plan says.
using FilePlaces = std::map<std::string, std::string>;

struct PipeHeader {
  PipePlan plan;
  std::uint32_t size;  // in bytes
};

// What a program printed where bytes were due: the text that they begin with, for a message. Empty where they do not.
std::string printed(std::string_view bytes);

// Reads a header off the stream, and the sources that its plan names. Throws Error that begins with `name` where it is
// not a header as header_of wrote it, or where its queries cannot be made again here: another version of axiscert or of
// a generator, a file that is gone or was changed.
PipeHeader read_header(std::istream& in, const std::string& name, const FilePlaces& places);

}  // namespace axiscert
