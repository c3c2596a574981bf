// What becomes of blocks of queries, and which integers the exact step takes, as recorded: as text, and as lists of
// Coq.
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <stdexcept>

#include "proofs/certified/blocks.h"
#include "proofs/certified/windows.h"
#include "proofs/emit.h"

namespace axiscert::proofs {
namespace {

using namespace certified;

bool has(const std::vector<std::uint64_t>& words, std::size_t i) { return ((words[i / 64] >> (i % 64)) & 1u) != 0; }

std::string coq_event(const BlockEvent& event) {
  switch (event.kind) {
    case BlockEvent::separated:
      return "said_apart";
    case BlockEvent::contact:
      return "said_contact";
    case BlockEvent::told:
      return fmt::format("said_bits {}", event.known);
    case BlockEvent::last:
      return fmt::format("said_last {} {}", event.known, event.is_separated);
  }
  throw std::logic_error("emit_blocks: no such event");
}
// Its queries in order: what each of them was, what the answer says of it, and what the steps said.
std::string coq_block(const RecordedBlock& block) {
  std::vector<std::string> said(static_cast<std::size_t>(block.size));
  for (const BlockEvent& event : block.events) {
    std::string& of = said.at(static_cast<std::size_t>(event.query));
    of += (of.empty() ? "" : "; ") + coq_event(event);
  }
  std::vector<bool> is_invalid(said.size());
  for (const int i : block.invalid_queries) is_invalid.at(static_cast<std::size_t>(i)) = true;
  std::string text;
  for (std::size_t i = 0; i < said.size(); ++i) {
    text += fmt::format("{}Taken {} {} {} [{}]", i == 0 ? "" : ";\n   ", is_invalid[i], has(block.contact, i),
                        has(block.invalid, i), said[i]);
  }
  // A pair has one query and writes one word.
  const std::size_t words = block.name.starts_with("pair") ? 1 : block.contact.size();
  for (std::size_t i = said.size(); i < 64 * words; ++i) {
    if (has(block.contact, i) || has(block.invalid, i)) throw std::logic_error("emit_blocks: an answer to no query");
  }
  return fmt::format("(* {} *)\n  [{}]", block.name, text);
}

// n and e of n 2^e.
std::string dyadic(double x) {
  if (x == 0) return "(0, 0)";
  int exponent = 0;
  double n = std::frexp(x, &exponent);
  while (n != std::floor(n)) {
    n *= 2;
    --exponent;
  }
  return fmt::format("({}, {})", static_cast<long long>(n), exponent);
}
// Two's complement.
std::string whole(std::vector<std::uint64_t> words) {
  const bool is_negative = (words.back() >> 63) != 0;
  std::uint64_t carry = 1;
  for (std::uint64_t& word : words) {
    if (!is_negative) break;
    word = ~word + carry;
    carry = carry != 0 && word == 0 ? 1 : 0;
  }
  std::string digits;
  for (const std::uint64_t word : words) digits = fmt::format("{:016x}", word) + digits;
  return is_negative ? fmt::format("(-0x{})", digits) : "0x" + digits;
}
std::string coq_window(const RecordedWindow& window) {
  std::string query, numbers;
  for (const double x : window.query) query += (query.empty() ? "" : "; ") + dyadic(x);
  for (const auto& x : window.numbers) numbers += (numbers.empty() ? "" : "; ") + whole(x);
  return fmt::format("ExactWindow {} {} {} ({}) {} [{}]\n   [{}]", window.widest, window.open, window.open_after,
                     window.size, window.known != 0, query, numbers);
}

template <class Rows, class Text>
std::string list_of(const Rows& rows, const Text& text) {
  std::string list;
  for (const auto& row : rows) list += (list.empty() ? "" : ";\n  ") + text(row);
  return list;
}

}  // namespace

Files block_files() {
  Files files;
  const std::vector<RecordedBlock> blocks = recorded_blocks();
  std::string text;
  for (const RecordedBlock& block : blocks) text += block.name + block.text + "\n";
  files[program_path("blocks")] = text + list_of(blocks, coq_block) + "\n";
  const std::string windows = list_of(recorded_windows(), coq_window);
  files[program_path("windows")] = windows + "\n";
  files["coq/certified/RecordedBlocks.v"] =
      R"((* Written by write_proofs from block-inl.h and what it includes, of kernel/sphere_triangle/certified, through the recorder: do
   not edit. Blocks of queries: for each query whether it was invalid, whether the answer has its bits of contact and of
   invalid, and what the steps said of it. *)
From Coq Require Import List ZArith.
From Axiscert Require Import Blocks.
Import ListNotations.
Open Scope Z_scope.

Definition recorded_blocks : list (list taken) :=
 [)" + list_of(blocks, coq_block) +
      "].\n";
  files["coq/numbers/RecordedWindows.v"] =
      R"((* Written by write_proofs from exact_step.cpp of kernel/sphere_triangle/certified, through the recorder: do not edit. For each query:
   the widest integers that it was allowed, whether its sphere was open and was taken as open, the size of the integers, whether
   balls were asked; its numbers, as n 2^e; and the integers. *)
From Coq Require Import List ZArith.
From Axiscert Require Import ExactWindow.
Import ListNotations.
Open Scope Z_scope.

Definition recorded_windows : list exact_window :=
 [)" + windows +
      "].\n";
  return files;
}

}  // namespace axiscert::proofs
