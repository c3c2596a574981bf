// Which integers the exact step takes for a query, with which numbers, and when it asks balls before
// (kernel/sphere_triangle/certified/exact_step.cpp, widths.h): the code as it is, but that the test of
// integers, of digits or of balls notes its numbers.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>

#include "proofs/certified/windows.h"
#include "kernel/sphere_triangle/certified/exact_step.h"
#include "kernel/sphere_triangle/certified/exact_test.h"
#include "kernel/sphere_triangle/certified/ball.h"
#include "kernel/sphere_triangle/certified/widths.h"

namespace axiscert::certified {
namespace {

thread_local proofs::certified::RecordedWindow* window = nullptr;

template <class Numbers>
struct NotedTest {
  NotedTest(const typename Numbers::template Value<1> (&q)[13], bool open, KnownResults known) {
    window->size = 0;
    window->open_after = open;
    window->known = known.bits;
    note(q);
  }
  template <std::size_t words>
  static void note(const Integer<words> (&q)[13]) {
    for (const Integer<words>& x : q) window->numbers.push_back({std::begin(x.word), std::end(x.word)});
  }
  static void note(const BalancedDigits<1> (&)[13]) {}
};
template <int n>
bool noted(const NotedTest<Integers<n>>&) {
  window->size = n;
  return false;
}
bool noted(const NotedTest<Digits>&) { return false; }

}  // namespace
bool exactly_noted(const double (&query)[13], Question question, KnownResults known, int widest) noexcept;
bool integers_noted(const double (&query)[13], Question question) noexcept;
}  // namespace axiscert::certified

#define ExactTest NotedTest
#define some_axis_separates noted
#define exactly_separated exactly_noted
#define separated_by_integers integers_noted
#include "kernel/sphere_triangle/certified/exact_step.cpp"
#undef ExactTest
#undef some_axis_separates
#undef exactly_separated
#undef separated_by_integers

namespace axiscert::proofs::certified {

std::vector<RecordedWindow> recorded_windows() {
  using namespace axiscert::certified;
  std::vector<RecordedWindow> all;
  for (const int bits : {6,   29,  30,  31,  32,  61,  62,  63,  64,  93,  94,  95,  96, 110,
                         125, 126, 127, 128, 200, 277, 278, 279, 285, 286, 287, 288, 300}) {
    const double radii[] = {0, 7, std::ldexp(1, -2 * bits - 2), std::ldexp(1, -2 * bits - 3)};
    for (const double r : radii) {
      for (const bool open : {false, true}) {
        for (const int widest : {widest_integers<double>, widest_integers<float>, 0}) {
          RecordedWindow made{bits, widest, open, {}, -1, open, 0, {}};
          // A span of `bits`. With r = 7 the sphere touches vertex A, which no ball tells.
          const double m = std::ldexp(1, bits - 2), coordinates[] = {m, 2, 3, 5, 8, -6, -7, 11, 9, m, -5, 3};
          std::copy(std::begin(coordinates), std::end(coordinates), made.query);
          made.query[12] = r;
          window = &made;
          const Question question = open ? Question::open_sphere : Question::closed_sphere;
          if (widest == 0) integers_noted(made.query, question);
          else exactly_noted(made.query, question, {}, widest);
          window = nullptr;
          all.push_back(made);
        }
      }
    }
  }
  return all;
}

}  // namespace axiscert::proofs::certified
