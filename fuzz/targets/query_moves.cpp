#include "fuzz/targets/query_moves.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

#include "exact/sphere_triangle/measures/nearest_root.h"
#include "fuzz/search/moves.h"

namespace axiscert::fuzzing {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they lie in memory");
constexpr std::size_t head = 2;

template <class Real>
Query<Real> query_of(std::span<const std::uint8_t> bytes) {
  std::array<Real, coordinate_count> numbers{};
  std::memcpy(numbers.data(), bytes.data(), std::min(bytes.size(), sizeof numbers));
  return from_coordinates(numbers);
}

}  // namespace

FuzzedQuery fuzzed_query(std::span<const std::uint8_t> bytes) {
  FuzzedQuery fuzzed;
  if (bytes.size() < head) return fuzzed;
  fuzzed.kernel = bytes[1];
  const auto numbers = bytes.subspan(head);
  if ((bytes[0] & 1u) == 0) fuzzed.query = query_of<float>(numbers);
  else fuzzed.query = query_of<double>(numbers);
  return fuzzed;
}

std::vector<std::uint8_t> bytes_of(const FuzzedQuery& fuzzed) {
  return std::visit(
      [&](const auto& query) {
        const auto numbers = coordinates(query);
        std::vector<std::uint8_t> bytes(head + sizeof numbers);
        bytes[0] = sizeof numbers[0] == sizeof(double);
        bytes[1] = fuzzed.kernel;
        std::memcpy(bytes.data() + head, numbers.data(), sizeof numbers);
        return bytes;
      },
      fuzzed.query);
}

namespace {

template <class Real>
using Coordinates = std::array<Real, coordinate_count>;
constexpr std::size_t radius_place = coordinate_count - 1, points = 4;
constexpr std::size_t place_of(std::size_t point, std::size_t axis) { return 3 * point + axis; }

Dice dice_of(std::uint32_t seed) {
  constexpr std::uint64_t generator = name_hash("fuzz-target");
  Stream stream(seed, generator, 1, Precision::binary32, 0);
  return Dice(stream);
}

// A neighbour of a finite number, which may be infinite or beyond zero; any other number is unchanged.
template <class Real>
Real neighbour(Dice& dice, Real x) {
  if (!std::isfinite(x)) return x;
  const auto size = std::int64_t{1} << dice.below(std::numeric_limits<Real>::digits);
  return moved_by_ulps(x, dice.integer(-size, size));
}

template <class Real>
Real special(Dice& dice) {
  using Limits = std::numeric_limits<Real>;
  const Real greatest_subnormal = Limits::min() - Limits::denorm_min();
  // Infinity and NaN are rare: the truth of such queries is `invalid`, which exercises little code.
  const std::array<Real, 9> usual = {
      Real(0),
      Limits::denorm_min(),
      greatest_subnormal,
      Limits::min(),
      Real(1),
      Limits::max(),
      Limits::epsilon(),
      Real(1) - Limits::epsilon() / 2,
      std::ldexp(Real(1), static_cast<int>(dice.integer(Limits::min_exponent, Limits::max_exponent - 1)))};
  if (dice.below(64) == 0) return dice.coin() ? Limits::infinity() : Limits::quiet_NaN();
  const Real x = usual[dice.below(usual.size())];
  return dice.coin() ? x : -x;
}

template <class Real>
void move_exponent(Dice& dice, Coordinates<Real>& v) {
  const int far = std::numeric_limits<Real>::max_exponent;
  const auto by = static_cast<int>(dice.below(8) == 0 ? dice.integer(-far, far) : dice.integer(-4, 4));
  std::size_t first = 0, count = coordinate_count;
  switch (dice.below(3)) {
    case 0:
      break;
    case 1:
      first = 3 * dice.below(points);
      count = 3;
      break;
    default:
      first = dice.below(coordinate_count);
      count = 1;
  }
  for (std::size_t k = first; k < first + count; ++k) v[k] = std::ldexp(v[k], by);
}

template <class Real>
void change_sign(Dice& dice, Coordinates<Real>& v) {
  switch (dice.below(3)) {
    case 0: {
      Real& x = v[dice.below(coordinate_count)];
      x = -x;
      break;
    }
    case 1: {
      const std::size_t axis = dice.below(3);
      for (std::size_t point = 0; point < points; ++point) v[place_of(point, axis)] = -v[place_of(point, axis)];
      break;
    }
    default:
      for (std::size_t k = 0; k < radius_place; ++k) v[k] = -v[k];
  }
}

template <class Real>
void repeat(Dice& dice, Coordinates<Real>& v) {
  const std::size_t to = dice.below(3), from = (to + 1 + dice.below(3)) % points;
  const bool on_line = dice.coin();
  const std::size_t other = (to + 1 + dice.below(2)) % 3;
  const auto along = static_cast<Real>(dice.integer(-2, 4)) / 2;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Real at = v[place_of(from, axis)], step = v[place_of(other, axis)] - at;
    v[place_of(to, axis)] = on_line ? at + step * along : at;
  }
}

template <class Real>
void swap(Dice& dice, Coordinates<Real>& v) {
  const std::size_t i = dice.below(3), j = (i + 1 + dice.below(2)) % 3;
  if (dice.coin()) {
    for (std::size_t axis = 0; axis < 3; ++axis) std::swap(v[place_of(i, axis)], v[place_of(j, axis)]);
  } else {
    for (std::size_t point = 0; point < points; ++point) std::swap(v[place_of(point, i)], v[place_of(point, j)]);
  }
}

template <class Real>
void move_to_tie(Dice& dice, Coordinates<Real>& v) {
  Query<Real> q = from_coordinates(v);
  q.r = 0;  // the radius is not used, but it has to be valid
  if (!is_valid(q)) return;
  const auto which = static_cast<Comparison>(dice.below(comparison_count));
  std::size_t place = radius_place;
  std::optional<Real> found;
  if (dice.below(4) == 0) {
    found = nearest_distance(q);
  } else if (info(which).is_radius) {
    found = nearest_tie_radius(q, which);
  } else {
    const std::size_t axis = dice.below(3);
    place = place_of(3, axis);
    found = nearest_tie_coordinate(q, which, static_cast<int>(axis));
  }
  if (found && std::isfinite(*found)) v[place] = moved_by_ulps(*found, dice.integer(-2, 2));
}

template <class Real>
void apply_to_numbers(QueryMove move, Dice& dice, Coordinates<Real>& v) {
  switch (move) {
    case QueryMove::ulps: {
      Real& x = v[dice.below(coordinate_count)];
      x = neighbour(dice, x);
      break;
    }
    case QueryMove::exponent:
      move_exponent(dice, v);
      break;
    case QueryMove::sign:
      change_sign(dice, v);
      break;
    case QueryMove::special:
      v[dice.below(coordinate_count)] = special<Real>(dice);
      break;
    case QueryMove::copy: {
      const std::size_t to = dice.below(coordinate_count), from = dice.below(coordinate_count);
      v[to] = dice.below(4) == 0 ? -v[from] : v[from];
      break;
    }
    case QueryMove::repeat:
      repeat(dice, v);
      break;
    case QueryMove::swap:
      swap(dice, v);
      break;
    case QueryMove::tie:
      move_to_tie(dice, v);
      break;
    case QueryMove::precision:
    case QueryMove::kernel:
      break;
  }
}

}  // namespace

void change_precision(FuzzedQuery& fuzzed) {
  if (const auto* narrow = std::get_if<Query<float>>(&fuzzed.query)) {
    fuzzed.query = widened(*narrow);
    return;
  }
  const auto wide = coordinates(std::get<Query<double>>(fuzzed.query));
  Coordinates<float> narrow;
  for (std::size_t k = 0; k < coordinate_count; ++k) narrow[k] = static_cast<float>(wide[k]);
  fuzzed.query = from_coordinates(narrow);
}

void apply(QueryMove move, Dice& dice, FuzzedQuery& fuzzed) {
  if (move == QueryMove::precision) {
    change_precision(fuzzed);
  } else if (move == QueryMove::kernel) {
    fuzzed.kernel = static_cast<std::uint8_t>(dice.below(256));
  } else {
    std::visit(
        [&](auto& query) {
          auto numbers = coordinates(query);
          apply_to_numbers(move, dice, numbers);
          query = from_coordinates(numbers);
        },
        fuzzed.query);
  }
}

void mutate(FuzzedQuery& fuzzed, std::uint32_t seed) {
  Dice dice = dice_of(seed);
  const auto moves = 1 + dice.below(4);
  for (std::uint64_t i = 0; i < moves; ++i) apply(static_cast<QueryMove>(dice.below(query_move_count)), dice, fuzzed);
}

void cross(FuzzedQuery& fuzzed, const FuzzedQuery& other, std::uint32_t seed) {
  Dice dice = dice_of(seed);
  FuzzedQuery mate = other;
  if (mate.query.index() != fuzzed.query.index()) change_precision(mate);
  std::visit(
      [&](auto& query) {
        auto numbers = coordinates(query);
        const auto others = coordinates(std::get<std::remove_reference_t<decltype(query)>>(mate.query));
        for (std::size_t point = 0; point < points; ++point) {
          if (dice.coin()) continue;
          for (std::size_t axis = 0; axis < 3; ++axis) numbers[place_of(point, axis)] = others[place_of(point, axis)];
        }
        if (dice.coin()) numbers[radius_place] = others[radius_place];
        query = from_coordinates(numbers);
      },
      fuzzed.query);
}

}  // namespace axiscert::fuzzing
