#include "fuzz/pipe/replies.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "fuzz/text/file_bytes.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

// A hint that is added to a message if the bytes are text.
std::string text_hint(std::string_view bytes) {
  const std::string text = printed(bytes);
  return text.empty() ? "" : fmt::format("; it is text, \"{}\": did the program print to standard output?", text);
}

// The fault of a reply that differs in kind from the first one, or is not valid; empty if there is none.
std::string fault(const pipe::ReplyRecord& reply, bool has_bits) {
  const auto bytes = std::bit_cast<std::array<char, sizeof reply>>(reply);
  if (reply.verdict > static_cast<std::uint8_t>(Verdict::invalid)) {
    return fmt::format("verdict {}; 0 is contact, 1 separated, 2 undecided, 3 invalid{}", reply.verdict,
                       text_hint({bytes.data(), bytes.size()}));
  }
  if ((reply.flags & ~pipe::has_bits) != 0) {
    return fmt::format("flags {:#04x}; bit 0 says that comparison bits are given, the others are 0", reply.flags);
  }
  if ((reply.flags == pipe::has_bits) != has_bits) {
    return has_bits ? "no comparison bits, but the replies before it have them; all replies must have them, or none"
                    : "comparison bits, but the replies before it have none; all replies must have them, or none";
  }
  if (!has_bits && reply.bits != 0) {
    return fmt::format("comparison bits {:#06x} without the flag that says so (bit 0 of the second byte)", reply.bits);
  }
  const auto verdict = static_cast<Verdict>(reply.verdict), by_bits = verdict_of(first_test(), reply.bits);
  const bool decided = verdict == Verdict::contact || verdict == Verdict::separated;
  if (has_bits && decided && verdict != by_bits) {
    return fmt::format("{}, but its comparison bits {:#06x} say {}", name(verdict), reply.bits, name(by_bits));
  }
  return "";
}

}  // namespace

ReplyStream read_replies(std::istream& in, const std::string& name, const FilePlaces& places) {
  PipeHeader header = read_header(in, name, places);
  ReplyStream stream{name, std::move(header.plan), false, {}};
  const std::uint64_t due = stream.plan.queries();
  constexpr std::uint64_t size = sizeof(pipe::ReplyRecord);
  const auto fail = [&](const std::string& what) { throw Error(fmt::format("{}: {}", name, what)); };
  const auto came = [&] { return fmt::format("{} of {} replies", stream.replies.size(), due); };

  std::array<char, 1 << 16> block;
  std::size_t got = 1;
  // The count is only a claim: memory is allocated for the bytes that arrive.
  while (stream.replies.size() < due && got != 0) {
    const std::uint64_t wanted = std::min<std::uint64_t>(block.size(), (due - stream.replies.size()) * size);
    got = read_block(in, std::span(block).first(wanted), name);
    for (std::size_t i = 0; i + size <= got; i += size) {
      pipe::ReplyRecord reply;
      std::memcpy(&reply, block.data() + i, size);
      const std::size_t k = stream.replies.size();
      if (k == 0) stream.has_bits = (reply.flags & pipe::has_bits) != 0;
      if (const std::string wrong = fault(reply, stream.has_bits); !wrong.empty()) {
        fail(fmt::format("reply {} of {}, at byte {}: {}", k + 1, due, header.size + k * size, wrong));
      }
      stream.replies.push_back(reply);
    }
    if (got % size != 0)
      fail(fmt::format("ends after {} and {} bytes of the next; a reply has {}", came(), got % size, size));
  }
  if (stream.replies.size() < due) fail(fmt::format("ends after {}", came()));
  const std::size_t extra = read_block(in, std::span(block).first(64), name);
  if (extra != 0) {
    fail(fmt::format("continues after {}{}", came(), text_hint({block.data(), extra})));
  }
  return stream;
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
    if (stream.plan.seed != first.plan.seed)
      differ(fmt::format("made with seeds {} and {}; give one seed", first.plan.seed, stream.plan.seed));
    if (stream.has_bits != first.has_bits)
      differ("one gives comparison bits and the other none; all replies must have them, or none");
    const pipe::ReplyRecord* next = stream.replies.data();
    for (const PipePlan::Part& part : stream.plan.parts) {
      parts_.push_back({shared(part.source, stream).get(), stream.plan.precision, next, part.queries});
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
  const pipe::ReplyRecord& reply = find(source, precision)->first[position];
  Answer answer{static_cast<Verdict>(reply.verdict), std::nullopt};
  if (has_bits()) answer.bits = reply.bits;
  return answer;
}

}  // namespace axiscert
