#include "kernel/plugin/host/reply_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <string_view>

namespace axiscert::plugin {
namespace {

constexpr std::size_t longest_quote = 60;  // bytes of a program's output in a message

bool is_text(unsigned char c) { return (c >= 0x20 && c < 0x7f) || c == '\t'; }

// The bytes in quotes up to the end of their line, where they begin with text; empty where they do not.
std::string in_quotes(std::string_view bytes) {
  const auto end = std::find_if_not(bytes.begin(), bytes.end(), is_text);
  const std::string_view text(bytes.data(), std::min(static_cast<std::size_t>(end - bytes.begin()), longest_quote));
  constexpr std::size_t least = 3;  // fewer may be any bytes
  return text.size() < least ? "" : fmt::format("\"{}\"", text);
}

std::string_view view(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

ReplyReader::ReplyReader(std::span<const std::byte> header, std::size_t queries, bool wants_bits,
                         std::size_t measure_bytes)
    : header_(header), queries_(queries), wants_bits_(wants_bits), measure_bytes_(measure_bytes) {}

void ReplyReader::restart(bool is_next) {
  is_next_ = is_next;
  is_faulty_ = false;
  taken_ = 0;
  reply_.clear();
  fault_.clear();
  instead_of_header_.clear();
  verdicts_.clear();
  bits_.clear();
  measures_.clear();
}

std::size_t ReplyReader::take(std::span<const std::byte> bytes) {
  std::size_t used = 0;
  while (used < bytes.size() && !has_header() && !is_faulty_) {
    is_faulty_ = bytes[used] != header_[taken_];
    if (is_faulty_) break;
    ++taken_, ++used;
  }
  if (is_faulty_ && fault_.empty()) {
    // Within the magic it is no header; what came so far is then what the program printed.
    if (instead_of_header_.empty()) instead_of_header_ = view(header_.first(taken_));
    const std::size_t more =
        std::min(bytes.size() - used, longest_quote - std::min(longest_quote, instead_of_header_.size()));
    instead_of_header_ += view(bytes.subspan(used, more));
    return used + more;
  }
  while (used < bytes.size() && !is_complete() && !is_faulty_) {
    const std::size_t part = std::min(bytes.size() - used, reply_size() - reply_.size());
    reply_.insert(reply_.end(), bytes.begin() + static_cast<std::ptrdiff_t>(used),
                  bytes.begin() + static_cast<std::ptrdiff_t>(used + part));
    used += part;
    taken_ += part;
    if (reply_.size() == reply_size()) take_reply();
  }
  return used;
}

void ReplyReader::take_reply() {
  const std::string text = in_quotes(view(reply_));
  const auto fail = [&](const std::string& what) {
    is_faulty_ = true;
    const std::string which = queries_ == 1 ? "its reply" : fmt::format("reply {} of {}", count() + 1, queries_);
    fault_ = fmt::format("{} {}{}", which, what,
                         text.empty() ? "" : fmt::format("; it is text, {}: is it printed to standard output?", text));
  };
  pipe::ReplyRecord reply;
  std::memcpy(&reply, reply_.data(), sizeof reply);
  const bool has_measures = measure_bytes_ != 0;
  if ((reply.flags & ~pipe::has_bits) != (has_measures ? pipe::has_measures : 0)) {
    return fail(fmt::format("has flags {:#04x}; bit 0 says that comparison bits are given, {}the others are 0",
                            reply.flags,
                            has_measures ? "bit 1, which its manifest asks for, that measures follow, " : ""));
  }
  if (std::ranges::any_of(reply.padding, [](std::uint8_t byte) { return byte != 0; }))
    return fail("has bytes 3 to 8 that are not 0");
  const bool has_bits = (reply.flags & pipe::has_bits) != 0;
  if (!has_bits && reply.bits != 0) return fail("has comparison bits, without the flag that says so");
  if (!has_bits && wants_bits_) return fail("has no comparison bits, which its manifest says that it shows");
  verdicts_.push_back(reply.verdict);
  bits_.push_back(reply.bits);
  measures_.insert(measures_.end(), reply_.begin() + sizeof reply, reply_.end());
  reply_.clear();
}

bool ReplyReader::wants_more() const {
  return is_faulty_ && fault_.empty() && instead_of_header_.size() < longest_quote &&
         std::all_of(instead_of_header_.begin(), instead_of_header_.end(), is_text);
}

std::string ReplyReader::fault() const {
  if (!is_faulty_ || !fault_.empty()) return fault_;
  const bool is_no_header = taken_ < pipe::magic.size();
  const std::string text = is_no_header ? in_quotes(instead_of_header_) : "";
  if (is_next_) {
    return fmt::format("after its last reply it wrote more{}, and not the header of the next batch",
                       text.empty() ? "" : ", " + text);
  }
  if (is_no_header) {
    return fmt::format("it did not begin with the header of its queries, copied unchanged{}",
                       text.empty() ? "" : fmt::format(", but with {}; messages belong on standard error", text));
  }
  return fmt::format("it changed the header of its queries, at byte {}; a program copies it unchanged", taken_);
}

}  // namespace axiscert::plugin
