// Blocks of queries as kernel/sphere_triangle/certified takes them through the steps (block-inl.h, leftovers-inl.h,
// open_comparisons-inl.h, conservative_block-inl.h), with steps that answer by a script, over vectors of several
// lengths.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <type_traits>

#include "proofs/certified/blocks.h"
#include "kernel/sphere_triangle/certified/exact_step.h"
#include "kernel/sphere_triangle/certified/steps.h"
#include "kernel/sphere_triangle/names.h"

// Highway's macros, for an instruction set that is none of its own.
#define AXISCERT_PER_TARGET
#define HWY_BEFORE_NAMESPACE() static_assert(true)
#define HWY_AFTER_NAMESPACE() static_assert(true)
#define HWY_ATTR
#define HWY_NOINLINE
#define HWY_NAMESPACE recorded_blocks
#include "proofs/certified/plain_lanes-inl.h"
#include "kernel/base/geometry.h"
#include "proofs/certified/asked_steps-inl.h"
#define exactly_separated asked_last_step
#include "kernel/sphere_triangle/certified/leftovers-inl.h"
#include "kernel/sphere_triangle/certified/open_comparisons-inl.h"
#include "kernel/sphere_triangle/certified/conservative_block-inl.h"
#include "kernel/sphere_triangle/certified/block-inl.h"
#undef exactly_separated

namespace axiscert::proofs::certified {
namespace {

using axiscert::certified::Block, axiscert::certified::BlockAnswer, axiscert::certified::Question;
namespace steps = axiscert::certified::recorded_blocks;
namespace hn = hwy::recorded_blocks;

constexpr double up = 0x1p20, down = 0x1p-4;

}  // namespace

std::string_view Script::name_of(Step step) {
  constexpr std::string_view names[] = {"box",  "coarse",       "coarse in double",
                                        "fine", "conservative", "conservative scaled"};
  return names[step];
}

std::uint64_t Script::chance(int query, std::uint64_t salt) const {
  std::uint64_t x = (seed_ * 1000 + static_cast<std::uint64_t>(query)) * 1000 + salt;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9ull + 0x9e3779b97f4a7c15ull;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebull;
  return (x ^ (x >> 31)) >> 8;
}

double Script::number(int i, int k) const {
  if (one_sphere_ && k >= 9) i = 0;
  const double x = 16 * i + k + 1;
  return k == 12 && is_invalid(i) ? -x : x;
}

LaneQuery Script::query_of(const double (&numbers)[13]) const {
  if (std::all_of(numbers, numbers + 9, [](double x) { return x == 0; })) return LaneQuery::padding();
  for (int scale = -1; scale <= 1; ++scale) {
    const double by = scale == 0 ? 1 : scale > 0 ? up : down;
    const double first = numbers[0] / by;
    if (first != std::floor(first) || first < 1 || first > 16 * 256) continue;
    const LaneQuery q{(static_cast<int>(first) - 1) / 16, (static_cast<int>(first) - 1) % 16 / 3, scale};
    if (q.query >= made_.size || q.turn > 2) continue;
    bool is_this = true;
    for (int k = 0; k < 13; ++k) is_this &= numbers[k] == by * number(q.query, k < 9 ? (k + 3 * q.turn) % 9 : k);
    if (is_this) return q;
  }
  throw std::logic_error("record_blocks: a lane has the numbers of no query");
}
void Script::check_sphere(double px, double py, double pz, double r) const {
  const double numbers[] = {px, py, pz, r};
  for (int k = 0; k < 4; ++k) {
    if (numbers[k] != number(0, 9 + k)) throw std::logic_error("record_blocks: a box of another sphere");
  }
}
void Script::check_sphere_kind(bool open) const {
  if (open != is_open_) throw std::logic_error("record_blocks: a step is asked about the other kind of sphere");
}

bool Script::decides(Step step, const LaneQuery& q) const {
  if (is_invalid(q.query)) return false;
  const auto level = chance(q.query, 2) % 16;
  const bool is_easy = seed_ / 2 % 2 == 0;
  switch (step) {
    case box:
      return is_separated(q) && q.query < static_cast<int>(chance(-1, 3) % 40);
    case coarse:
      return level < (is_easy ? 12 : 2);
    case coarse_in_double:
      return level < (is_easy ? 13 : 5);
    case fine:
      return level < (is_easy ? 14 : 7);
    case conservative:
      return level < 10;
    case conservative_scaled:
      return q.scale != 0 || level < 13;
  }
  return false;
}
std::uint64_t Script::axes_with(const LaneQuery& q, int what) const {
  const std::uint64_t radius = chance(q.query, 4) & 0x7f;
  if (what == 0) return radius;
  const std::uint64_t sides = chance(q.query, 5) | 1u << 3;  // the plane has none
  const bool is_contact = (radius & 1u << 3) == 0 && chance(q.query, 6) % 2 == 0;
  return (is_contact ? sides & ~radius : sides) & 0x7f;
}
std::uint64_t Script::known(Step step, const LaneQuery& q) const {
  const std::uint64_t radius = axes_with(q, 0), sides = axes_with(q, 1);
  const std::uint64_t all = (~(radius & sides) & 0x7f) | radius << 8 | sides << 16;
  const std::uint64_t tells = chance(q.query, 20 + static_cast<std::uint64_t>(step)) | 1u << 19;
  const bool tells_most = chance(q.query, 7) % 3 == 0;
  return all & (tells_most ? tells | chance(q.query, 8) | chance(q.query, 9) : tells);
}
Script::Deep Script::deep(int group, int axis, const LaneQuery& q) const {
  const bool is_certain =
      chance(q.query, 40 + static_cast<std::uint64_t>(group + axis)) % 8 != 0 || chance(q.query, 10) % 2 == 0;
  const bool holds = ((axes_with(q, group == 16) >> axis) & 1u) != 0;
  return {is_certain && holds, is_certain && !holds};
}

void Script::write(const LaneQuery& q) {
  made_.text += q.is_padding() ? " -" : " " + std::to_string(q.query);
  if (q.turn != 0) made_.text += "/" + std::to_string(q.turn);
  if (q.scale != 0) made_.text += q.scale > 0 ? "*" : ".";
}
bool Script::last_step(const double (&numbers)[13], bool open, std::uint64_t known, int widest) {
  check_sphere_kind(open);
  const LaneQuery q = query_of(numbers);
  made_.text += "\n  last:";
  write(q);
  made_.text += " knows " + std::to_string(known) + ", at most " + std::to_string(widest) + " bits" +
                (is_separated(q) ? " separated" : " contact");
  made_.events.push_back({BlockEvent::last, q.query, known, is_separated(q)});
  return is_separated(q);
}

namespace {

// The columns of a script's block; beyond its end there is nothing that a query has.
template <class Real>
struct Columns {
  std::vector<Real> column[13];
  Block<Real> block;
  Columns(const Script& of, int size, bool one_sphere) : block{{}, static_cast<std::size_t>(size), one_sphere} {
    for (int k = 0; k < 13; ++k) {
      column[k].assign(static_cast<std::size_t>(size) + 64, static_cast<Real>(-7));
      for (int i = 0; i < (one_sphere && k >= 9 ? 1 : size); ++i) {
        column[k][static_cast<std::size_t>(i)] = static_cast<Real>(of.number(i, k));
      }
      block.column[k] = column[k].data();
    }
  }
};

template <class D, class D2, class D4>
void record(const std::string& name, Question question, bool one_sphere, bool as_pair, int size,
            std::vector<RecordedBlock>& all) {
  using Real = hn::TFromD<D>;
  Script made(all.size() + 1, size, one_sphere, question == Question::open_sphere, sizeof(Real) == 8);
  script = &made;
  const Columns<Real> columns(made, size, one_sphere);
  BlockAnswer answer{};
  if (as_pair) {
    Real triangle[9], sphere[4];
    for (int k = 0; k < 13; ++k) (k < 9 ? triangle[k] : sphere[k - 9]) = columns.column[k][0];
    answer.contact[0] = answer.invalid[0] = ~std::uint64_t{0};  // the first word is written
    steps::decide_pair<D4, D, D2>(triangle, sphere, question, answer);
  } else {
    steps::decide<D, D2>(columns.block, question, answer);
  }
  script = nullptr;
  RecordedBlock& block = made.made();
  constexpr const char* questions[] = {"closed", "open", "conservative"};
  block.name =
      name + "_" + questions[static_cast<int>(question)] + (one_sphere ? "_one_sphere_" : "_") + std::to_string(size);
  block.contact.assign(std::begin(answer.contact), std::end(answer.contact));
  block.invalid.assign(std::begin(answer.invalid), std::end(answer.invalid));
  all.push_back(block);
}

}  // namespace

std::vector<RecordedBlock> recorded_blocks() {
  // As SSE4, AVX2 and AVX-512 have them, and one at a time.
  using Floats = hn::Tag<float, 4>;
  using EightFloats = hn::Tag<float, 8>;
  using SixteenFloats = hn::Tag<float, 16>;
  using Doubles = hn::Tag<double, 2>;
  using FourDoubles = hn::Tag<double, 4>;
  using EightDoubles = hn::Tag<double, 8>;
  using OneFloat = hn::Tag<float, 1>;
  using OneDouble = hn::Tag<double, 1>;
  std::vector<RecordedBlock> all;
  for (const Question question : {Question::closed_sphere, Question::open_sphere, Question::conservative}) {
    for (const bool one_sphere : {false, true}) {
      for (const int size : {1, 3, 6, 64, 67, 131, 200, 256}) {
        record<Floats, Doubles, void>("floats", question, one_sphere, false, size, all);
        record<Doubles, Doubles, void>("doubles", question, one_sphere, false, size, all);
      }
      for (const int size : {5, 21, 77, 150}) {
        record<EightFloats, FourDoubles, void>("eight_floats", question, one_sphere, false, size, all);
        record<SixteenFloats, EightDoubles, void>("sixteen_floats", question, one_sphere, false, size, all);
        record<FourDoubles, FourDoubles, void>("four_doubles", question, one_sphere, false, size, all);
        record<EightDoubles, EightDoubles, void>("eight_doubles", question, one_sphere, false, size, all);
      }
      record<OneFloat, OneDouble, void>("one_float", question, one_sphere, false, 3, all);
      record<OneDouble, OneDouble, void>("one_double", question, one_sphere, false, 3, all);
    }
    for (int i = 0; i < 12; ++i) {
      record<OneFloat, OneDouble, Floats>("pair_float", question, false, true, 1, all);
      record<OneDouble, OneDouble, FourDoubles>("pair_double", question, false, true, 1, all);
    }
  }
  return all;
}

}  // namespace axiscert::proofs::certified
