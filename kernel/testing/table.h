// The expected answers of every registered kernel to hand-worked queries, one row per kernel. docs/kernels.md shows the
// same rows.
#pragma once

#include <array>
#include <string_view>

namespace axiscert::testing_support {

enum class Says {
  right,      // the truth, every time
  wrong,      // not the truth in some case
  contact,    // in every case
  separated,  // in every case
  invalid,    // in every case
  undecided,  // in every case
  declines,   // the truth or undecided
  varies,     // with the query or the order of its vertices
};
inline constexpr std::array<std::string_view, 8> says_names = {"right",   "wrong",     "contact",  "separated",
                                                               "invalid", "undecided", "declines", "varies"};

// From `repeated` to `infinite_centre` the sphere is clear of the triangle, or was so before a coordinate was replaced.
struct Behaviour {
  std::string_view kernel;
  Says area;             // a triangle with area: clear of each feature, overlapping, touching
  Says repeated;         // two vertices equal, the sphere clear of the segment
  Says collinear;        // three vertices on a line, the foot of the centre between them
  Says point;            // all three equal
  Says nan;              // one coordinate of one vertex is NaN
  Says infinite;         // one coordinate of one vertex is infinite
  Says infinite_centre;  // one coordinate of the centre is infinite
  Says negative_radius;  // radius -1, for a sphere that overlaps an edge or the face at radius 1
};

inline constexpr auto behaviours = [] {
  using enum Says;
  // clang-format off
  return std::to_array<Behaviour>({
      {"published",           right, contact, contact, contact, contact, varies, contact, contact},
      {"nonstrict",           right, right, right, right, contact, varies, separated, contact},
      {"reduced",             right, contact, contact, contact, contact, varies, contact, contact},
      {"reduced-nonstrict",   right, right, right, right, contact, varies, separated, contact},
      {"reduced-along",       right, contact, contact, contact, contact, varies, contact, contact},
      {"reduced-determinant", right, contact, contact, contact, contact, varies, contact, contact},
      {"reduced-shared",      right, contact, contact, contact, contact, varies, contact, contact},
      {"reduced-shared-nonstrict", right, right, right, right, contact, varies, separated, contact},
      {"ladder-0",            right, contact, contact, contact, contact, varies, contact, separated},
      {"ladder-1",            right, contact, contact, contact, contact, varies, contact, varies},
      {"ladder-2",            right, contact, contact, contact, contact, varies, contact, varies},
      {"ladder-3",            right, contact, contact, contact, contact, varies, contact, varies},
      {"ladder-4",            right, contact, contact, contact, contact, varies, contact, varies},
      {"ladder-5",            right, contact, contact, contact, contact, varies, contact, contact},
      {"ladder-6",            right, contact, contact, contact, contact, varies, contact, contact},
      {"ladder-7",            right, contact, contact, contact, contact, varies, contact, contact},
      {"ladder-8",            right, contact, contact, contact, contact, varies, contact, contact},
      {"ladder-9",            right, contact, contact, contact, contact, varies, contact, contact},
      {"minkowski",           right, right, right, right, contact, varies, separated, contact},
      {"closest-point",       right, varies, right, right, varies, varies, separated, contact},
      {"segments",            right, varies, contact, contact, varies, varies, contact, contact},
      {"packed",              right, contact, contact, contact, contact, varies, contact, contact},
      {"packed-nonstrict",    right, right, right, right, separated, varies, separated, contact},
      {"eigen",               right, contact, contact, contact, contact, varies, contact, contact},
      {"certified",           right, right, right, right, invalid, invalid, invalid, invalid},
      {"conservative",        right, right, right, right, invalid, invalid, invalid, invalid},
      {"certified-filter",    declines, undecided, undecided, undecided, undecided, undecided, undecided, undecided},
      {"certified-filter-published", declines, undecided, undecided, undecided, undecided, undecided, undecided, undecided},
      {"first-publication",   wrong, varies, right, contact, contact, varies, contact, contact},
      {"vertex-typo",         wrong, varies, varies, contact, varies, varies, contact, contact},
  });
  // clang-format on
}();

}  // namespace axiscert::testing_support
