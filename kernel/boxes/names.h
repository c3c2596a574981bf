// The fifteen axes of two boxes, in their order. An axis is one comparison, so it is also the name of a clause.
#pragma once

#include <array>
#include <string_view>

namespace axiscert::boxes {

// a0: the normal of A's facet that a1 and a2 span, and so on; a0b2: at right angles to the edges a0 and b2.
inline constexpr std::array<std::string_view, 15> axis_names = {
    "a0", "a1", "a2", "b0", "b1", "b2", "a0b0", "a0b1", "a0b2", "a1b0", "a1b1", "a1b2", "a2b0", "a2b1", "a2b2"};
inline constexpr std::size_t axis_count = axis_names.size();

constexpr std::size_t facet_of_a(std::size_t k) { return k; }
constexpr std::size_t facet_of_b(std::size_t k) { return 3 + k; }
constexpr std::size_t edges(std::size_t i, std::size_t j) { return 6 + 3 * i + j; }

// The other two of 0, 1, 2, in cyclic order.
constexpr std::size_t next(std::size_t k) { return (k + 1) % 3; }
constexpr std::size_t last(std::size_t k) { return (k + 2) % 3; }

// Where the measures of each kind begin, of two boxes and of a box and a triangle: a separation, a normal of three, and
// a point of three of each body.
inline constexpr std::size_t separation_measure = 0, normal_measure = 1, point_a_measure = 4, point_b_measure = 7,
                             contact_measures = 10;

}  // namespace axiscert::boxes
