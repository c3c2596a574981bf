/* Kernels for the tests of what a gate may say: each keeps or breaks a promise in a way of its own. CMakeLists.txt
 * makes a plug-in promises/NAME.so of each, with KIND defined as its name. Right answers are those of the published
 * predicate in binary64, so that a right kernel in binary32 is wrong on next to no query that is not a tie. */
#include <string.h>

#include "kernel/include/axiscert/plugin.h"

#define real double
#define OF_REAL(name) name##_binary64
#include "kernel/sphere_triangle/faults/published_test.h"

static int right(const double v[13]) {
  uint64_t comparisons;
  return published_binary64(v, v + 3, v + 6, v + 9, v[12], &comparisons);
}

/* One query in 16, by its bits alone. */
static int is_among_few(const double v[13]) {
  uint64_t mixed = 0;
  for (int k = 0; k < 13; ++k) {
    uint64_t bits;
    memcpy(&bits, v + k, sizeof bits);
    mixed = (mixed ^ bits) * 0x9e3779b97f4a7c15u;
    mixed ^= mixed >> 32;
  }
  return mixed % 16 == 0;
}

/* The greatest number, without its sign, is from 1 to 16. */
static int is_of_one_size(const double v[13]) {
  double size = 0;
  for (int k = 0; k < 13; ++k) {
    const double number = v[k] < 0 ? -v[k] : v[k];
    if (number > size) size = number;
  }
  return size >= 1 && size < 16;
}

static int few_declined(const double v[13]) { return is_among_few(v) ? AXISCERT_UNDECIDED : right(v); }
static int few_invalid(const double v[13]) { return is_among_few(v) ? AXISCERT_INVALID : right(v); }
static int contacts_declined(const double v[13]) {
  return right(v) == AXISCERT_CONTACT ? AXISCERT_UNDECIDED : AXISCERT_SEPARATED;
}
static int separations_declined(const double v[13]) {
  return right(v) == AXISCERT_CONTACT ? AXISCERT_CONTACT : AXISCERT_UNDECIDED;
}
static int other_sizes_declined(const double v[13]) { return is_of_one_size(v) ? right(v) : AXISCERT_UNDECIDED; }
/* Sees no triangle from behind: (p - a).(ab x ac) <= 0 is no contact. */
static int front(const double v[13]) {
  double u[3], w[3], p[3];
  for (int k = 0; k < 3; ++k) {
    u[k] = v[3 + k] - v[k];
    w[k] = v[6 + k] - v[k];
    p[k] = v[9 + k] - v[k];
  }
  const double volume =
      p[0] * (u[1] * w[2] - u[2] * w[1]) + p[1] * (u[2] * w[0] - u[0] * w[2]) + p[2] * (u[0] * w[1] - u[1] * w[0]);
  return volume > 0 ? right(v) : AXISCERT_SEPARATED;
}
/* A skin of 1/16, which float coordinates of usual sizes have without rounding. */
static int thicker(const double v[13]) {
  double grown[13];
  memcpy(grown, v, sizeof grown);
  grown[12] += 0.0625;
  return v[12] < 0 ? right(v) : right(grown);
}
static int contact(const double v[13]) { return (void)v, AXISCERT_CONTACT; }
static int separated(const double v[13]) { return (void)v, AXISCERT_SEPARATED; }
static int no_verdict(const double v[13]) { return (void)v, 77; }

#define RUN(number, answer)                                                                \
  static void run_##answer(const axiscert_batch* batch, const axiscert_answers* answers) { \
    for (size_t i = 0; i < batch->count; ++i) {                                            \
      double v[13];                                                                        \
      for (int k = 0; k < 13; ++k) v[k] = ((const number*)batch->column[k])[i];            \
      answers->verdict[i] = (uint8_t)answer(v);                                            \
    }                                                                                      \
  }
RUN(float, few_declined)
RUN(float, few_invalid)
RUN(float, contacts_declined)
RUN(float, separations_declined)
RUN(float, other_sizes_declined)
RUN(float, front)
RUN(float, thicker)
RUN(float, contact)
RUN(float, separated)
RUN(float, no_verdict)
RUN(float, right)
static int right_too(const double v[13]) { return right(v); }
RUN(double, right_too)

/* No radius in binary32 is that large. */
static const axiscert_limits nothing = {.size = sizeof(axiscert_limits), .least_radius = 1e300};
/* A sixth of the family `far`, and no query of another: of coordinates that are large beside the radius, those of
 * `spans` have a radius that is a multiple of a half. */
static const axiscert_limits far_alone = {.size = sizeof(axiscert_limits),
                                          .least_coordinate = 100,
                                          .greatest_coordinate = 2e6,
                                          .least_area = 1e-3,
                                          .least_radius = 1.01,
                                          .greatest_radius = 1.49};

static const axiscert_limits sixteenth = {.size = sizeof(axiscert_limits), .margin = 0.0625};

enum kind {
  keeps_its_promise,
  declines,
  declines_declared,
  declines_contacts,
  declines_separations,
  answers_invalid,
  answers_77,
  always_contact,
  limited_to_nothing,
  limited_to_far,
  binary64_alone,
  one_size,
  front_alone,
  with_margin,
  kinds
};
#define KERNEL(kind, bits, answer, its_limits, declines_by_promise) \
  KERNEL_OF(kind, bits, answer, its_limits, AXISCERT_BOTH_SIDES, declines_by_promise)
#define KERNEL_OF(kind, bits, answer, its_limits, its_sides, declines_by_promise) \
  [kind] = {.abi = AXISCERT_PLUGIN_ABI,                                           \
            .precision = bits,                                                    \
            .size = sizeof(axiscert_kernel),                                      \
            .name = #kind,                                                        \
            .column_count = 13,                                                   \
            .run = run_##answer,                                                  \
            .source = AXISCERT_SOURCE,                                            \
            .limits = its_limits,                                                 \
            .sides = its_sides,                                                   \
            .may_decline = declines_by_promise}
static const axiscert_kernel kernels[kinds] = {
    KERNEL(keeps_its_promise, 32, right, NULL, 0),
    KERNEL(declines, 32, few_declined, NULL, 0),
    KERNEL(declines_declared, 32, few_declined, NULL, 1),
    KERNEL(declines_contacts, 32, contacts_declined, NULL, 1),
    KERNEL(declines_separations, 32, separations_declined, NULL, 1),
    KERNEL(answers_invalid, 32, few_invalid, NULL, 0),
    KERNEL(answers_77, 32, no_verdict, NULL, 0),
    KERNEL(always_contact, 32, contact, NULL, 0),
    KERNEL(limited_to_nothing, 32, separated, &nothing, 0),
    KERNEL(limited_to_far, 32, right, &far_alone, 0),
    KERNEL(binary64_alone, 64, right_too, NULL, 0),
    KERNEL(one_size, 32, other_sizes_declined, NULL, 1),
    KERNEL_OF(front_alone, 32, front, NULL, AXISCERT_FRONT_ONLY, 0),
    KERNEL(with_margin, 32, thicker, &sixteenth, 0),
};

const axiscert_kernel* axiscert_plugin(uint32_t index) { return index == 0 ? &kernels[KIND] : NULL; }
