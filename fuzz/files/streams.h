// The pipe's streams: queries made in order and written as they are made, the work of `axiscert generate`, and the
// replies to them.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "exact/judge/judge.h"
#include "fuzz/files/pipe_header.h"

namespace axiscert {
enum class QueryEncoding : std::uint8_t {
  binary,     // the query stream of kernel/plugin/pipe_format.h, header included
  json_lines  // the query file of fuzz/files/query_file.h; each id is the address
};

// Calls `write` from one thread at a time, in order. Keeps a few blocks of 4096 queries per thread in memory, whatever
// the plan's size. An exception from `write` ends the stream and is passed on.
void write_queries(const PipePlan& plan, QueryEncoding encoding, int threads,
                   const std::function<void(std::string_view)>& write);

// A user's program's replies to the queries that it was sent, used in place of running a kernel.

// One reply stream, read and checked completely.
struct ReplyStream {
  std::string name;  // used in messages
  PipePlan plan;
  bool has_bits = false;
  std::vector<pipe::ReplyRecord> replies;
  std::vector<double> numbers;  // the measures of each reply, plan.measures of them, one reply after the other

  Answer at(std::uint64_t position) const;
  std::vector<double> measures(std::uint64_t position) const;
};

// Throws Error that begins with `name` and says which reply is wrong and at which byte: a stream is never read
// partially. `known` as in read_header.
ReplyStream read_replies(std::istream& in, const std::string& name, const FilePlaces& places,
                         std::span<const Predicate* const> known = predicates());

// The replies of one program, with at most one stream in each precision. Immutable: any thread may ask at any time.
class StoredReplies {
 public:
  // Throws Error if the streams do not fit together: two of one precision, different predicates or seeds, comparison
  // bits or measures in only some, different files under one name.
  explicit StoredReplies(std::vector<ReplyStream> streams);

  std::uint64_t seed() const { return streams_.front().plan.seed; }
  bool has_bits() const { return streams_.front().has_bits; }
  // The replies give so many of the predicate's measures, from the first on.
  std::size_t measure_count() const { return streams_.front().plan.measures; }
  std::vector<Precision> precisions() const;
  const std::vector<SourcePtr>& sources() const { return sources_; }
  // The number of replies; 0 if the program was not asked.
  std::uint64_t size(const Source& source, Precision precision) const;
  // Precondition: `source` is one of sources(), position < size.
  Answer at(const Source& source, Precision precision, std::uint64_t position) const;
  // The measures that were given with that answer; NaN where one was not. The same precondition.
  std::vector<double> measures(const Source& source, Precision precision, std::uint64_t position) const;

 private:
  // The replies to one source in one precision.
  struct Part {
    const Source* source;
    Precision precision;
    const ReplyStream* stream;
    std::uint64_t first, size;  // among the stream's replies
  };
  const Part* find(const Source& source, Precision precision) const;
  SourcePtr shared(const SourcePtr& source, const ReplyStream& stream);

  std::vector<ReplyStream> streams_;
  std::vector<SourcePtr> sources_;
  std::vector<Part> parts_;
};

// The formulae that the program is said to compute, as given on the command line; empty: none.
struct ReplyClaim {
  std::string conforms_to, formulae;
};

}  // namespace axiscert
