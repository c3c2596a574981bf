// The header of the pipe's two streams, and the plan in it, from which the queries can be made again.
#pragma once

#include <iosfwd>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "kernel/plugin/pipe_format.h"
#include "fuzz/queries/source.h"

namespace axiscert {

struct PipePlan {
  struct Part {
    SourcePtr source;
    std::uint64_t queries;
  };
  std::uint64_t seed = 1;
  Precision precision = Precision::binary32;
  std::vector<Part> parts;   // in the stream's order; their queries have one predicate and one entry
  std::size_t measures = 0;  // so many of the predicate's measures, from the first on, follow each reply

  const Predicate& predicate() const { return parts.empty() ? predicate_named("") : parts.front().source->predicate(); }
  std::size_t entry() const { return parts.empty() ? 0 : parts.front().source->entry(); }
  const PredicateEntry& columns() const { return predicate().entries[entry()]; }
  // The queries of all parts together. Throws Error if the stream cannot count them.
  std::uint64_t queries() const;
};

// The header's bytes. Throws Error if the header cannot name a source (standard input, a path that is not UTF-8), if
// the sources have not one predicate and one entry, or if the predicate has fewer measures.
std::string header_of(const PipePlan& plan);

// The present paths of files, by base name; a file that is not listed is at the path in the plan.
using FilePlaces = std::map<std::string, std::string>;

struct PipeHeader {
  PipePlan plan;
  std::uint32_t size;  // in bytes
};

// The text with which the given bytes begin, for a message about a program that printed where bytes were expected.
// Empty if they do not begin with text.
std::string printed_text(std::string_view bytes);

// Reads a header from the stream, and the sources that its plan names. Throws Error that begins with `name` if it is
// not a header as header_of wrote it, or if its queries cannot be made again here: another version of axiscert or of a
// generator, or a file that is missing or was changed. `known` are the predicates of which a plan can be.
PipeHeader read_header(std::istream& in, const std::string& name, const FilePlaces& places,
                       std::span<const Predicate* const> known = predicates());

}  // namespace axiscert
