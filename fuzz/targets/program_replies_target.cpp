// The answer of a program to a batch, as the host reads it: the same from parts of any length, never more
// replies than queries, and not a byte beyond the last one; where it is refused, in one line.
//
// Input: the number of queries, options (bit 0: comparison bits are asked for, 1: the batch is not the program's first,
// 2: the input begins with the header itself), the length of a part; then the bytes.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <span>
#include <vector>

#include "fuzz/targets/target.h"
#include "kernel/plugin/host/reply_reader.h"
#include "kernel/plugin/pipe_format.h"
#include "kernel/sphere_triangle/query.h"

namespace {

using namespace axiscert;
using namespace axiscert::fuzzing;
using plugin::ReplyReader;

struct GivenStream {
  std::size_t queries, part;
  bool wants_bits, is_next, has_header;
};

// All that there is to know of a reader, in one text.
std::string state_of(const ReplyReader& reader) {
  std::string text =
      fmt::format("{} {} {} {}:", reader.has_header(), reader.is_complete(), reader.is_faulty(), reader.count());
  for (std::size_t i = 0; i < reader.count(); ++i)
    text += fmt::format(" {}/{}", reader.verdicts()[i], reader.bits()[i]);
  return text;
}

void check(const GivenStream& given, std::span<const std::byte> header, std::span<const std::byte> stream) {
  ReplyReader whole(header, given.queries, given.wants_bits), parts(header, given.queries, given.wants_bits);
  whole.restart(given.is_next);
  parts.restart(given.is_next);
  const std::size_t taken = whole.take(stream);
  std::size_t taken_in_parts = 0;
  while (taken_in_parts < stream.size()) {
    const std::size_t size = std::min(given.part, stream.size() - taken_in_parts),
                      got = parts.take(stream.subspan(taken_in_parts, size));
    taken_in_parts += got;
    if (got < size) break;
  }
  if (state_of(whole) != state_of(parts))
    report_fault(fmt::format("in parts of {}: {}, and at once: {}", given.part, state_of(parts), state_of(whole)));
  if (whole.count() > given.queries) report_fault("more replies than queries");
  if (whole.is_complete() && whole.is_faulty()) report_fault("complete, and refused");
  if (whole.is_faulty() != !whole.fault().empty())
    report_fault("refused without a reason, or a reason without a refusal");
  if (whole.is_faulty()) return check_message(printable_line(whole.fault()));
  const std::size_t due = header.size() + given.queries * sizeof(pipe::ReplyRecord);
  if (taken != std::min(stream.size(), due) || taken_in_parts != taken)
    report_fault(fmt::format("{} bytes taken of {}, {} are due", taken, stream.size(), due));
  if (whole.is_complete() != (taken == due)) report_fault("complete before the end, or not at it");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t options = 3;
  if (size < options) return -1;
  const auto has = [&](unsigned bit) { return ((data[1] >> bit) & 1) != 0; };
  const GivenStream given{data[0], std::size_t{1} + data[2], has(0), has(1), has(2)};
  const std::string header = plugin::program_header(sphere_triangle_predicate(), 0, Precision::binary32);
  const std::string stream = (given.has_header ? header : "") + std::string(text_of(data + options, size - options));
  check(given, std::as_bytes(std::span(header)), std::as_bytes(std::span(stream)));
  return 0;
}
