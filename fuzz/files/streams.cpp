#include "fuzz/files/streams.h"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <tbb/parallel_pipeline.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <exception>
#include <optional>

#include "fuzz/files/query_file.h"
#include "fuzz/queries/source.h"
#include "fuzz/text/file_bytes.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

constexpr std::uint64_t block_size = 4096;

struct Block {
  const Source* source;
  std::uint64_t first, size;
};

// The blocks of a plan in order.
class Blocks {
 public:
  explicit Blocks(const PipePlan& plan) : plan_(plan) {}
  std::optional<Block> next() {
    while (part_ < plan_.parts.size() && done_ == plan_.parts[part_].queries) {
      ++part_;
      done_ = 0;
    }
    if (part_ == plan_.parts.size()) return std::nullopt;
    const Block block{plan_.parts[part_].source.get(), done_, std::min(block_size, plan_.parts[part_].queries - done_)};
    done_ += block.size;
    return block;
  }

 private:
  const PipePlan& plan_;
  std::size_t part_ = 0;
  std::uint64_t done_ = 0;
};

template <class Real>
std::string encoded(const Block& block, std::uint64_t seed, QueryEncoding encoding) {
  const Source& source = *block.source;
  const std::size_t columns = source.columns().size();
  QueryBatch<Real> batch(block.size, columns);
  source.fill(seed, block.first, block.size, batch);
  std::string bytes;
  if (encoding == QueryEncoding::binary) bytes.reserve(block.size * columns * sizeof(Real));
  for (std::size_t i = 0; i < block.size; ++i) {
    const Numbers<Real> numbers = batch[i];
    switch (encoding) {
      case QueryEncoding::binary:
        bytes.append(reinterpret_cast<const char*>(numbers.data()), columns * sizeof(Real));
        break;
      case QueryEncoding::json_lines: {
        const Address address = address_of(source, seed, precision_of<Real>, block.first + i);
        bytes += query_line({text(address), precision_of<Real>, numbers, &source.predicate(), source.entry()}) + '\n';
        break;
      }
    }
  }
  return bytes;
}

}  // namespace

void write_queries(const PipePlan& plan, QueryEncoding encoding, int threads,
                   const std::function<void(std::string_view)>& write) {
  if (encoding == QueryEncoding::binary) write(header_of(plan));
  Blocks blocks(plan);
  // Not thrown through the pipeline, which would not free the blocks that are in progress.
  std::exception_ptr failed;
  std::atomic<bool> stopped = false;
  const auto next = [&](tbb::flow_control& flow) {
    const auto block = stopped ? std::nullopt : blocks.next();
    if (!block) flow.stop();
    return block.value_or(Block{});
  };
  const auto encode = [&](const Block& block) {
    return plan.precision == Precision::binary32 ? encoded<float>(block, plan.seed, encoding)
                                                 : encoded<double>(block, plan.seed, encoding);
  };
  const auto put = [&](const std::string& bytes) {
    if (stopped) return;
    try {
      write(bytes);
    } catch (...) {
      failed = std::current_exception();
      stopped = true;
    }
  };
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  tbb::parallel_pipeline(static_cast<std::size_t>(4 * threads),
                         tbb::make_filter<void, Block>(tbb::filter_mode::serial_in_order, next) &
                             tbb::make_filter<Block, std::string>(tbb::filter_mode::parallel, encode) &
                             tbb::make_filter<std::string, void>(tbb::filter_mode::serial_in_order, put));
  if (failed) std::rethrow_exception(failed);
}

namespace {

// A hint that is added to a message if the bytes are text.
std::string text_hint(std::string_view bytes) {
  const std::string text = printed_text(bytes);
  return text.empty() ? "" : fmt::format("; it is text, \"{}\": did the program print to standard output?", text);
}

// The fault of a reply that differs in kind from the first one, or is not valid; empty if there is none.
std::string fault(const pipe::ReplyRecord& reply, bool has_bits, std::size_t measures, const Predicate& predicate) {
  const auto bytes = std::bit_cast<std::array<char, sizeof reply>>(reply);
  if (reply.verdict > static_cast<std::uint8_t>(Verdict::invalid)) {
    return fmt::format("verdict {}; 0 is contact, 1 separated, 2 undecided, 3 invalid{}", reply.verdict,
                       text_hint({bytes.data(), bytes.size()}));
  }
  const unsigned known_flags = pipe::has_bits | (measures != 0 ? unsigned{pipe::has_measures} : 0);
  if ((reply.flags & ~known_flags) != 0) {
    return fmt::format("flags {:#04x}; bit 0 says that comparison bits are given, {}the others are 0", reply.flags,
                       measures != 0 ? "bit 1 that measures follow, " : "");
  }
  if (measures != 0 && (reply.flags & pipe::has_measures) == 0) {
    return fmt::format("flags {:#04x}, without bit 1: the plan asks for {} measures after each reply", reply.flags,
                       measures);
  }
  if (std::ranges::any_of(reply.padding, [](std::uint8_t byte) { return byte != 0; }))
    return "bytes 3 to 8 of the reply are not 0";
  if (((reply.flags & pipe::has_bits) != 0) != has_bits) {
    return has_bits ? "no comparison bits, but the replies before it have them; all replies must have them, or none"
                    : "comparison bits, but the replies before it have none; all replies must have them, or none";
  }
  if (!has_bits && reply.bits != 0) {
    return fmt::format("comparison bits {:#06x} without the flag that says so (bit 0 of the second byte)", reply.bits);
  }
  const std::size_t comparisons = predicate.comparisons.size();
  if (comparisons < 8 * sizeof reply.bits && (reply.bits >> comparisons) != 0) {
    return fmt::format("comparison bits {:#06x}, but the predicate {} has {} comparisons; the other bits are 0",
                       reply.bits, predicate.id, comparisons);
  }
  const auto verdict = static_cast<Verdict>(reply.verdict), by_bits = verdict_of(predicate, reply.bits);
  const bool decided = verdict == Verdict::contact || verdict == Verdict::separated;
  if (has_bits && decided && verdict != by_bits) {
    return fmt::format("{}, but its comparison bits {:#06x} say {}", name(verdict), reply.bits, name(by_bits));
  }
  return "";
}

// Appends `count` numbers of the precision.
void append_numbers(std::vector<double>& numbers, const char* bytes, std::size_t count, Precision precision) {
  const auto append = [&]<class Real>(Real number) {
    for (std::size_t k = 0; k < count; ++k) {
      std::memcpy(&number, bytes + k * sizeof number, sizeof number);
      numbers.push_back(number);
    }
  };
  if (precision == Precision::binary32) append(0.0F);
  else append(0.0);
}

// Reads the replies that follow a header of `header_size` bytes, and the measures that follow each reply.
void read_records(std::istream& in, std::uint32_t header_size, ReplyStream& stream) {
  std::vector<pipe::ReplyRecord>& records = stream.replies;
  const std::string& name = stream.name;
  const std::uint64_t due = stream.plan.queries();
  const std::size_t measures = stream.plan.measures;
  const std::uint64_t size = sizeof(pipe::ReplyRecord) + pipe::record_size_of(stream.plan.precision, measures);
  const auto fail = [&](const std::string& what) { throw Error(fmt::format("{}: {}", name, what)); };
  const auto came = [&] { return fmt::format("{} of {} replies", records.size(), due); };

  // A whole number of replies at a time.
  std::vector<char> block((std::size_t{1} << 16) / size * size);
  std::size_t got = 1;
  // The count is only a claim: memory is allocated for the bytes that arrive.
  while (records.size() < due && got != 0) {
    const std::uint64_t wanted = std::min<std::uint64_t>(block.size(), (due - records.size()) * size);
    got = read_block(in, std::span(block).first(wanted), name);
    for (std::size_t i = 0; i + size <= got; i += size) {
      pipe::ReplyRecord reply;
      std::memcpy(&reply, block.data() + i, sizeof reply);
      const std::size_t k = records.size();
      if (k == 0) stream.has_bits = (reply.flags & pipe::has_bits) != 0;
      if (const std::string wrong = fault(reply, stream.has_bits, measures, stream.plan.predicate()); !wrong.empty()) {
        fail(fmt::format("reply {} of {}, at byte {}: {}", k + 1, due, header_size + k * size, wrong));
      }
      records.push_back(reply);
      append_numbers(stream.numbers, block.data() + i + sizeof reply, measures, stream.plan.precision);
    }
    if (got % size != 0)
      fail(fmt::format("ends after {} and {} bytes of the next; a reply has {}", came(), got % size, size));
  }
  if (records.size() < due) fail(fmt::format("ends after {}", came()));
  const std::size_t extra = read_block(in, std::span(block).first(64), name);
  if (extra != 0) {
    fail(fmt::format("continues after {}{}", came(), text_hint({block.data(), extra})));
  }
}

}  // namespace

ReplyStream read_replies(std::istream& in, const std::string& name, const FilePlaces& places,
                         std::span<const Predicate* const> known) {
  PipeHeader header = read_header(in, name, places, known);
  ReplyStream stream{name, std::move(header.plan), false, {}, {}};
  read_records(in, header.size, stream);
  return stream;
}

Answer ReplyStream::at(std::uint64_t position) const {
  const pipe::ReplyRecord& reply = replies[position];
  Answer found{static_cast<Verdict>(reply.verdict), std::nullopt};
  if (has_bits) found.bits = static_cast<ComparisonBits>(reply.bits);
  return found;
}

std::vector<double> ReplyStream::measures(std::uint64_t position) const {
  const auto first = numbers.begin() + static_cast<std::ptrdiff_t>(position * plan.measures);
  return {first, first + static_cast<std::ptrdiff_t>(plan.measures)};
}

StoredReplies::StoredReplies(std::vector<ReplyStream> streams) : streams_(std::move(streams)) {
  // The order in which the streams were given has no meaning.
  std::sort(streams_.begin(), streams_.end(),
            [](const ReplyStream& x, const ReplyStream& y) { return x.plan.precision < y.plan.precision; });
  const ReplyStream& first = streams_.front();
  std::optional<Precision> last;
  for (const ReplyStream& stream : streams_) {
    const auto differ = [&](const std::string& what) {
      throw Error(fmt::format("{} and {}: {}", first.name, stream.name, what));
    };
    if (stream.plan.precision == last) {
      throw Error(fmt::format("{}: a second stream in {}; give one stream per precision", stream.name, name(*last)));
    }
    last = stream.plan.precision;
    if (&stream.plan.predicate() != &first.plan.predicate() || stream.plan.entry() != first.plan.entry()) {
      differ(fmt::format("of {}, entry {}, and of {}, entry {}; give streams of one predicate and entry",
                         first.plan.predicate().id, first.plan.columns().name, stream.plan.predicate().id,
                         stream.plan.columns().name));
    }
    if (stream.plan.seed != first.plan.seed)
      differ(fmt::format("made with seeds {} and {}; give one seed", first.plan.seed, stream.plan.seed));
    if (stream.has_bits != first.has_bits)
      differ("one gives comparison bits and the other none; all replies must have them, or none");
    if (stream.plan.measures != first.plan.measures)
      differ(fmt::format("{} and {} measures; generate the queries of both with one --measures", first.plan.measures,
                         stream.plan.measures));
    std::uint64_t next = 0;
    for (const PipePlan::Part& part : stream.plan.parts) {
      parts_.push_back({shared(part.source, stream).get(), stream.plan.precision, &stream, next, part.queries});
      next += part.queries;
    }
  }
}

// The source that the record names: the same one if the streams of both precisions have it.
SourcePtr StoredReplies::shared(const SourcePtr& source, const ReplyStream& stream) {
  const Precision precision = stream.plan.precision;
  for (const SourcePtr& other : sources_) {
    if (other->name() != source->name()) continue;
    const bool is_same = other->address_name() == source->address_name() && !find(*other, precision);
    if (is_same && other->fixed_size(precision) == source->fixed_size(precision)) return other;
    throw Error(
        fmt::format("{}: {} appears twice, or is another file or was read differently than in the other stream; "
                    "judge the streams separately",
                    stream.name, source->name()));
  }
  return sources_.emplace_back(source);
}

std::vector<Precision> StoredReplies::precisions() const {
  std::vector<Precision> all;
  for (const ReplyStream& stream : streams_) all.push_back(stream.plan.precision);
  return all;
}

const StoredReplies::Part* StoredReplies::find(const Source& source, Precision precision) const {
  for (const Part& part : parts_) {
    if (part.source == &source && part.precision == precision) return &part;
  }
  return nullptr;
}

std::uint64_t StoredReplies::size(const Source& source, Precision precision) const {
  const Part* part = find(source, precision);
  return part ? part->size : 0;
}

Answer StoredReplies::at(const Source& source, Precision precision, std::uint64_t position) const {
  const Part* part = find(source, precision);
  return part->stream->at(part->first + position);
}

std::vector<double> StoredReplies::measures(const Source& source, Precision precision, std::uint64_t position) const {
  const Part* part = find(source, precision);
  return part->stream->measures(part->first + position);
}

}  // namespace axiscert
