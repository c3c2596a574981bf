// Common parts of the steps of the certified predicate: the question, a block of queries and the answers to it, and the
// forms of the steps for each instruction set.
#pragma once

#include <array>
#include <cfloat>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "kernel/base/enums.h"
#include "kernel/sphere_triangle/names.h"

// Refuses the compiler's flags under which the steps are not what was proved of them, where the compiler tells. Neither
// g++ nor clang tells whether it contracts a b + c (-ffp-contract=off), nor clang the parts of -ffast-math but
// -ffinite-math-only; self_check.h looks at these.

// g++ has 0 for __GCC_IEC_559 under each part of -ffast-math that changes a value: -fassociative-math,
// -freciprocal-math, -ffinite-math-only, -fno-signed-zeros.
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ != 0) || \
    (defined(__GCC_IEC_559) && __GCC_IEC_559 == 0)
#error "libaxiscert is right in IEEE 754 arithmetic: compile it without -ffast-math, -Ofast and the parts of these"
#endif
// x87 has more bits and a wider range than double: what loses a bit where it is stored seems not to.
#if FLT_EVAL_METHOD != 0
#error "libaxiscert is right where each operation is rounded to its type: compile it for SSE2 (-mfpmath=sse)"
#endif

namespace axiscert::certified {
// The contact asked for: distance <= r; distance < r; or distance not shown to be greater than r (kernel
// `conservative`).
enum class Question : std::uint8_t { closed_sphere, open_sphere, conservative };

inline constexpr std::size_t block_size = 256;

// Up to block_size queries by columns, ax ay az bx by bz cx cy cz px py pz r. If all queries have the same sphere, the
// last four columns have one entry.
template <class Real>
struct Block {
  const Real* column[13];
  std::size_t size;
  bool one_sphere;
};

// Bit i of word i / 64 belongs to query i. No query has both bits set; bits from the size on are zero.
template <std::size_t most>
struct Answer {
  std::uint64_t contact[most / 64];
  std::uint64_t invalid[most / 64];
};
using BlockAnswer = Answer<block_size>;

// Up to mesh_chunk_size triangles of an indexed mesh (kernel/include/axiscert/certified.h), against one sphere, px py
// pz r: the triangles that `list` names or, if it is null, the first `size` triangles of `indices`.
inline constexpr std::size_t mesh_chunk_size = 1024;
template <class Real>
struct MeshChunk {
  const Real* sphere;
  const Real* vertices;
  std::size_t stride;
  const std::uint32_t* indices;
  const std::uint32_t* list;
  std::size_t size;
};
using MeshAnswer = Answer<mesh_chunk_size>;

// State kept from chunk to chunk: for the vertices first to end - 1, the faces of the sphere's box that they are
// beyond; and whether the box separated most triangles of the last chunk.
struct Outcodes {
  std::uint32_t first = 0, end = 0;
  bool are_useful = false;
  std::uint8_t code[8192];
};

// The positions of the set bits of a byte, the lowest first; 0 in the other places.
struct SetBits {
  std::uint8_t place[8];
};
inline constexpr auto set_bits_first = [] {
  std::array<SetBits, 256> all{};
  for (unsigned bits = 0; bits < 256; ++bits) {
    unsigned next = 0;
    for (std::uint8_t i = 0; i < 8; ++i) {
      if (has_bit(bits, i)) all[bits].place[next++] = i;
    }
  }
  return all;
}();

// The steps on one instruction set. The caller has to set the modes of
// kernel/sphere_triangle/certified/default_modes.h.
struct Forms {
  void (*block32)(const Block<float>&, Question, BlockAnswer&) noexcept;
  void (*block64)(const Block<double>&, Question, BlockAnswer&) noexcept;
  // One query at a time, by the same steps.
  void (*one32)(const Block<float>&, Question, BlockAnswer&) noexcept;
  void (*one64)(const Block<double>&, Question, BlockAnswer&) noexcept;
  void (*mesh32)(const MeshChunk<float>&, Question, Outcodes&, MeshAnswer&) noexcept;
  void (*mesh64)(const MeshChunk<double>&, Question, Outcodes&, MeshAnswer&) noexcept;
  // triangle: ax ay az bx by bz cx cy cz. sphere: px py pz r. Only the first word of the answer is written.
  void (*pair32)(const float* triangle, const float* sphere, Question, BlockAnswer&) noexcept;
  void (*pair64)(const double* triangle, const double* sphere, Question, BlockAnswer&) noexcept;

  template <class Real>
  auto block() const noexcept {
    if constexpr (sizeof(Real) == 4) return block32;
    else return block64;
  }
  template <class Real>
  auto one() const noexcept {
    if constexpr (sizeof(Real) == 4) return one32;
    else return one64;
  }
  template <class Real>
  auto mesh() const noexcept {
    if constexpr (sizeof(Real) == 4) return mesh32;
    else return mesh64;
  }
  template <class Real>
  auto pair() const noexcept {
    if constexpr (sizeof(Real) == 4) return pair32;
    else return pair64;
  }
};

// The forms for the instruction set that Highway has chosen: the best one, unless another has been set.
Forms chosen_forms();

// Eight bits as eight bytes of 0 or 1.
inline std::uint64_t spread_over_bytes(std::uint64_t bits) noexcept {
  const std::uint64_t each = ((bits & 0xff) * 0x0101010101010101ull) & 0x8040201008040201ull;
  return ((each + 0x7f7f7f7f7f7f7f7full) >> 7) & 0x0101010101010101ull;
}

// The answers to a block as a verdict for each query.
template <std::size_t most>
void write_verdicts(const Answer<most>& answer, std::size_t size, std::uint8_t* out) noexcept {
  static_assert(static_cast<int>(Verdict::contact) == 0 && static_cast<int>(Verdict::separated) == 1 &&
                static_cast<int>(Verdict::invalid) == 3);
  for (std::size_t i = 0; i < size; i += 8) {
    const std::uint64_t separated = spread_over_bytes(~answer.contact[i / 64] >> (i % 64));
    const std::uint64_t invalid = spread_over_bytes(answer.invalid[i / 64] >> (i % 64));
    const std::uint64_t verdicts = separated | (invalid << 1);  // an invalid query is not a contact: 1 and 2
    std::memcpy(out + i, &verdicts, size - i < 8 ? size - i : 8);
  }
}

// The shortest way to an answer: every query straight to the exact step.

// Forms without vectors, for the closed and the open sphere; `conservative` counts as the closed one. The caller has to
// set the modes of kernel/sphere_triangle/certified/default_modes.h.
const Forms& exact_only_forms() noexcept;

// What the library asks itself at its first call.

// Whether the forms give the stored answers to the stored queries, as pairs and as a block. Integers alone answer
// Question::conservative as the closed sphere. The caller has to set the modes of default_modes.h.
bool answer_as_stored(const Forms& forms, bool are_integers) noexcept;

}  // namespace axiscert::certified
