// The two byte streams of the pipe: queries to a user's program, and its replies. docs/pipe.md is for authors of such
// programs; this header states the same in C++.
//
//   query stream   header, then `count` query records
//   reply stream   the same header unchanged, then `count` reply records
//
// All numbers are little-endian. The plan in the header names the predicate and its entry. A query record is the
// numbers of one query in the order of the entry's columns: for sphere-triangle the thirteen ax ay az bx by bz cx cy cz
// px py pz r.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>

#include "kernel/names.h"
#include "kernel/predicate.h"

namespace axiscert::pipe {
static_assert(std::endian::native == std::endian::little, "records are copied as they lie in memory");

// The first 64 bytes of a header. The plan follows: JSON in UTF-8, padded with spaces to `header_size`.
struct Head {
  std::array<char, 8> magic;
  std::uint32_t version;
  std::uint32_t precision;                // 32: a record's numbers are floats; 64: doubles
  std::uint64_t count;                    // number of queries
  std::uint32_t header_size;              // size of head and plan, in bytes: a multiple of 64
  std::uint32_t record_size;              // size of a query record, in bytes; for sphere-triangle 52 or 104
  std::array<std::byte, 32> plan_sha256;  // hash of the plan including its spaces
};
static_assert(sizeof(Head) == 64 && offsetof(Head, count) == 16 && offsetof(Head, plan_sha256) == 32);

inline constexpr std::array<char, 8> magic = {'A', 'X', 'I', 'S', 'C', 'E', 'R', 'T'};
inline constexpr std::uint32_t version = 3;
inline constexpr std::uint32_t header_multiple = 64;
inline constexpr std::uint32_t greatest_header = 1 << 20;  // a greater size is taken for a corrupted one

struct ReplyRecord {
  std::uint8_t verdict;  // contact 0, separated 1, undecided 2, invalid 3
  std::uint8_t flags;
  std::array<std::uint8_t, 6> padding;  // 0
  std::uint64_t bits;                   // bit i is comparison i; 0 if the flag is not set
};
static_assert(sizeof(ReplyRecord) == 16 && offsetof(ReplyRecord, bits) == 8);

inline constexpr std::uint8_t has_bits = 1;  // `bits` is given
// The reply is followed by measures, in the stream's precision. How many, the plan says (`measures`,
// plugin::program_header).
inline constexpr std::uint8_t has_measures = 2;

constexpr std::uint32_t code_of(Precision precision) { return precision == Precision::binary32 ? 32 : 64; }
constexpr std::uint32_t record_size_of(Precision precision, std::size_t columns) {
  return static_cast<std::uint32_t>(columns) * code_of(precision) / 8;
}

}  // namespace axiscert::pipe

namespace axiscert {
// The header of the pipe's streams, for the pipe and for the batches of a program.

namespace pipe {

// The header's bytes: the head and the plan, which is filled with spaces up to a multiple of header_multiple.
std::string stream_header(std::string plan, std::size_t columns, Precision precision, std::uint64_t count);

}  // namespace pipe

namespace plugin {

// The header that a program reads before the queries of each batch, with a count of 0. The plan names the predicate,
// its entry and the precision, and how many measures follow each reply where there are any; nothing can be made again
// from it.
std::string program_header(const Predicate& predicate, std::size_t entry, Precision precision,
                           std::size_t measures = 0);

}  // namespace plugin

}  // namespace axiscert
