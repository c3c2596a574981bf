// Reads what a program writes in answer to one batch: the batch's header, unchanged, and a reply for each query
// (kernel/plugin/pipe_format.h). The bytes come as a pipe gives them, in parts of any length.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "kernel/plugin/pipe_format.h"

namespace axiscert::plugin {

class ReplyReader {
 public:
  // `header` as it was written to the program, with the batch's count; it outlives this. `wants_bits`: every reply has
  // to give comparison bits; otherwise they may, and are not read. `measure_bytes`: every reply is followed by so many
  // bytes of measures.
  ReplyReader(std::span<const std::byte> header, std::size_t queries, bool wants_bits, std::size_t measure_bytes = 0);

  // Takes the next bytes; returns how many of them it took: all, unless the last reply ends before, or there is a
  // fault.
  std::size_t take(std::span<const std::byte> bytes);
  // As before the first byte. `is_next`: the program has answered another batch before.
  void restart(bool is_next);

  bool has_nothing() const { return taken_ == 0; }
  bool has_header() const { return taken_ >= header_.size(); }
  bool is_complete() const { return !is_faulty_ && has_header() && count() == queries_; }
  bool is_faulty() const { return is_faulty_; }
  // Whether a fault would be told better with more bytes, up to the end of a line.
  bool wants_more() const;
  // One line: in what the bytes differ from replies. Empty without a fault.
  std::string fault() const;

  // The whole replies so far, at most the batch's queries.
  std::size_t count() const { return verdicts_.size(); }
  // By query. A verdict is any byte.
  const std::vector<std::uint8_t>& verdicts() const { return verdicts_; }
  const std::vector<std::uint64_t>& bits() const { return bits_; }
  // Query by query, as they came.
  const std::vector<std::byte>& measures() const { return measures_; }

 private:
  std::size_t reply_size() const { return sizeof(pipe::ReplyRecord) + measure_bytes_; }
  void take_reply();

  std::span<const std::byte> header_;
  std::size_t queries_;
  bool wants_bits_;
  std::size_t measure_bytes_;
  bool is_next_ = false, is_faulty_ = false;
  std::size_t taken_ = 0;          // bytes, up to the fault
  std::vector<std::byte> reply_;   // the part of the next one that has come
  std::string fault_;              // of a reply
  std::string instead_of_header_;  // from the first byte on
  std::vector<std::uint8_t> verdicts_;
  std::vector<std::uint64_t> bits_;
  std::vector<std::byte> measures_;
};

}  // namespace axiscert::plugin
